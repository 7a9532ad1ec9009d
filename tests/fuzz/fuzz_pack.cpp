// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes as a template pack: refused or read; what was read is written and read back to the same
// bytes.
#include <cstdint>
#include <cstdlib>
#include <string>

#include "core/document/template_pack.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const auto pack =
        ew::readTemplatePack(std::string(reinterpret_cast<const char*>(data), size), "fuzz");
    if (!pack) return 0;
    const auto written = ew::writeTemplatePack(*pack);
    if (!written) std::abort();
    const auto again = ew::readTemplatePack(*written, "again");
    if (!again || *ew::writeTemplatePack(*again) != *written) std::abort();
    return 0;
}
