// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reading/score/ink_shares.h"

#include <algorithm>
#include <map>
#include <set>

#include "core/reading/evidence/stroke_shares.h"
#include "core/reading/extract/plane_geometry.h"
#include "core/reading/types/reading_params.h"

namespace ew {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

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
                                        [&](const auto& face) { return insidePolygon(face, p); });
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

    double nearPx_;
    double pastPx_;
    std::vector<Line> shown_;
    std::vector<Line> hidden_;
    std::vector<std::vector<Vec2>> faces_;
};

/// What the ink of a drawing is, as a whole and by stroke.
struct Shares {
    InkShares drawing;
    std::map<int, StrokeShare> strokes;
};

Shares sharesOf(const InkReading& ink, const Picture& picture) {
    Shares out;
    std::map<int, double> hidden;  // by stroke
    for (const Segment& s : ink.segments) {
        const double each = s.inkPx / static_cast<double>(s.points.size());
        StrokeShare& stroke = out.strokes[s.stroke];
        for (const Vec2& p : s.points) {
            stroke.all += each;
            switch (picture.of(p)) {
                case Place::Edge:
                    out.drawing.edges += each;
                    break;
                case Place::Hidden:
                    out.drawing.hidden += each;
                    hidden[s.stroke] += each;
                    break;
                case Place::Face:
                    out.drawing.detail += each;
                    stroke.beside += each;
                    break;
                case Place::Nowhere:
                    out.drawing.stray += each;
                    stroke.beside += each;
                    break;
            }
        }
    }
    // Who draws hidden lines draws them all.
    if (out.drawing.hidden < params::kHiddenDrawn * picture.hiddenPx()) {
        out.drawing.detail += out.drawing.hidden;
        out.drawing.hidden = 0.0;
        for (const auto& [stroke, length] : hidden) out.strokes[stroke].beside += length;
    }
    return out;
}

}  // namespace

InkShares shareInk(const InkReading& ink, const RatedCandidate& candidate, double nearPx,
                   double pastPx) {
    return sharesOf(ink, Picture(candidate, nearPx, pastPx)).drawing;
}

std::vector<int> strokesBeside(const InkReading& ink, const RatedCandidate& candidate,
                               double nearPx, double pastPx) {
    const Picture picture(candidate, nearPx, pastPx);
    return strokesLeftOut(sharesOf(ink, picture).strokes, ink.noise);
}

}  // namespace ew
