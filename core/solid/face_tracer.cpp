// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/solid/face_tracer.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <unordered_map>
#include <unordered_set>

#include "core/base/tolerance.h"
#include "core/solid/brep.h"

namespace ew {
namespace {

std::size_t idx(int i) { return static_cast<std::size_t>(i); }

Unexpected<Error> touchesInEdge() {
    return fail(Errc::TouchesInEdge,
                "The solid would touch itself along an edge only. Make the new part a little "
                "larger or smaller.");
}
Unexpected<Error> touchesInPoint() {
    return fail(Errc::TouchesInPoint,
                "The solid would touch itself in a point only. Make the new part a little larger "
                "or smaller.");
}

struct TracedLoop {
    std::vector<int> points;
    FaceOrigin origin;
};

/// The target's faces come before the tool's.
bool before(const FaceOrigin& a, const FaceOrigin& b) {
    return a.fromTool != b.fromTool ? b.fromTool : a.face < b.face;
}

class Tracer {
  public:
    Tracer(const Overlay& overlay, const Operand& target, const Operand& tool)
        : overlay_(overlay), target_(target), tool_(tool) {}

    Result<std::vector<TracedFace>> run() {
        for (const SideGroup& group : overlay_.groups) {
            loops_.emplace_back();
            const bool closed =
                group.exact ? trace(group, loops_.back()) : trace(joined(group), loops_.back());
            if (!closed) return touchesInEdge();
        }
        dropStraightPoints();
        if (!everyPointIsOneFan()) return touchesInPoint();
        std::vector<TracedFace> faces;
        for (std::size_t g = 0; g < loops_.size(); ++g) {
            const std::size_t first = faces.size();
            nest(overlay_.groups[g], loops_[g], faces);
            for (std::size_t f = first; f < faces.size(); ++f) {
                if (overlay_.groups[g].exact) faces[f].plane = overlay_.groups[g].plane;
            }
            if (touchesInside(overlay_.groups[g], loops_[g], faces, first)) return touchesInPoint();
        }
        for (TracedFace& face : faces) orderLoops(face.loops);
        return faces;
    }

  private:
    PointView point(int i) const { return overlay_.point(i, target_, tool_); }

    // Loops --------------------------------------------------------------------------------------

    /// The plane's axes in which the group's faces run counter-clockwise.
    static std::array<int, 2> axesOf(const SideGroup& group) {
        const int u = (group.plane->axis + 1) % 3;
        const int v = (group.plane->axis + 2) % 3;
        if (group.sign > 0) return {u, v};
        return {v, u};
    }

    /// Sides inside a face that is put together from facets cancel each other.
    static SideGroup joined(const SideGroup& facets) {
        std::set<std::pair<int, int>> all;
        for (const FaceSide& side : facets.sides) all.emplace(side.from, side.to);
        SideGroup group = facets;
        std::erase_if(group.sides, [&](const FaceSide& s) { return all.contains({s.to, s.from}); });
        return group;
    }

    bool trace(const SideGroup& group, std::vector<TracedLoop>& out) const {
        std::unordered_map<int, std::vector<int>> from;
        from.reserve(group.sides.size());
        for (std::size_t s = 0; s < group.sides.size(); ++s) {
            from[group.sides[s].from].push_back(static_cast<int>(s));
        }
        const auto axes = axesOf(group);
        std::vector<bool> seen(group.sides.size(), false);
        for (std::size_t start = 0; start < group.sides.size(); ++start) {
            if (seen[start]) continue;
            TracedLoop loop;
            loop.origin = group.sides[start].origin;
            std::size_t s = start;
            do {
                seen[s] = true;
                const FaceSide& side = group.sides[s];
                loop.points.push_back(side.from);
                if (before(side.origin, loop.origin)) loop.origin = side.origin;
                const auto next = from.find(side.to);
                if (next == from.end()) return false;
                s = idx(tightest(group, side, next->second, axes));
            } while (!seen[s]);
            if (s != start) return false;
            out.push_back(std::move(loop));
        }
        return true;
    }

    /// The side that comes first turning clockwise from the way back: the face's inside is between.
    int tightest(const SideGroup& group, const FaceSide& in, const std::vector<int>& choices,
                 const std::array<int, 2>& axes) const {
        if (choices.size() == 1) return choices[0];
        const PointView at = point(in.to);
        const PointView back = point(in.from);
        const auto turn = [&](const PointView& a, const PointView& b) {
            return orient2(at, a, b, axes[0], axes[1]);
        };
        int best = -1;
        for (const int c : choices) {
            if (best < 0) {
                best = c;
                continue;
            }
            const PointView p = point(group.sides[idx(c)].to);
            const PointView q = point(group.sides[idx(best)].to);
            const bool pEarly = turn(back, p) < 0;
            const bool qEarly = turn(back, q) < 0;
            const bool first = pEarly != qEarly ? pEarly : turn(p, q) < 0;
            if (first) best = c;
        }
        return best;
    }

    // Points -------------------------------------------------------------------------------------

    /// A point with just two edges in a line is no corner. Points where nothing was cut keep
    /// their edges, and not all of those are known here.
    void dropStraightPoints() {
        std::unordered_map<int, std::set<int>> neighbours;
        for (const auto& group : loops_) {
            for (const TracedLoop& loop : group) {
                for (std::size_t k = 0; k < loop.points.size(); ++k) {
                    const int a = loop.points[k];
                    const int b = loop.points[(k + 1) % loop.points.size()];
                    if (isTouched(a)) neighbours[a].insert(b);
                    if (isTouched(b)) neighbours[b].insert(a);
                }
            }
        }
        std::unordered_set<int> straight;
        for (const auto& [p, others] : neighbours) {
            if (others.size() != 2) continue;
            if (collinear(point(*others.begin()), point(p), point(*others.rbegin()))) {
                straight.insert(p);
            }
        }
        if (straight.empty()) return;
        for (auto& group : loops_) {
            for (TracedLoop& loop : group) {
                std::erase_if(loop.points, [&](int p) { return straight.contains(p); });
            }
        }
    }

    bool isTouched(int p) const { return overlay_.touched.contains(p); }

    /// The corners of faces round a point follow one another in one ring.
    bool everyPointIsOneFan() {
        std::unordered_map<int, std::vector<std::array<int, 2>>> corners;  // before, after
        for (const auto& group : loops_) {
            for (const TracedLoop& loop : group) {
                const std::size_t n = loop.points.size();
                for (std::size_t k = 0; k < n; ++k) {
                    const int p = loop.points[k];
                    if (!overlay_.complete.contains(p)) continue;
                    corners[p].push_back({loop.points[(k + n - 1) % n], loop.points[(k + 1) % n]});
                }
            }
        }
        for (const auto& [p, list] : corners) {
            used_.insert(p);
            std::size_t steps = 0;
            int to = list[0][1];
            do {
                const auto next = std::find_if(list.begin(), list.end(),
                                               [&](const auto& c) { return c[0] == to; });
                if (next == list.end()) return false;
                to = (*next)[1];
                ++steps;
            } while (to != list[0][1] && steps <= list.size());
            if (steps != list.size()) return false;
        }
        return true;
    }

    // Faces --------------------------------------------------------------------------------------

    /// Signed area of a loop, in the group's sense; only the sign is exact.
    double areaSign(const SideGroup& group, const std::vector<int>& loop) const {
        const auto [u, v] = axesOf(group);
        const Vec3 o = point(loop[0]).r;
        double area = 0.0;
        double reach = o.cwiseAbs().maxCoeff();
        for (std::size_t k = 0; k < loop.size(); ++k) {
            const Vec3 a = point(loop[k]).r - o;
            const Vec3 b = point(loop[(k + 1) % loop.size()]).r - o;
            area += a[u] * b[v] - a[v] * b[u];
            reach = std::max(reach, a.cwiseAbs().maxCoeff());
        }
        if (std::abs(area) > tol::kOrientError * static_cast<double>(loop.size()) * reach * reach) {
            return area;
        }
        Rational exact = 0;
        for (std::size_t k = 0; k < loop.size(); ++k) {
            const PointView a = point(loop[k]);
            const PointView b = point(loop[(k + 1) % loop.size()]);
            exact += a[u] * b[v] - a[v] * b[u];
        }
        return sgn(exact);
    }

    /// Is the point inside the loop?
    /// \pre it is not on it.
    bool encloses(const SideGroup& group, const std::vector<int>& loop, const PointView& p,
                  bool& onIt) const {
        const auto [u, v] = axesOf(group);
        bool inside = false;
        for (std::size_t k = 0; k < loop.size(); ++k) {
            const PointView a = point(loop[k]);
            const PointView b = point(loop[(k + 1) % loop.size()]);
            const int ca = compare(a, p, v);
            const int cb = compare(b, p, v);
            if (ca == cb && ca != 0) continue;
            const int turn = orient2(a, b, p, u, v);
            if (turn == 0) {
                const int ua = compare(a, p, u);
                const int ub = compare(b, p, u);
                if (ua * ub <= 0) {
                    onIt = true;
                    return false;
                }
                continue;
            }
            if ((ca > 0) == (cb > 0)) continue;
            if (cb > 0 ? turn > 0 : turn < 0) inside = !inside;
        }
        return inside;
    }

    void nest(const SideGroup& group, std::vector<TracedLoop>& loops,
              std::vector<TracedFace>& faces) const {
        const std::size_t first = faces.size();
        std::vector<double> area;
        for (TracedLoop& loop : loops) {
            area.push_back(areaSign(group, loop.points));
            if (area.back() > 0.0) faces.push_back({{loop.points}, loop.origin, nullptr});
        }
        for (std::size_t k = 0; k < loops.size(); ++k) {
            if (area[k] > 0.0) continue;
            std::size_t home = first;
            if (faces.size() > first + 1) home = smallestRound(group, loops[k], faces, first);
            if (home >= faces.size()) continue;
            faces[home].loops.push_back(loops[k].points);
            if (before(loops[k].origin, faces[home].origin)) faces[home].origin = loops[k].origin;
        }
    }

    /// Outlines do not cross, so of two that enclose a hole one encloses the other.
    std::size_t smallestRound(const SideGroup& group, const TracedLoop& hole,
                              const std::vector<TracedFace>& faces, std::size_t first) const {
        std::size_t home = faces.size();
        for (std::size_t f = first; f < faces.size(); ++f) {
            bool onIt = false;
            if (!encloses(group, faces[f].loops[0], point(hole.points[0]), onIt)) continue;
            if (home < faces.size()) {
                const auto& outer = faces[home].loops[0];
                const auto inner = std::find_if(
                    faces[f].loops[0].begin(), faces[f].loops[0].end(),
                    [&](int p) { return std::find(outer.begin(), outer.end(), p) == outer.end(); });
                if (inner == faces[f].loops[0].end()) continue;
                if (!encloses(group, outer, point(*inner), onIt)) continue;
            }
            home = f;
        }
        return home;
    }

    /// A point of another face strictly inside a face of the group.
    bool touchesInside(const SideGroup& group, const std::vector<TracedLoop>& loops,
                       const std::vector<TracedFace>& faces, std::size_t first) const {
        if (!group.exact) return false;
        for (const int c : overlay_.contacts) {
            if (!used_.contains(c) || sideOf(*group.plane, point(c)) != 0) continue;
            bool own = false;
            for (const TracedLoop& loop : loops) {
                own |= std::find(loop.points.begin(), loop.points.end(), c) != loop.points.end();
            }
            if (own) continue;
            for (std::size_t f = first; f < faces.size(); ++f) {
                bool inside = false;
                bool onIt = false;
                for (const auto& loop : faces[f].loops) {
                    inside ^= encloses(group, loop, point(c), onIt);
                }
                if (inside && !onIt) return true;
            }
        }
        return false;
    }

    const Overlay& overlay_;
    const Operand& target_;
    const Operand& tool_;
    std::vector<std::vector<TracedLoop>> loops_;  ///< by group
    std::unordered_set<int> used_;
};

}  // namespace

Result<std::vector<TracedFace>> traceFaces(const Overlay& overlay, const Operand& target,
                                           const Operand& tool) {
    if (overlay.touchesInEdge) return touchesInEdge();
    return Tracer(overlay, target, tool).run();
}

}  // namespace ew
