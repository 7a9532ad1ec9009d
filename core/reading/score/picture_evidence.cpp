// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reading/score/picture_evidence.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <unordered_map>
#include <vector>

#include "core/reading/evidence/ink_extent.h"
#include "core/reading/evidence/stroke_shares.h"
#include "core/solid/visibility.h"

namespace ew {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

using Line = std::array<Vec2, 2>;

/// Lines, to be asked which are near a place.
class LineGrid {
  public:
    LineGrid(const std::vector<Line>& lines, double nearPx) : lines_(lines), near_(nearPx) {
        cell_ = std::max(16.0, 2.0 * nearPx);
        for (std::size_t i = 0; i < lines.size(); ++i) {
            const Vec2 d = lines[i][1] - lines[i][0];
            const int steps = 1 + static_cast<int>(d.norm() / (0.5 * cell_));
            for (int k = 0; k <= steps; ++k) add(lines[i][0] + d * k / steps, i);
        }
    }

    bool isNear(const Vec2& p) const {
        for (int dx = -1; dx <= 1; ++dx) {
            for (int dy = -1; dy <= 1; ++dy) {
                const auto it = cells_.find(key(column(p.x()) + dx, column(p.y()) + dy));
                if (it == cells_.end()) continue;
                for (const std::size_t i : it->second) {
                    if (distanceToSegment(p, lines_[i][0], lines_[i][1], near_) <= near_) {
                        return true;
                    }
                }
            }
        }
        return false;
    }

  private:
    std::int64_t column(double x) const { return static_cast<std::int64_t>(std::floor(x / cell_)); }
    static std::uint64_t key(std::int64_t x, std::int64_t y) {
        return (static_cast<std::uint64_t>(x) << 32U) ^
               (static_cast<std::uint64_t>(y) & 0xffffffffU);
    }
    void add(const Vec2& p, std::size_t i) {
        auto& list = cells_[key(column(p.x()), column(p.y()))];
        if (list.empty() || list.back() != i) list.push_back(i);
    }

    const std::vector<Line>& lines_;
    double near_;
    double cell_;
    std::unordered_map<std::uint64_t, std::vector<std::size_t>> cells_;
};

}  // namespace

PictureEvidence pictureEvidence(const InkReading& ink, const Solid& solid, const Pose& pose,
                                const OrthographicCamera& camera, double nearPx, double thinPx) {
    PictureEvidence out;
    out.inkPx = inkLengthPx(ink);
    const auto view = SolidView::make(solid, pose, camera);
    if (!view) {
        out.strayPx = out.inkPx;
        return out;
    }
    std::vector<Line> seen, all;
    std::vector<int> edgeOf;
    std::vector<bool> shown(solid.faces().size(), false);
    for (const VisiblePiece& p : view->visiblePieces()) {
        for (const int f : solid.edges()[at(p.edge)].faces) shown[at(f)] = true;
        if (p.point) continue;
        seen.push_back(p.px);
        edgeOf.push_back(p.edge);
    }
    for (const SolidEdge& e : solid.edges()) {
        all.push_back({view->points()[at(e.ends[0])], view->points()[at(e.ends[1])]});
        out.hiddenEdgesPx += (all.back()[1] - all.back()[0]).norm();
    }
    for (const Line& line : seen) out.hiddenEdgesPx -= (line[1] - line[0]).norm();
    for (std::size_t f = 0; f < shown.size(); ++f) {
        const bool front = view->facing(static_cast<int>(f)) == Facing::Front;
        if (front && !shown[f]) ++out.hiddenFronts;
    }
    const LineGrid visible(seen, nearPx);
    const LineGrid any(all, nearPx);
    std::vector<Line> drawn;
    std::map<int, StrokeShare> strokes;
    std::map<int, double> bare;  // by edge
    for (const Segment& s : ink.segments) {
        const double each =
            s.inkPx / static_cast<double>(std::max<std::size_t>(1, s.points.size()));
        for (const Vec2& p : s.points) {
            StrokeShare& stroke = strokes[s.stroke];
            stroke.all += each;
            if (visible.isNear(p)) continue;
            if (any.isNear(p)) {
                out.hiddenPx += each;
                continue;
            }
            stroke.beside += each;
            out.strayPx += each;
            if (view->pick(p)) out.detailPx += each;
        }
        for (std::size_t k = 1; k < s.points.size(); ++k) {
            drawn.push_back({s.points[k - 1], s.points[k]});
        }
    }
    out.beside = strokesLeftOut(strokes, ink.noise);
    const LineGrid inked(drawn, std::max(nearPx, thinPx));
    constexpr double kStepPx = 4.0;
    for (std::size_t i = 0; i < seen.size(); ++i) {
        const Line& line = seen[i];
        const double length = (line[1] - line[0]).norm();
        const int steps = 1 + static_cast<int>(length / kStepPx);
        for (int k = 0; k < steps; ++k) {
            const Vec2 p = line[0] + (line[1] - line[0]) * (k + 0.5) / steps;
            if (inked.isNear(p)) continue;
            out.barePx += length / steps;
            bare[edgeOf[i]] += length / steps;
        }
    }
    for (const auto& [edge, px] : bare) out.slipPx = std::max(out.slipPx, px);
    return out;
}

}  // namespace ew
