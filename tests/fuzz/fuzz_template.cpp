// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes as a template: refused or read; what was read is written and read back to the same
// text.
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "core/tlib/template_io.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const std::string_view text(reinterpret_cast<const char*>(data), size);
    const auto tmpl = ew::readTemplate(text, "fuzz");
    if (!tmpl) return 0;
    const std::string written = ew::writeTemplate(*tmpl);
    const auto again = ew::readTemplate(written, "again");
    if (!again || ew::writeTemplate(*again) != written) std::abort();
    return 0;
}
