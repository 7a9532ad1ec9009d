// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reading/solve/cell_votes.h"

#include <algorithm>
#include <cmath>

#include "core/reading/extract/plane_geometry.h"

namespace ew {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

class Sight {
  public:
    Sight(const CellComplex& complex, const LineDrawing& drawing, const std::vector<int>& planeOf)
        : complex_(complex), drawing_(drawing), planeOf_(planeOf), votes_(at(complex.cellCount())) {
        for (const LineDrawing::Region& r : drawing.regions) {
            polygons_.emplace_back();
            polygons_.back().push_back(drawing.polygon(r.loop));
            for (const auto& hole : r.holes) polygons_.back().push_back(drawing.polygon(hole));
        }
    }

    std::vector<CellVotes> votes(double spread) {
        auto [low, high] = drawing_.bounds();
        const Vec2 margin = kMarginShare * (high - low);
        low -= margin;
        high += margin;
        constexpr double kRays = 4000.0;
        const double step = std::max(3.0, std::sqrt((high - low).x() * (high - low).y() / kRays));
        for (double y = low.y() + 0.5 * step; y < high.y(); y += step) {
            for (double x = low.x() + 0.5 * step; x < high.x(); x += step) {
                const Vec2 p(x, y);
                if (!nearLine(p, spread)) ray(p, step * step);
            }
        }
        askSmallCells(spread, step * step);
        return std::move(votes_);
    }

  private:
    static constexpr double kMarginShare = 0.15;  ///< seen round the drawing

    bool nearLine(const Vec2& p, double near) const {
        for (std::size_t d = 0; d < drawing_.from.size(); d += 2) {
            const Vec2& a = drawing_.nodes[at(drawing_.from[d])].at;
            const Vec2& b = drawing_.nodes[at(drawing_.from[d + 1])].at;
            if (distanceToSegment(p, a, b, near) <= near) return true;
        }
        return false;
    }

    int regionAt(const Vec2& p) const {
        for (std::size_t r = 0; r < polygons_.size(); ++r) {
            // Inside the outline and no hole.
            const auto count = std::count_if(
                polygons_[r].begin(), polygons_[r].end(),
                [&](const std::vector<Vec2>& polygon) { return insidePolygon(polygon, p); });
            if (count == 1 && insidePolygon(polygons_[r].front(), p)) return static_cast<int>(r);
        }
        return -1;
    }

    void ray(const Vec2& p, double weight) {
        const int region = regionAt(p);
        const int seen = region < 0 ? -1 : planeOf_[at(region)];
        std::uint64_t sides = 0;
        std::vector<std::pair<double, int>> crossings;
        for (std::size_t k = 0; k < complex_.planes().size(); ++k) {
            const DrawnPlane& plane = complex_.planes()[k];
            constexpr double kAlong = 1e-9;
            const bool along = std::abs(plane.normal.z()) < kAlong;
            const bool positive =
                along ? plane.normal.head<2>().dot(p) > plane.offset : plane.normal.z() < 0.0;
            if (positive) sides |= std::uint64_t{1} << k;
            if (!along) crossings.emplace_back(plane.depthAt(p), static_cast<int>(k));
        }
        std::sort(crossings.begin(), crossings.end());
        addEmpty(sides, weight);
        for (const auto& [depth, plane] : crossings) {
            sides ^= std::uint64_t{1} << plane;
            const int cell = complex_.cellAt(sides);
            if (plane == seen) {
                if (cell >= 0) votes_[at(cell)].solid += weight;
                return;
            }
            addEmpty(sides, weight);
        }
    }

    /// Cells that no ray met: does the eye see into them, beside or before what is drawn?
    void askSmallCells(double spread, double weight) {
        std::vector<std::vector<int>> corners(votes_.size());
        for (const CellComplex::Facet& f : complex_.facets()) {
            for (const int c : f.cells) {
                if (c < 0) continue;
                corners[at(c)].insert(corners[at(c)].end(), f.loop.begin(), f.loop.end());
            }
        }
        for (std::size_t c = 0; c < votes_.size(); ++c) {
            if (votes_[c].empty > 0.0 || votes_[c].solid > 0.0) continue;
            Vec3 middle = Vec3::Zero();
            for (const int v : corners[c]) {
                middle += complex_.vertices()[at(v)] / static_cast<double>(corners[c].size());
            }
            for (const int v : corners[c]) {
                for (const double share : {0.4, 0.8}) {
                    const Vec3 p = middle + share * (complex_.vertices()[at(v)] - middle);
                    if (!nearLine(p.head<2>(), spread) && isOpen(p)) votes_[c].empty += weight;
                }
            }
        }
    }

    /// Is nothing that is drawn before a point of space?
    bool isOpen(const Vec3& p) const {
        const int region = regionAt(p.head<2>());
        if (region < 0) return true;
        const DrawnPlane& face = complex_.planes()[at(planeOf_[at(region)])];
        return p.z() < face.depthAt(p.head<2>());
    }

    void addEmpty(std::uint64_t sides, double weight) {
        const int cell = complex_.cellAt(sides);
        if (cell >= 0) votes_[at(cell)].empty += weight;
    }

    const CellComplex& complex_;
    const LineDrawing& drawing_;
    const std::vector<int>& planeOf_;
    std::vector<std::vector<std::vector<Vec2>>> polygons_;  ///< per region: outline, then holes
    std::vector<CellVotes> votes_;
};

}  // namespace

std::vector<CellVotes> cellVotes(const CellComplex& complex, const LineDrawing& drawing,
                                 const std::vector<int>& planeOf, double spreadPx) {
    return Sight(complex, drawing, planeOf).votes(spreadPx);
}

}  // namespace ew
