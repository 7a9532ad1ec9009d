// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes as strokes: whatever is drawn, interpret() answers with a candidate or with a reason.
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <vector>

#include "core/modeling/interpretation.h"

namespace {

/// Two bytes a coordinate, 0..1023 in steps of 1/64 px; the value 0xffff lifts the pen.
std::vector<ew::Stroke> strokesOf(const std::uint8_t* data, std::size_t size) {
    std::vector<ew::Stroke> strokes(1);
    for (std::size_t i = 0; i + 4 <= size; i += 4) {
        std::uint16_t xy[2];
        std::memcpy(xy, data + i, sizeof xy);
        if (xy[0] == 0xffff) {
            if (!strokes.back().samples.empty()) strokes.emplace_back();
            continue;
        }
        strokes.back().samples.push_back({ew::Vec2(xy[0] / 64.0, xy[1] / 64.0), 0.5, 0.0});
    }
    if (strokes.back().samples.empty()) strokes.pop_back();
    return strokes;
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    static const ew::TemplateLibrary library = [] {
        const auto load = ew::loadLibrary(EDGEWRIGHT_SOURCE_DIR "/resources/templates");
        if (!load) std::abort();
        return load->library;
    }();
    const ew::Interpretation reading = ew::interpret(strokesOf(data, size), library, {});
    if (!reading.accepted && !reading.problem) std::abort();
    if (reading.accepted && *reading.accepted >= static_cast<int>(reading.candidates.size())) {
        std::abort();
    }
    for (const ew::Candidate& c : reading.candidates) {
        for (const ew::Vec3& v : c.spec.vertices) {
            if (!v.allFinite()) std::abort();
        }
    }
    return 0;
}
