// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reading/overlay/outline_reading.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <set>

#include "core/base/tolerance.h"
#include "core/reading/evidence/sighting.h"
#include "core/reading/overlay/ink_frames.h"
#include "core/reading/solve/rectilinear_fit.h"

namespace ew {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// A point of ink and how the pen went there.
struct InkPoint {
    Vec2 position;
    Vec2 direction;  ///< unit, without sense
    int stroke;
};

std::vector<InkPoint> inkPoints(const InkReading& ink) {
    constexpr std::size_t kBeside = 2;
    std::vector<InkPoint> points;
    for (const Segment& s : ink.segments) {
        const std::size_t n = s.points.size();
        for (std::size_t i = 0; i < n; ++i) {
            const Vec2 d =
                s.points[std::min(n - 1, i + kBeside)] - s.points[i - std::min(i, kBeside)];
            const Vec2 along = d.norm() > 1e-9 ? d : Vec2(s.b - s.a);
            points.push_back({s.points[i], along.normalized(), s.stroke});
        }
    }
    return points;
}

/// Convex hull, clockwise on the screen (y down): indices of its corners.
std::vector<int> convexHull(const std::vector<Vec2>& points) {
    std::vector<int> order(points.size());
    std::iota(order.begin(), order.end(), 0);
    std::sort(order.begin(), order.end(), [&](int i, int j) {
        const Vec2& a = points[at(i)];
        const Vec2& b = points[at(j)];
        return a.x() != b.x() ? a.x() < b.x() : a.y() < b.y();
    });
    std::vector<int> hull;
    for (int side = 0; side < 2; ++side) {
        const std::size_t start = hull.size();
        for (const int q : order) {
            while (hull.size() >= start + 2) {
                const Vec2& last = points[at(hull.back())];
                const Vec2& before = points[at(hull[hull.size() - 2])];
                if (cross2(last - before, points[at(q)] - last) > 0) break;
                hull.pop_back();
            }
            hull.push_back(q);
        }
        hull.pop_back();
        std::reverse(order.begin(), order.end());
    }
    return hull;
}

/// Takes the corners out that matter least until n are left.
void simplify(std::vector<Vec2>& polygon, std::size_t n) {
    const auto area = [&](std::size_t i) {
        const std::size_t m = polygon.size();
        const Vec2& a = polygon[(i + m - 1) % m];
        return std::abs(cross2(polygon[i] - a, polygon[(i + 1) % m] - a));
    };
    while (polygon.size() > n) {
        std::size_t least = 0;
        for (std::size_t i = 1; i < polygon.size(); ++i) {
            if (area(i) < area(least)) least = i;
        }
        polygon.erase(polygon.begin() + static_cast<std::ptrdiff_t>(least));
    }
}

/// One aspect laid over the ink.
class Laying {
  public:
    Laying(const std::vector<InkPoint>& ink, const std::shared_ptr<const LibraryEntry>& entry,
           const Aspect& aspect, const OutlineOptions& options)
        : ink_(ink), entry_(entry), aspect_(aspect), options_(options) {}

    struct Result {
        OutlineReading reading;
        double cost = 0.0;  ///< mean squared distance and bare length, to choose between layings
    };

    /// \param hull    corners of the convex hull of the ink.
    /// \param frames  see inkFrames().
    std::vector<Result> run(const std::vector<Vec2>& hull, const std::vector<InkFrame>& frames) {
        std::vector<Result> found;
        layOnCorners(hull, found);
        layInFrames(frames, found);
        std::stable_sort(found.begin(), found.end(),
                         [](const Result& a, const Result& b) { return a.cost < b.cost; });
        if (found.size() > kMostAnAspect) found.resize(kMostAnAspect);
        return found;
    }

  private:
    /// Outline vertices on the corners of the ink, in turn.
    void layOnCorners(const std::vector<Vec2>& hull, std::vector<Result>& found) {
        const std::vector<int> outline = convexHull(aspect_.graph.points);
        if (outline.size() < 3 || hull.size() < outline.size()) return;
        std::vector<Vec2> corners = hull;
        simplify(corners, outline.size());
        std::set<std::vector<int>> known;
        const std::size_t n = outline.size();
        for (const bool mirrored : {false, true}) {
            for (std::size_t turn = 0; turn < n; ++turn) {
                std::vector<int> onCorner(n);
                for (std::size_t i = 0; i < n; ++i) {
                    const std::size_t k = mirrored ? (turn + n - i) % n : (turn + i) % n;
                    onCorner[i] = outline[k];
                }
                if (!known.insert(orbit(onCorner)).second) continue;
                GraphMatch match = blankMatch(mirrored);
                if (!start(onCorner, corners, match)) continue;
                if (auto r = lay(std::move(match), spanOf(corners))) found.push_back(std::move(*r));
            }
        }
    }

    /// A rectilinear template fills the frame, its axes along the frame's in every way.
    void layInFrames(const std::vector<InkFrame>& frames, std::vector<Result>& found) {
        if (!entry_->analysis.rectilinear) return;
        const std::vector<int> outline = convexHull(aspect_.graph.points);
        const std::set<int> outer(outline.begin(), outline.end());
        std::set<std::vector<int>> known;
        for (const InkFrame& frame : frames) {
            std::array<std::size_t, 3> order{0, 1, 2};
            do {
                for (unsigned signs = 0; signs < 8; ++signs) {
                    fill(frame, order, signs);
                    const std::vector<int> hull = convexHull(place_);
                    if (!aspect_.edgeOn && std::set<int>(hull.begin(), hull.end()) != outer)
                        continue;
                    if (!known.insert(picture()).second) continue;
                    const bool mirrored =
                        turnOf(outline, aspect_.graph.points) * turnOf(outline, place_) < 0.0;
                    if (auto r = lay(blankMatch(mirrored), frame.sizePx)) {
                        found.push_back(std::move(*r));
                    }
                }
            } while (std::next_permutation(order.begin(), order.end()));
        }
    }

    void fill(const InkFrame& frame, const std::array<std::size_t, 3>& order, unsigned signs) {
        const RectilinearStructure& r = *entry_->analysis.rectilinear;
        place_.assign(aspect_.vertex.size(), frame.center);
        for (std::size_t axis = 0; axis < 3; ++axis) {
            const auto [low, high] =
                std::minmax_element(r.reference[axis].begin(), r.reference[axis].end());
            for (std::size_t v = 0; v < place_.size(); ++v) {
                const int plane = r.planes[axis][at(aspect_.vertex[v])];
                const double share = (r.reference[axis][at(plane)] - *low) / (*high - *low) - 0.5;
                const double sense = (signs >> axis & 1U) != 0U ? -1.0 : 1.0;
                place_[v] += sense * share * frame.axes[order[axis]];
            }
        }
    }

    /// What place_ draws, whatever its vertices are called.
    std::vector<int> picture() const {
        std::vector<std::array<int, 4>> edges;
        for (const auto& e : aspect_.graph.edges) {
            std::array<Vec2, 2> p{place_[at(e[0])], place_[at(e[1])]};
            if (std::make_pair(p[1].x(), p[1].y()) < std::make_pair(p[0].x(), p[0].y())) {
                std::swap(p[0], p[1]);
            }
            std::array<int, 4> key{};
            for (std::size_t i = 0; i < 4; ++i) {
                key[i] = static_cast<int>(std::lround(p[i / 2](static_cast<Eigen::Index>(i % 2))));
            }
            edges.push_back(key);
        }
        std::sort(edges.begin(), edges.end());
        std::vector<int> out;
        for (const auto& e : edges) out.insert(out.end(), e.begin(), e.end());
        return out;
    }

    /// Twice the signed area of a polygon of some of these points.
    static double turnOf(const std::vector<int>& corners, const std::vector<Vec2>& points) {
        double area = 0;
        for (std::size_t i = 0; i < corners.size(); ++i) {
            area += cross2(points[at(corners[i])], points[at(corners[(i + 1) % corners.size()])]);
        }
        return area;
    }

    GraphMatch blankMatch(bool mirrored) const {
        GraphMatch m;
        m.entry = entry_;
        m.aspect = std::shared_ptr<const Aspect>(entry_, &aspect_);
        m.mirrored = mirrored;
        m.vertex = aspect_.vertex;
        m.edge = aspect_.edge;
        return m;
    }

    static double spanOf(const std::vector<Vec2>& points) {
        Eigen::AlignedBox2d box;
        for (const Vec2& p : points) box.extend(p);
        return box.diagonal().norm();
    }

    /// The least image, under the template's symmetries, of the template vertices on the corners
    /// and inside.
    std::vector<int> orbit(std::vector<int> onCorner) const {
        const std::vector<int> corners = onCorner;
        for (int v = 0; v < static_cast<int>(aspect_.vertex.size()); ++v) {
            if (std::find(corners.begin(), corners.end(), v) == corners.end()) {
                onCorner.push_back(v);
            }
        }
        std::vector<int> best;
        for (const auto& map : entry_->symmetries) {
            std::vector<int> image;
            for (const int v : onCorner) image.push_back(map[at(aspect_.vertex[at(v)])]);
            if (best.empty() || image < best) best = std::move(image);
        }
        return best;
    }

    /// From a first guess in place_.
    std::optional<Result> lay(GraphMatch match, double size) {
        Result out;
        out.reading.match = std::move(match);
        GraphMatch& m = out.reading.match;
        for (int round = 0; round < kRounds; ++round) {
            // The first guess may be far off; what is near it tells a better one.
            const double far = kFirstReach * size * (kRounds - 1 - round) / (kRounds - 1);
            reachPx_ = std::max(options_.distancePx, far);
            if (!assign()) return std::nullopt;
            out.reading.graph = fitted(out.reading.barePx);
            if (mostlyBare_ && round + 1 == kRounds) return std::nullopt;
            settleJunctions(out.reading.graph, options_.distancePx);
            for (std::size_t v = 0; v < place_.size(); ++v) {
                place_[v] = out.reading.graph.junctions[v].position;
            }
            if (round + 1 < kRounds) regularise(out.reading.graph, m);
        }
        for (const Vec2& p : place_) {
            if (!p.allFinite()) return std::nullopt;
        }
        out.reading.widestGapPx = widestGapPx_;
        measureMatch(m, out.reading.graph, options_.excusePx);
        out.cost = misses_ + tol::kExtraEdgeCost * out.reading.barePx / options_.distancePx;
        return out;
    }

    /// Where every vertex is at first: outline vertices on the corners of the ink, the others where
    /// the template's regularity or its picture puts them.
    bool start(const std::vector<int>& onCorner, const std::vector<Vec2>& corners,
               const GraphMatch& m) {
        place_.assign(aspect_.graph.points.size(), Vec2::Zero());
        std::vector<bool> known(place_.size(), false);
        for (std::size_t i = 0; i < onCorner.size(); ++i) {
            place_[at(onCorner[i])] = corners[i];
            known[at(onCorner[i])] = true;
        }
        if (std::find(known.begin(), known.end(), false) == known.end()) return true;
        if (entry_->analysis.rectilinear) {
            EdgeGraph graph;
            GraphMatch part = m;
            part.vertex.clear();
            part.edge.clear();
            std::vector<int> number(place_.size(), -1);
            for (std::size_t v = 0; v < place_.size(); ++v) {
                if (!known[v]) continue;
                number[v] = static_cast<int>(graph.junctions.size());
                graph.junctions.push_back({place_[v]});
                part.vertex.push_back(m.vertex[v]);
            }
            for (std::size_t e = 0; e < aspect_.graph.edges.size(); ++e) {
                const auto& ends = aspect_.graph.edges[e];
                if (number[at(ends[0])] < 0 || number[at(ends[1])] < 0) continue;
                GraphEdge edge;
                edge.ends = {number[at(ends[0])], number[at(ends[1])]};
                edge.tips = {place_[at(ends[0])], place_[at(ends[1])]};
                graph.edges.push_back(edge);
                part.edge.push_back(m.edge[e]);
            }
            return regularise(graph, part);
        }
        Eigen::MatrixXd from(static_cast<Eigen::Index>(onCorner.size()), 3);
        Eigen::MatrixXd to(from.rows(), 2);
        for (std::size_t i = 0; i < onCorner.size(); ++i) {
            const auto row = static_cast<Eigen::Index>(i);
            from.row(row) << aspect_.graph.points[at(onCorner[i])].transpose(), 1.0;
            to.row(row) = corners[i].transpose();
        }
        const Eigen::MatrixXd map = from.colPivHouseholderQr().solve(to);
        for (std::size_t v = 0; v < place_.size(); ++v) {
            if (known[v]) continue;
            const Eigen::RowVector3d p(aspect_.graph.points[v].x(), aspect_.graph.points[v].y(),
                                       1.0);
            place_[v] = (p * map).transpose();
        }
        return true;
    }

    /// Moves the vertices to the nearest picture of the template, where that is in closed form.
    bool regularise(const EdgeGraph& graph, const GraphMatch& m) {
        if (!entry_->analysis.rectilinear) return true;
        const auto picture = fitAffine(sightingOf(graph, m, options_.distancePx), entry_->analysis);
        if (!picture) return false;
        for (std::size_t v = 0; v < place_.size(); ++v) {
            place_[v] = picture->at(*entry_->analysis.rectilinear, at(aspect_.vertex[v]));
            if (!place_[v].allFinite()) return false;
        }
        return true;
    }

    /// Gives every point of ink to the edge that it runs beside; false where an edge goes without.
    bool assign() {
        const std::size_t n = aspect_.graph.edges.size();
        taken_.assign(n, {});
        misses_ = 0;
        for (const InkPoint& p : ink_) {
            std::size_t best = n;
            double least = reachPx_;
            for (std::size_t e = 0; e < n; ++e) {
                const Vec2& a = place_[at(aspect_.graph.edges[e][0])];
                const Vec2& b = place_[at(aspect_.graph.edges[e][1])];
                const double sine = std::abs(cross2(p.direction, (b - a).normalized()));
                if (sine > kMostTurnSine) continue;
                // Where two edges are as near, direction decides.
                const double d = distanceToSegment(p.position, a, b) + kTurnPx * sine * reachPx_;
                if (d < least) {
                    least = d;
                    best = e;
                }
            }
            if (best == n) continue;
            taken_[best].push_back(&p);
            misses_ += least * least;
        }
        misses_ /= static_cast<double>(std::max<std::size_t>(1, ink_.size()));
        return std::all_of(taken_.begin(), taken_.end(),
                           [](const auto& points) { return points.size() >= 2; });
    }

    EdgeGraph fitted(double& barePx) {
        EdgeGraph graph;
        barePx = 0;
        widestGapPx_ = 0;
        mostlyBare_ = false;
        for (const Vec2& p : place_) graph.junctions.push_back({p});
        for (std::size_t e = 0; e < taken_.size(); ++e) {
            const auto& ends = aspect_.graph.edges[e];
            const Vec2& a = place_[at(ends[0])];
            const Vec2& b = place_[at(ends[1])];
            InkLine line;
            std::set<int> strokes;
            for (const InkPoint* p : taken_[e]) {
                line.points.push_back(p->position);
                strokes.insert(p->stroke);
            }
            line.strokes.assign(strokes.begin(), strokes.end());
            const Vec2 u = (b - a).normalized();
            const auto along = [&](const Vec2& p) { return (p - a).dot(u); };
            const auto [first, last] = std::minmax_element(
                line.points.begin(), line.points.end(),
                [&](const Vec2& p, const Vec2& q) { return along(p) < along(q); });
            line.a = *first;
            line.b = *last;
            line.inkPx = line.length();
            const auto [open, gap] = bare(line.points, a, b);
            widestGapPx_ = std::max(widestGapPx_, gap);
            barePx += std::max(0.0, open - options_.distancePx);
            mostlyBare_ = mostlyBare_ || open > kMostBare * (b - a).norm();
            GraphEdge edge = fitEdge(a, b, {{0, 0.0, line.length()}}, {line});
            edge.ends = ends;
            edge.wobblePx = std::min(edge.wobblePx, wobbleOfStrokes(taken_[e]));
            graph.edges.push_back(std::move(edge));
        }
        return graph;
    }

    /// How much the strokes stray from lines of their own, rms: strokes beside each other retrace
    /// one edge as well as this hand can, and are not bent.
    static double wobbleOfStrokes(const std::vector<const InkPoint*>& ink) {
        double squares = 0;
        std::vector<Vec2> run;
        for (std::size_t i = 0; i < ink.size(); ++i) {
            run.push_back(ink[i]->position);
            if (i + 1 < ink.size() && ink[i + 1]->stroke == ink[i]->stroke) continue;
            const double rms = fitLine(run).rmsPx;
            squares += rms * rms * static_cast<double>(run.size());
            run.clear();
        }
        return std::sqrt(squares / static_cast<double>(std::max<std::size_t>(1, ink.size())));
    }

    /// Length of an edge that no point of its ink is near, and of the longest stretch of that.
    static std::array<double, 2> bare(const std::vector<Vec2>& ink, const Vec2& a, const Vec2& b) {
        constexpr double kCellPx = 4.0;
        const double len = (b - a).norm();
        const auto cells = static_cast<std::size_t>(std::ceil(len / kCellPx));
        std::vector<bool> covered(cells, false);
        for (const Vec2& p : ink) {
            const double t = (p - a).dot(b - a) / std::max(len, 1e-9) / kCellPx;
            for (const double near : {t - 0.7, t, t + 0.7}) {
                if (near >= 0 && near < static_cast<double>(cells)) {
                    covered[static_cast<std::size_t>(near)] = true;
                }
            }
        }
        const double cell = len / static_cast<double>(std::max<std::size_t>(1, cells));
        const auto open = static_cast<double>(std::count(covered.begin(), covered.end(), false));
        return {cell * open, widestGap(ink, a, b)};
    }

    /// The longest stretch of a line without ink, its ends included.
    static double widestGap(const std::vector<Vec2>& ink, const Vec2& a, const Vec2& b) {
        const double len = (b - a).norm();
        const Vec2 u = (b - a) / std::max(len, 1e-9);
        std::vector<double> at{0.0, len};
        for (const Vec2& p : ink) at.push_back(std::clamp((p - a).dot(u), 0.0, len));
        std::sort(at.begin(), at.end());
        double widest = 0;
        for (std::size_t i = 1; i < at.size(); ++i) widest = std::max(widest, at[i] - at[i - 1]);
        return widest;
    }

    static constexpr std::size_t kMostAnAspect = 2;
    static constexpr int kRounds = 6;
    static constexpr double kFirstReach = 0.1;  ///< of the drawing's size
    static constexpr double kMostBare = 0.6;    ///< of an edge
    static constexpr double kMostTurnSine = 0.6;
    static constexpr double kTurnPx =
        0.5;  ///< a right angle counts like this [distance thresholds]

    const std::vector<InkPoint>& ink_;
    const std::shared_ptr<const LibraryEntry>& entry_;
    const Aspect& aspect_;
    const OutlineOptions& options_;
    std::vector<Vec2> place_;                          ///< per vertex of the aspect
    std::vector<std::vector<const InkPoint*>> taken_;  ///< per edge of the aspect
    double misses_ = 0.0;
    double reachPx_ = 0.0;  ///< ink is looked for so far from an edge
    double widestGapPx_ = 0.0;
    bool mostlyBare_ = false;  ///< some edge has hardly any ink
};

}  // namespace

std::vector<OutlineReading> readingsByOutline(const InkReading& ink,
                                              const std::shared_ptr<const LibraryEntry>& entry,
                                              const OutlineOptions& options) {
    std::vector<OutlineReading> out;
    if (!entry->analysis.convex && !entry->analysis.rectilinear) return out;
    const std::vector<InkPoint> points = inkPoints(ink);
    if (points.size() < 8) return out;
    std::vector<Vec2> places;
    for (const InkPoint& p : points) places.push_back(p.position);
    std::vector<Vec2> hull;
    for (const int i : convexHull(places)) hull.push_back(places[at(i)]);
    const std::vector<InkFrame> frames =
        options.frames ? inkFrames(ink, hull) : std::vector<InkFrame>{};
    for (const Aspect& aspect : entry->aspects) {
        if (aspect.kind != AspectKind::Explicit ||
            std::find(aspect.vertex.begin(), aspect.vertex.end(), -1) != aspect.vertex.end()) {
            continue;
        }
        for (auto& r : Laying(points, entry, aspect, options).run(hull, frames)) {
            out.push_back(std::move(r.reading));
        }
    }
    return out;
}

}  // namespace ew
