// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reading/solve/wire_lift.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "core/base/disjoint_sets.h"

namespace ew {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

class Wires {
  public:
    Wires(const LineDrawing& wires, const AxisFrame& frame, double spread)
        : wires_(wires), frame_(frame), near_(kNear * spread) {
        for (std::size_t v = 0; v < wires.nodes.size(); ++v) {
            if (!wires.nodes[v].out.empty()) corners_.push_back(static_cast<int>(v));
        }
    }

    std::vector<WireLift> all() {
        if (std::all_of(frame_.axisOf.begin(), frame_.axisOf.end(), [](int a) { return a < 0; })) {
            return {};
        }
        State start{std::vector<DisjointSets>(3, DisjointSets(wires_.nodes.size())), {}, 0.0};
        joinAlongAxes(start);
        joinFaces(start);
        std::vector<State> states{std::move(start)};
        for (std::size_t k = 0; k < corners_.size(); ++k) {
            std::vector<State> next;
            bool changed = false;
            for (State& s : states) changed = attach(s, next) || changed;
            std::stable_sort(next.begin(), next.end(),
                             [](const State& a, const State& b) { return a.rank > b.rank; });
            if (next.size() > kMostLifts) next.resize(kMostLifts);
            states = std::move(next);
            if (!changed) break;
        }
        std::vector<WireLift> out;
        for (State& s : states) {
            WireLift lift;
            lift.points = solve(s);
            for (int k = 0; k < 3; ++k) {
                auto& planes = lift.planes[at(k)];
                for (std::size_t v = 0; v < wires_.nodes.size(); ++v) {
                    planes.push_back(s.planes[at(k)].root(static_cast<int>(v)));
                }
            }
            lift.rank = s.rank;
            out.push_back(std::move(lift));
        }
        return out;
    }

  private:
    static constexpr double kNear = 4.0;         ///< coordinates so near may be one [spreads]
    static constexpr double kMiddle = 0.5;       ///< what a line speaks for that is symmetric
    static constexpr double kStanding = 2.5;     ///< what a part speaks for that stands on another
    static constexpr double kSharedPlane = 0.5;  ///< what a plane that two parts share speaks for
    static constexpr std::size_t kMostLifts = 4;
    static constexpr std::size_t kMostShifts = 3;  ///< tried for each part

    /// One corner lies so much deeper than another one.
    struct Pin {
        std::array<int, 2> corners{-1, -1};
        double deeper = 0.0;  ///< of the second [px]
    };

    /// Which corners have which coordinates in common.
    struct State {
        std::vector<DisjointSets> planes;  ///< per axis
        std::vector<Pin> pins;
        double rank = 0.0;
    };

    void joinAlongAxes(State& s) const {
        for (std::size_t e = 0; e < frame_.axisOf.size(); ++e) {
            const int axis = frame_.axisOf[e];
            if (axis < 0) continue;
            for (const int k : {(axis + 1) % 3, (axis + 2) % 3}) {
                s.planes[at(k)].join(wires_.from[2 * e], wires_.from[2 * e + 1]);
            }
        }
    }

    void joinFaces(State& s) const {
        for (const LineDrawing::Region& face : wires_.regions) {
            std::set<int> axes;
            for (const int d : face.loop) axes.insert(frame_.axisOf[at(d / 2)]);
            axes.erase(-1);
            if (axes.size() != 2) continue;
            const int across = 3 - *axes.begin() - *axes.rbegin();
            for (const int d : face.loop) {
                s.planes[at(across)].join(wires_.from[at(d)], wires_.from[at(face.loop.front())]);
            }
        }
    }

    /// Per corner: the part that it belongs to, whose depth is one.
    DisjointSets parts(State& s) const {
        DisjointSets part(wires_.nodes.size());
        for (DisjointSets& planes : s.planes) {
            for (const int v : corners_) part.join(v, planes.root(v));
        }
        for (const Pin& pin : s.pins) part.join(pin.corners[0], pin.corners[1]);
        return part;
    }

    /// Coordinates of all planes by least squares: corners are seen where they were drawn. The
    /// depths of parts are those of least norm.
    std::vector<Vec3> solve(State& s) const {
        std::array<std::map<int, Eigen::Index>, 3> column;
        Eigen::Index columns = 0;
        for (int k = 0; k < 3; ++k) {
            for (const int v : corners_) {
                if (column[at(k)].try_emplace(s.planes[at(k)].root(v), columns).second) ++columns;
            }
        }
        const auto rows = static_cast<Eigen::Index>(2 * corners_.size() + s.pins.size());
        Eigen::MatrixXd a = Eigen::MatrixXd::Zero(rows, columns);
        Eigen::VectorXd b(rows);
        for (std::size_t i = 0; i < corners_.size(); ++i) {
            const int v = corners_[i];
            for (Eigen::Index r = 0; r < 2; ++r) {
                const Eigen::Index row = 2 * static_cast<Eigen::Index>(i) + r;
                for (int k = 0; k < 3; ++k) {
                    a(row, column[at(k)].at(s.planes[at(k)].root(v))) = frame_.axes(r, k);
                }
                b(row) = wires_.nodes[at(v)].at(r);
            }
        }
        Eigen::Index row = 2 * static_cast<Eigen::Index>(corners_.size());
        for (const Pin& pin : s.pins) {
            for (int k = 0; k < 3; ++k) {
                for (const int i : {0, 1}) {
                    a(row, column[at(k)].at(s.planes[at(k)].root(pin.corners[at(i)]))) +=
                        (2 * i - 1) * frame_.axes(2, k);
                }
            }
            b(row++) = pin.deeper;
        }
        Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> decomposition;
        decomposition.setThreshold(1e-9);
        decomposition.compute(a);
        const Eigen::VectorXd x = decomposition.solve(b);
        std::vector<Vec3> points(wires_.nodes.size(), Vec3::Zero());
        for (const int v : corners_) {
            for (int k = 0; k < 3; ++k) {
                points[at(v)] += x(column[at(k)].at(s.planes[at(k)].root(v))) * frame_.axes.col(k);
            }
        }
        return points;
    }

    /// A depth of a part that something speaks for.
    struct Shift {
        double by = 0.0;
        double rank = 0.0;
    };

    /// Puts the part that most speaks for into place beside the largest one.
    /// \return false where there is one part only; then the state is kept as it is.
    bool attach(State& s, std::vector<State>& next) const {
        DisjointSets part = parts(s);
        std::map<int, std::vector<int>> members;
        for (const int v : corners_) members[part.root(v)].push_back(v);
        if (members.size() < 2) {
            next.push_back(std::move(s));
            return false;
        }
        const auto largest = std::max_element(
            members.begin(), members.end(),
            [](const auto& a, const auto& b) { return a.second.size() < b.second.size(); });
        const std::vector<Vec3> points = solve(s);
        std::vector<Shift> best;
        const std::vector<int>* moved = nullptr;
        for (auto it = members.begin(); it != members.end(); ++it) {
            if (it == largest) continue;
            std::vector<Shift> shifts = shiftsOf(points, largest->second, it->second);
            if (shifts.empty()) continue;
            if (moved != nullptr && shifts.front().rank <= best.front().rank) continue;
            best = std::move(shifts);
            moved = &it->second;
        }
        if (moved == nullptr) {
            // Nothing tells any depth.
            next.push_back(std::move(s));
            return false;
        }
        for (const Shift& shift : best) {
            State joined = s;
            joined.rank += shift.rank;
            join(joined, points, largest->second, *moved, shift.by);
            next.push_back(std::move(joined));
        }
        return true;
    }

    double along(const Vec3& p, int axis) const { return p.dot(frame_.axes.col(axis)); }

    /// Depths that put a coordinate of a moved corner where one of the fixed part is, or in the
    /// middle of what it is joined to, the likeliest first.
    std::vector<Shift> shiftsOf(const std::vector<Vec3>& points, const std::vector<int>& fixed,
                                const std::vector<int>& moved) const {
        std::vector<Shift> votes;
        const std::set<int> isFixed(fixed.begin(), fixed.end());
        for (int k = 0; k < 3; ++k) {
            const double slope = frame_.axes(2, k);
            if (std::abs(slope) < 0.05) continue;
            const auto vote = [&](double to, double from, double weight) {
                votes.push_back({(to - from) / slope, weight});
            };
            std::vector<std::array<double, 2>> links;  // coordinates of both ends
            for (const int v : moved) {
                for (const int d : wires_.nodes[at(v)].out) {
                    const int w = wires_.to(d);
                    if (!isFixed.contains(w)) continue;
                    links.push_back({along(points[at(w)], k), along(points[at(v)], k)});
                }
            }
            voteLinks(links, vote);
            votePlanes(points, fixed, moved, k, vote);
        }
        return clusters(std::move(votes));
    }

    /// A line between two parts lies in a plane across the axis, or the one part is in the middle
    /// of the other. Where all lines come from one plane the part would be flat.
    template <typename Vote>
    void voteLinks(const std::vector<std::array<double, 2>>& links, const Vote& vote) const {
        if (links.empty()) return;
        std::array<double, 2> low = links.front();
        std::array<double, 2> high = low;
        for (const auto& link : links) {
            for (const std::size_t side : {0U, 1U}) {
                low[side] = std::min(low[side], link[side]);
                high[side] = std::max(high[side], link[side]);
            }
        }
        if (high[0] - low[0] < near_) return;
        for (const auto& link : links) vote(link[0], link[1], 1.0);
        vote(0.5 * (low[0] + high[0]), 0.5 * (low[1] + high[1]),
             kMiddle * static_cast<double>(links.size()));
    }

    /// Parts share planes, all the more where one then stands on the other.
    template <typename Vote>
    void votePlanes(const std::vector<Vec3>& points, const std::vector<int>& fixed,
                    const std::vector<int>& moved, int axis, const Vote& vote) const {
        const auto levels = [&](const std::vector<int>& corners) {
            std::vector<double> out;
            for (const int v : corners) out.push_back(along(points[at(v)], axis));
            std::sort(out.begin(), out.end());
            std::vector<double> kept;
            for (const double x : out) {
                if (kept.empty() || x - kept.back() > near_) kept.push_back(x);
            }
            return kept;
        };
        const std::vector<double> ends = levels(moved);
        for (const double to : levels(fixed)) {
            for (const double from : {ends.front(), ends.back()}) {
                vote(to, from,
                     kSharedPlane + kStanding * standing(points, fixed, moved, axis, to, from));
            }
        }
    }

    /// Share of the moved corners in one plane that come to lie within the fixed part's there.
    double standing(const std::vector<Vec3>& points, const std::vector<int>& fixed,
                    const std::vector<int>& moved, int axis, double to, double from) const {
        const Vec3 shift = Vec3(0.0, 0.0, (to - from) / frame_.axes(2, axis));
        std::array<Vec2, 2> bounds{Vec2::Constant(std::numeric_limits<double>::infinity()),
                                   Vec2::Constant(-std::numeric_limits<double>::infinity())};
        const auto flat = [&](const Vec3& p) {
            return Vec2(along(p, (axis + 1) % 3), along(p, (axis + 2) % 3));
        };
        for (const int v : fixed) {
            if (std::abs(along(points[at(v)], axis) - to) > near_) continue;
            bounds[0] = bounds[0].cwiseMin(flat(points[at(v)]));
            bounds[1] = bounds[1].cwiseMax(flat(points[at(v)]));
        }
        double inside = 0.0;
        double all = 0.0;
        for (const int v : moved) {
            if (std::abs(along(points[at(v)], axis) - from) > near_) continue;
            const Vec2 p = flat(points[at(v)] + shift);
            all += 1.0;
            const bool within = ((p - bounds[0]).array() > -near_).all() &&
                                ((bounds[1] - p).array() > -near_).all();
            inside += within ? 1.0 : 0.0;
        }
        return all > 0.0 ? inside / all : 0.0;
    }

    /// Votes that agree are one.
    std::vector<Shift> clusters(std::vector<Shift> votes) const {
        std::sort(votes.begin(), votes.end(),
                  [](const Shift& a, const Shift& b) { return a.by < b.by; });
        std::vector<Shift> out;
        double sum = 0.0;
        for (std::size_t i = 0; i < votes.size(); ++i) {
            const bool more = i > 0 && votes[i].by - votes[i - 1].by < near_;
            if (!more) {
                out.push_back({});
                sum = 0.0;
            }
            out.back().rank += votes[i].rank;
            sum += votes[i].rank * votes[i].by;
            out.back().by = sum / out.back().rank;
        }
        std::stable_sort(out.begin(), out.end(),
                         [](const Shift& a, const Shift& b) { return a.rank > b.rank; });
        if (out.size() > kMostShifts) out.resize(kMostShifts);
        return out;
    }

    /// Planes of the two parts that lie together are one; where none do, the depth is kept by
    /// itself.
    void join(State& s, const std::vector<Vec3>& points, const std::vector<int>& fixed,
              const std::vector<int>& moved, double by) const {
        bool joined = false;
        for (int k = 0; k < 3; ++k) {
            for (const int v : moved) {
                const double x = along(points[at(v)] + Vec3(0.0, 0.0, by), k);
                int best = -1;
                double least = near_;
                for (const int w : fixed) {
                    const double off = std::abs(along(points[at(w)], k) - x);
                    if (off >= least) continue;
                    least = off;
                    best = w;
                }
                if (best >= 0 && mayBeOne(s, k, v, best)) {
                    s.planes[at(k)].join(v, best);
                    joined = true;
                }
            }
        }
        if (joined) return;
        const int v = moved.front();
        const int w = fixed.front();
        s.pins.push_back({{w, v}, points[at(v)].z() + by - points[at(w)].z()});
    }

    /// Can two corners lie in one plane across an axis? Not where a line along it leads from there
    /// to there.
    bool mayBeOne(const State& s, int axis, int v, int w) const {
        DisjointSets planes = s.planes[at(axis)];
        planes.join(v, w);
        for (std::size_t e = 0; e < frame_.axisOf.size(); ++e) {
            if (frame_.axisOf[e] != axis) continue;
            if (planes.root(wires_.from[2 * e]) == planes.root(wires_.from[2 * e + 1]))
                return false;
        }
        return true;
    }

    const LineDrawing& wires_;
    const AxisFrame& frame_;
    double near_;  ///< [px]
    std::vector<int> corners_;
};

}  // namespace

std::vector<WireLift> liftWires(const LineDrawing& wires, const AxisFrame& frame, double spreadPx) {
    return Wires(wires, frame, spreadPx).all();
}

}  // namespace ew
