// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes as a stored document: refused or read; what was read is written and read back to the
// same bytes.
#include <cstdint>
#include <cstdlib>
#include <string>

#include "core/document/store.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const ew::TemplateLibrary shipped = [] {
        const auto load = ew::loadLibrary(EDGEWRIGHT_SOURCE_DIR "/resources/templates");
        if (!load) std::abort();
        return load->library;
    }();
    const auto file = ew::readDocument({reinterpret_cast<const char*>(data), size}, shipped);
    if (!file) return 0;
    const auto written = ew::writeDocument(*file);
    if (!written) std::abort();
    const auto again = ew::readDocument(*written, shipped);
    if (!again || *ew::writeDocument(*again) != *written) std::abort();
    return 0;
}
