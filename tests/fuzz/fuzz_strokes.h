// SPDX-License-Identifier: GPL-3.0-or-later
// What the targets that draw have in common: strokes as bytes, and what every reading keeps to.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <string>
#include <vector>

#include "core/reading/types/interpretation.h"
#include "core/tlib/library.h"

namespace ew::fuzz {

inline const TemplateLibrary& shippedTemplates() {
    static const TemplateLibrary shipped = [] {
        const auto load = loadLibrary(EDGEWRIGHT_SOURCE_DIR "/resources/templates");
        if (!load) std::abort();
        return load->library;
    }();
    return shipped;
}

/// The first bytes of an input: how the strokes behind them are read.
struct Head {
    std::uint8_t scene = 0;      ///< of fuzz_modification: what is there already
    std::uint8_t view = 0;       ///< ... and from where it is seen
    std::uint8_t operation = 0;  ///< modulo the number of operations
    std::uint8_t tmpl = 0;       ///< 0: any, else which template, modulo their number
    std::uint8_t distance = 13;  ///< distance threshold - 1 [px], modulo its range
    std::uint8_t angle = 23;     ///< twice the angle threshold, less 1 [degrees], modulo its range
};
inline constexpr std::size_t kHeadBytes = 6;

inline Head headOf(const std::uint8_t* data, std::size_t size) {
    Head h;
    if (size < kHeadBytes) return h;
    return {data[0], data[1], data[2], data[3], data[4], data[5]};
}

inline void readHead(const Head& h, InterpretOptions& options) {
    options.operation = static_cast<Operation>(h.operation % 4);
    const TemplateLibrary& library = shippedTemplates();
    if (h.tmpl > 0) options.templateId = library.at(h.tmpl % library.size()).id;
    options.thresholds = {1.0 + h.distance % 100, 0.5 + 0.5 * (h.angle % 90)};
}

constexpr double kStepsPerPx = 48.0;  // 0..1365 px across
constexpr std::uint16_t kPenUp = 0xffff;

/// Two bytes a coordinate behind the head; the value 0xffff for x lifts the pen.
inline std::vector<Stroke> strokesOf(const std::uint8_t* data, std::size_t size) {
    std::vector<Stroke> strokes(1);
    for (std::size_t i = kHeadBytes; i + 4 <= size; i += 4) {
        std::array<std::uint16_t, 2> xy{};
        std::memcpy(xy.data(), data + i, sizeof xy);
        if (xy[0] == kPenUp) {
            if (!strokes.back().samples.empty()) strokes.emplace_back();
            continue;
        }
        strokes.back().samples.push_back(
            {Vec2(xy[0] / kStepsPerPx, xy[1] / kStepsPerPx), 0.5, 0.0});
    }
    if (strokes.back().samples.empty()) strokes.pop_back();
    return strokes;
}

/// The input that strokesOf reads as these strokes, but for rounding; every `every`th sample and
/// the last one of a stroke.
inline std::string bytesOf(const Head& head, const std::vector<Stroke>& strokes,
                           std::size_t every = 1) {
    std::string out;
    for (const std::uint8_t b :
         {head.scene, head.view, head.operation, head.tmpl, head.distance, head.angle}) {
        out.push_back(static_cast<char>(b));
    }
    const auto put = [&](double x, double y) {
        const auto bits = [](double v) {
            const double steps = std::round(v * kStepsPerPx);
            return static_cast<std::uint16_t>(std::min(std::max(steps, 0.0), kPenUp - 1.0));
        };
        const std::array<std::uint16_t, 2> xy{bits(x), bits(y)};
        out.append(reinterpret_cast<const char*>(xy.data()), sizeof xy);
    };
    for (const Stroke& s : strokes) {
        for (std::size_t i = 0; i < s.samples.size(); ++i) {
            if (i % every != 0 && i + 1 < s.samples.size()) continue;
            put(s.samples[i].position.x(), s.samples[i].position.y());
        }
        out.append("\xff\xff\xff\xff", 4);
    }
    return out;
}

/// A candidate that can be taken, or a reason with a sentence; a library never fails; the solids
/// are solids.
inline void checkReading(const Interpretation& reading, std::size_t bodies) {
    const auto demand = [](bool kept) {
        if (!kept) std::abort();
    };
    demand(reading.accepted.has_value() != reading.problem.has_value());
    if (reading.problem) {
        demand(reading.problem->code != Errc::Internal && !reading.problem->message.empty());
    }
    demand(!reading.accepted || (*reading.accepted >= 0 &&
                                 *reading.accepted < static_cast<int>(reading.candidates.size())));
    for (const Candidate& c : reading.candidates) {
        for (const Vec3& v : c.spec.vertices) demand(v.allFinite());
        demand(c.pose.rotation.allFinite() && c.pose.translation.allFinite());
        demand(c.score >= 0.0 && c.score <= 1.0 && std::isfinite(c.residualPx));
        const bool modifies = c.operation == Operation::Add || c.operation == Operation::Cut;
        demand(!modifies || (c.body >= 0 && c.body < static_cast<int>(bodies)));
        if (c.result) demand(c.result->volume() > 0.0);
    }
    if (!reading.accepted) return;
    const Candidate& taken = reading.candidates[static_cast<std::size_t>(*reading.accepted)];
    const bool modifies = taken.operation == Operation::Add || taken.operation == Operation::Cut;
    demand(!modifies || taken.result.has_value());
    if (taken.result) demand(Solid::deserialize(taken.result->serialize()).has_value());
}

}  // namespace ew::fuzz
