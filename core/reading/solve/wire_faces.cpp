// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reading/solve/wire_faces.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <optional>
#include <set>

#include "core/base/disjoint_sets.h"
#include "core/edge_graph/faces.h"
#include "core/reading/extract/plane_geometry.h"

namespace ew {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// Corners in one plane.
struct WirePlane {
    Vec3 normal = Vec3::Zero();
    std::set<int> corners;
};

/// Planes that may hold faces.
class Planes {
  public:
    Planes(const LineDrawing& wires, const AxisFrame& frame, const WireLift& lift, double spread)
        : wires_(wires), frame_(frame), lift_(lift), near_(kNear * spread) {}

    std::vector<WirePlane> all() {
        for (int k = 0; k < 3; ++k) {
            std::map<int, std::set<int>> corners;
            for (std::size_t v = 0; v < wires_.nodes.size(); ++v) {
                if (wires_.nodes[v].out.empty()) continue;
                corners[lift_.planes[at(k)][v]].insert(static_cast<int>(v));
            }
            for (auto& [plane, members] : corners) {
                add({frame_.axes.col(k), std::move(members)});
            }
        }
        for (const LineDrawing::Node& node : wires_.nodes) {
            for (std::size_t i = 0; i < node.out.size(); ++i) {
                for (std::size_t j = i + 1; j < node.out.size(); ++j) {
                    slanted(node.out[i], node.out[j]);
                }
            }
        }
        return std::move(planes_);
    }

  private:
    static constexpr double kNear = 4.0;  ///< corners so near a plane lie in it [spreads]

    const Vec3& point(int v) const { return lift_.points[at(v)]; }

    /// The plane of two lines that meet, unless it is one across an axis.
    void slanted(int d, int e) {
        if (frame_.axisOf[at(d / 2)] >= 0 && frame_.axisOf[at(e / 2)] >= 0) return;
        const int v = wires_.from[at(d)];
        const Vec3 a = point(wires_.to(d)) - point(v);
        const Vec3 b = point(wires_.to(e)) - point(v);
        const Vec3 normal = a.cross(b);
        constexpr double kParallel = 0.05;  // sine
        if (normal.norm() < kParallel * a.norm() * b.norm()) return;
        const std::array<int, 3> spanning{v, wires_.to(d), wires_.to(e)};
        for (const WirePlane& p : planes_) {
            if (std::all_of(spanning.begin(), spanning.end(),
                            [&](int c) { return p.corners.contains(c); })) {
                return;
            }
        }
        WirePlane plane;
        plane.normal = normal.normalized();
        const double reach = std::max(a.norm(), b.norm());
        for (std::size_t c = 0; c < wires_.nodes.size(); ++c) {
            if (wires_.nodes[c].out.empty()) continue;
            // Far from the lines that span it a plane is less certain.
            const Vec3 to = lift_.points[c] - point(v);
            const double near = near_ * std::max(1.0, to.norm() / reach);
            if (std::abs(to.dot(plane.normal)) < near) plane.corners.insert(static_cast<int>(c));
        }
        plane.corners.insert(spanning.begin(), spanning.end());
        add(std::move(plane));
    }

    void add(WirePlane plane) {
        if (plane.corners.size() >= 3) planes_.push_back(std::move(plane));
    }

    const LineDrawing& wires_;
    const AxisFrame& frame_;
    const WireLift& lift_;
    double near_;
    std::vector<WirePlane> planes_;
};

/// A region of a plane between wires. Loops of directed edges.
struct Panel {
    int plane = -1;
    std::vector<std::vector<int>> loops;
};

/// The regions that the wires in a plane bound.
class Panels {
  public:
    Panels(const LineDrawing& wires, const WireLift& lift) : wires_(wires), lift_(lift) {}

    void add(const WirePlane& plane, int number, std::vector<Panel>& out) {
        begin(plane);
        const RotationSystem rotation = rotationOf(flat_);
        DisjointSets part(flat_.points.size());
        for (const auto& e : flat_.edges) part.join(e[0], e[1]);
        std::vector<std::size_t> own;
        const std::vector<PlaneFace> faces = facesOf(flat_, rotation);
        std::vector<const PlaneFace*> of;
        for (const PlaneFace& f : faces) {
            if (f.area <= 0.0) continue;
            own.push_back(out.size());
            of.push_back(&f);
            out.push_back({number, {directed(f.loop)}});
        }
        for (const PlaneFace& f : faces) {
            if (f.area >= 0.0) continue;
            // The outline of a part is a hole of the smallest region of another part round it.
            const int node = rotation.origin[at(f.loop.front())];
            int around = -1;
            for (std::size_t i = 0; i < of.size(); ++i) {
                const auto polygon = outline(*of[i], rotation);
                if (part.root(rotation.origin[at(of[i]->loop.front())]) == part.root(node))
                    continue;
                if (!insidePolygon(polygon, flat_.points[at(node)])) continue;
                if (around < 0 || of[i]->area < of[at(around)]->area) around = static_cast<int>(i);
            }
            if (around >= 0) out[own[at(around)]].loops.push_back(directed(f.loop));
        }
    }

  private:
    /// The wires in the plane that bound something, as a graph of the plane.
    void begin(const WirePlane& plane) {
        wireOf_.clear();
        flat_ = {};
        std::set<int> in = plane.corners;
        std::vector<int> wires;
        for (bool changed = true; changed;) {
            changed = false;
            std::map<int, int> degree;
            wires.clear();
            for (std::size_t d = 0; d < wires_.from.size(); d += 2) {
                if (!in.contains(wires_.from[d]) || !in.contains(wires_.from[d + 1])) continue;
                wires.push_back(static_cast<int>(d));
                ++degree[wires_.from[d]];
                ++degree[wires_.from[d + 1]];
            }
            changed = std::erase_if(in, [&](int v) { return degree[v] < 2; }) > 0;
        }
        const Vec3 u = plane.normal.unitOrthogonal();
        const Vec3 w = plane.normal.cross(u);
        std::map<int, int> index;
        for (const int v : in) {
            index[v] = static_cast<int>(flat_.points.size());
            flat_.points.emplace_back(lift_.points[at(v)].dot(u), lift_.points[at(v)].dot(w));
        }
        for (const int d : wires) {
            wireOf_.push_back(d);
            flat_.edges.push_back({index.at(wires_.from[at(d)]), index.at(wires_.to(d))});
        }
    }

    std::vector<int> directed(const std::vector<int>& loop) const {
        std::vector<int> out;
        for (const int d : loop) out.push_back(wireOf_[at(d / 2)] + d % 2);
        return out;
    }

    std::vector<Vec2> outline(const PlaneFace& f, const RotationSystem& rotation) const {
        std::vector<Vec2> out;
        for (const int d : f.loop) out.push_back(flat_.points[at(rotation.origin[at(d)])]);
        return out;
    }

    const LineDrawing& wires_;
    const WireLift& lift_;
    PlaneGraph flat_;
    std::vector<int> wireOf_;  ///< per edge of the plane's graph: directed edge of the wires
};

/// Which panels are faces: two at every wire, of two planes.
class Choice {
  public:
    Choice(const std::vector<Panel>& panels, std::size_t wires)
        : panels_(panels), at_(wires), state_(panels.size(), Unknown) {
        for (std::size_t p = 0; p < panels.size(); ++p) {
            for (const auto& loop : panels[p].loops) {
                for (const int d : loop) at_[static_cast<std::size_t>(d / 2)].push_back(p);
            }
        }
    }

    std::vector<std::vector<std::size_t>> all() {
        search();
        return std::move(found_);
    }

  private:
    enum Mark : signed char { Unknown, Face, None };
    static constexpr std::size_t kMostFound = 4;
    static constexpr int kMostSteps = 20000;

    /// Settles what follows. \return false where something contradicts.
    bool propagate() {
        for (bool changed = true; changed;) {
            changed = false;
            for (const std::vector<std::size_t>& panels : at_) {
                const auto settled = settle(panels);
                if (!settled) return false;
                changed = changed || *settled;
            }
        }
        return true;
    }

    std::optional<bool> settle(const std::vector<std::size_t>& panels) {
        int faces = 0;
        int open = 0;
        std::set<int> planes;
        for (const std::size_t p : panels) {
            if (state_[p] == Face) {
                ++faces;
                // A panel on both sides of a wire, or two of one plane: no edge.
                if (!planes.insert(panels_[p].plane).second) return std::nullopt;
            }
            if (state_[p] == Unknown) ++open;
        }
        if (faces > 2 || faces + open < 2) return std::nullopt;
        bool changed = false;
        for (const std::size_t p : panels) {
            if (state_[p] != Unknown) continue;
            const bool full = faces == 2 || planes.contains(panels_[p].plane);
            if (full) {
                state_[p] = None;
                changed = true;
            } else if (faces + open == 2) {
                state_[p] = Face;
                changed = true;
            }
        }
        return changed;
    }

    void search() {
        if (++steps_ > kMostSteps || found_.size() == kMostFound) return;
        const std::vector<Mark> before = state_;
        if (propagate()) {
            const auto open = std::find(state_.begin(), state_.end(), Unknown);
            if (open == state_.end()) {
                std::vector<std::size_t> faces;
                for (std::size_t p = 0; p < state_.size(); ++p) {
                    if (state_[p] == Face) faces.push_back(p);
                }
                found_.push_back(std::move(faces));
            } else {
                const auto p = static_cast<std::size_t>(open - state_.begin());
                const std::vector<Mark> here = state_;
                for (const Mark mark : {Face, None}) {
                    state_ = here;
                    state_[p] = mark;
                    search();
                }
            }
        }
        state_ = before;
    }

    const std::vector<Panel>& panels_;
    std::vector<std::vector<std::size_t>> at_;  ///< per wire: panels beside it
    std::vector<Mark> state_;
    std::vector<std::vector<std::size_t>> found_;
    int steps_ = 0;
};

/// Turns faces so that they all look outwards.
class Turned {
  public:
    Turned(const LineDrawing& wires, const std::vector<Vec3>& points)
        : wires_(wires), points_(points) {}

    std::optional<std::vector<WireFace>> faces(
        const std::vector<std::vector<std::vector<int>>>& loops) {
        std::vector<std::array<int, 2>> users(wires_.from.size() / 2, {-1, -1});
        for (std::size_t f = 0; f < loops.size(); ++f) {
            for (const auto& loop : loops[f]) {
                for (const int d : loop) {
                    auto& user = users[at(d / 2)];
                    if (user[1] >= 0) return std::nullopt;
                    user[user[0] < 0 ? 0 : 1] = static_cast<int>(f);
                }
            }
        }
        std::vector<int> turned(loops.size(), -1);
        std::vector<WireFace> out(loops.size());
        for (std::size_t first = 0; first < loops.size(); ++first) {
            if (turned[first] >= 0) continue;
            turned[first] = 0;
            std::vector<int> shell{static_cast<int>(first)};
            for (std::size_t i = 0; i < shell.size(); ++i) {
                if (!spread(loops, users, shell[i], turned, shell)) return std::nullopt;
            }
            double volume = 0.0;
            for (const int f : shell) {
                for (const auto& loop : loops[at(f)]) {
                    out[at(f)].loops.push_back(nodes(loop, turned[at(f)] == 1));
                    volume += doubleArea(points_, out[at(f)].loops.back())
                                  .dot(points_[at(out[at(f)].loops.back().front())]);
                }
            }
            if (volume >= 0.0) continue;
            for (const int f : shell) {
                for (auto& loop : out[at(f)].loops) std::reverse(loop.begin(), loop.end());
            }
        }
        return out;
    }

  private:
    /// Neighbours run along common wires the other way.
    bool spread(const std::vector<std::vector<std::vector<int>>>& loops,
                const std::vector<std::array<int, 2>>& users, int f, std::vector<int>& turned,
                std::vector<int>& shell) const {
        for (const auto& loop : loops[at(f)]) {
            for (const int d : loop) {
                const auto& user = users[at(d / 2)];
                const int other = user[0] == f ? user[1] : user[0];
                if (other < 0 || other == f) return false;
                const bool same = runs(loops[at(other)], d);
                const int wanted = same ? 1 - turned[at(f)] : turned[at(f)];
                if (turned[at(other)] < 0) {
                    turned[at(other)] = wanted;
                    shell.push_back(other);
                } else if (turned[at(other)] != wanted) {
                    return false;
                }
            }
        }
        return true;
    }

    static bool runs(const std::vector<std::vector<int>>& loops, int d) {
        return std::any_of(loops.begin(), loops.end(), [&](const std::vector<int>& loop) {
            return std::find(loop.begin(), loop.end(), d) != loop.end();
        });
    }

    std::vector<int> nodes(const std::vector<int>& loop, bool turned) const {
        std::vector<int> out;
        for (const int d : loop) out.push_back(wires_.from[at(d)]);
        if (turned) std::reverse(out.begin(), out.end());
        return out;
    }

    const LineDrawing& wires_;
    const std::vector<Vec3>& points_;
};

}  // namespace

std::vector<std::vector<WireFace>> wireFaces(const LineDrawing& wires, const AxisFrame& frame,
                                             const WireLift& lift, double spreadPx) {
    std::vector<std::vector<WireFace>> out;
    Turned turned(wires, lift.points);
    if (!wires.regions.empty()) {
        std::vector<std::vector<std::vector<int>>> loops;
        for (const LineDrawing::Region& r : wires.regions) loops.push_back({r.loop});
        if (auto faces = turned.faces(loops)) out.push_back(*std::move(faces));
        return out;
    }
    const std::vector<WirePlane> planes = Planes(wires, frame, lift, spreadPx).all();
    std::vector<Panel> panels;
    Panels finder(wires, lift);
    for (std::size_t p = 0; p < planes.size(); ++p) {
        finder.add(planes[p], static_cast<int>(p), panels);
    }
    for (const std::vector<std::size_t>& chosen : Choice(panels, wires.from.size() / 2).all()) {
        std::vector<std::vector<std::vector<int>>> loops;
        for (const std::size_t p : chosen) loops.push_back(panels[p].loops);
        if (auto faces = turned.faces(loops)) out.push_back(*std::move(faces));
    }
    return out;
}

}  // namespace ew
