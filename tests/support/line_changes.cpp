// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/line_changes.h"

#include <algorithm>

namespace ew::test {
std::vector<Line2> linesInPerspective(const SketchCase& sketch, double eyeWidths) {
    Eigen::AlignedBox2d box;
    for (const Line2& line : sketch.drawing.lines()) {
        box.extend(line[0]);
        box.extend(line[1]);
    }
    Vec3 middle = Vec3::Zero();
    for (const Vec3& v : sketch.spec.vertices) middle += v;
    middle /= static_cast<double>(sketch.spec.vertices.size());
    const double middlePx = sketch.camera.depthPx(middle);
    const double eyePx = eyeWidths * box.sizes().maxCoeff();
    const Vec2 center = box.center();
    const auto seen = [&](int vertex) {
        const Vec3& v = sketch.spec.vertices[static_cast<std::size_t>(vertex)];
        const double scale = 1.0 + (sketch.camera.depthPx(v) - middlePx) / eyePx;
        return Vec2(center + (sketch.camera.project(v) - center) / scale);
    };
    std::vector<Line2> lines;
    for (const VisibleEdge& e : sketch.drawing.edges) {
        lines.push_back({seen(e.vertices[0]), seen(e.vertices[1])});
    }
    return lines;
}

std::vector<Line2> withMovedCorners(std::vector<Line2> lines, double spreadPx, Random& random) {
    constexpr double kSamePx = 1e-6;
    std::vector<std::pair<Vec2, Vec2>> corners;  // from, to
    for (Line2& line : lines) {
        for (Vec2& end : line) {
            const auto known = std::find_if(corners.begin(), corners.end(), [&](const auto& c) {
                return (c.first - end).norm() < kSamePx;
            });
            if (known != corners.end()) {
                end = known->second;
                continue;
            }
            const Vec2 off(random.normal(), random.normal());
            corners.emplace_back(end, end + spreadPx * off);
            end = corners.back().second;
        }
    }
    return lines;
}

std::vector<Stroke> ruledStrokes(const std::vector<Line2>& lines) {
    std::vector<Stroke> strokes;
    for (const Line2& line : lines) {
        strokes.emplace_back();
        for (const Vec2& end : line) strokes.back().samples.push_back({end, 1.0, 0.0});
    }
    return strokes;
}

}  // namespace ew::test
