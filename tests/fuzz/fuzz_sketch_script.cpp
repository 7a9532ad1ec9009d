// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes as a sketch script: refused or read; what was read is written and read back to the same
// text.
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "core/document/sketch_script.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    const auto script = ew::readSketchScript({reinterpret_cast<const char*>(data), size});
    if (!script) return 0;
    const std::string written = ew::writeSketchScript(*script);
    const auto again = ew::readSketchScript(written);
    if (!again || ew::writeSketchScript(*again) != written) std::abort();
    return 0;
}
