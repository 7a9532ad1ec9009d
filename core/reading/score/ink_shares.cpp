// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reading/score/ink_shares.h"

#include <algorithm>
#include <map>
#include <set>

namespace ew {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// So much of the hidden edges has ink where somebody draws hidden lines; dashes leave gaps.
constexpr double kDrawnShare = 0.4;

enum class Place { Edge, Hidden, Face, Nowhere };

/// The picture of a candidate, to be asked where a point of ink lies.
class Picture {
  public:
    Picture(const RatedCandidate& c, double nearPx, double pastPx)
        : nearPx_(nearPx), pastPx_(pastPx) {
        const std::set<int> shown(c.match.edge.begin(), c.match.edge.end());
        const auto& edges = c.entry->analysis.edges;
        for (std::size_t e = 0; e < edges.size(); ++e) {
            const Line line{c.drawn[at(edges[e].ends[0])].head<2>(),
                            c.drawn[at(edges[e].ends[1])].head<2>()};
            (shown.contains(static_cast<int>(e)) ? shown_ : hidden_).push_back(line);
        }
        for (const int f : c.match.aspect->visibleFaces) {
            faces_.emplace_back();
            for (const int v : c.entry->tmpl.shape.faces[at(f)]) {
                faces_.back().push_back(c.drawn[at(v)].head<2>());
            }
        }
    }

    Place of(const Vec2& p) const {
        if (along(shown_, p)) return Place::Edge;
        if (along(hidden_, p)) return Place::Hidden;
        const bool inside = std::any_of(faces_.begin(), faces_.end(),
                                        [&](const auto& face) { return holds(face, p); });
        return inside ? Place::Face : Place::Nowhere;
    }

    /// Length of all hidden edges.
    double hiddenPx() const {
        double sum = 0;
        for (const Line& line : hidden_) sum += (line[1] - line[0]).norm();
        return sum;
    }

  private:
    using Line = std::array<Vec2, 2>;

    /// Overshoot is no other line.
    bool along(const std::vector<Line>& lines, const Vec2& p) const {
        return std::any_of(lines.begin(), lines.end(), [&](const Line& line) {
            return distanceToSegment(p, line[0], line[1], pastPx_) <= nearPx_;
        });
    }

    static bool holds(const std::vector<Vec2>& face, const Vec2& p) {
        bool inside = false;
        for (std::size_t i = 0, j = face.size() - 1; i < face.size(); j = i++) {
            const Vec2& a = face[i];
            const Vec2& b = face[j];
            if ((a.y() > p.y()) == (b.y() > p.y())) continue;
            if (p.x() < a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x())) {
                inside = !inside;
            }
        }
        return inside;
    }

    double nearPx_;
    double pastPx_;
    std::vector<Line> shown_;
    std::vector<Line> hidden_;
    std::vector<std::vector<Vec2>> faces_;
};

}  // namespace

InkShares shareInk(const InkReading& ink, const RatedCandidate& candidate, double nearPx,
                   double pastPx) {
    const Picture picture(candidate, nearPx, pastPx);
    InkShares shares;
    for (const Segment& s : ink.segments) {
        const double each = s.inkPx / static_cast<double>(s.points.size());
        for (const Vec2& p : s.points) {
            switch (picture.of(p)) {
                case Place::Edge:
                    shares.edges += each;
                    break;
                case Place::Hidden:
                    shares.hidden += each;
                    break;
                case Place::Face:
                    shares.detail += each;
                    break;
                case Place::Nowhere:
                    shares.stray += each;
                    break;
            }
        }
    }
    // Who draws hidden lines draws them all.
    if (shares.hidden < kDrawnShare * picture.hiddenPx()) {
        shares.detail += shares.hidden;
        shares.hidden = 0.0;
    }
    return shares;
}

std::vector<int> strokesBeside(const InkReading& ink, const RatedCandidate& candidate,
                               double nearPx, double pastPx) {
    const Picture picture(candidate, nearPx, pastPx);
    const bool hiddenDrawn = shareInk(ink, candidate, nearPx, pastPx).hidden > 0.0;
    std::map<int, std::array<double, 2>> lengths;  // stroke: along edges, in all
    for (const Segment& s : ink.segments) {
        const double each = s.inkPx / static_cast<double>(s.points.size());
        for (const Vec2& p : s.points) {
            const Place place = picture.of(p);
            auto& [along, all] = lengths[s.stroke];
            all += each;
            const bool drawn = place == Place::Edge || (place == Place::Hidden && hiddenDrawn);
            if (drawn) along += each;
        }
    }
    std::set<int> beside;
    for (const auto& [stroke, length] : lengths) {
        if (length[0] < 0.5 * length[1]) beside.insert(stroke);
    }
    for (const NoiseItem& n : ink.noise) beside.insert(n.stroke);
    return {beside.begin(), beside.end()};
}

}  // namespace ew
