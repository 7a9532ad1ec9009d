// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/surface/fillet_clamp.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <queue>

#include "core/base/tolerance.h"
#include "core/surface/box_tree.h"

namespace ew {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// sum of weight * setback(edge) <= room.
struct Limit {
    struct Term {
        int edge;
        double weight;
    };
    std::array<Term, 4> terms{};
    std::size_t count = 0;
    double room = 0.0;
    int edge = -1;    ///< whose room it is
    int vertex = -1;  ///< the corner that moves, for limits inside a face

    void add(int e, double weight) {
        if (weight == 0.0) return;
        for (std::size_t k = 0; k < count; ++k) {
            if (terms[k].edge != e) continue;
            terms[k].weight += weight;
            return;
        }
        terms[count++] = {e, weight};
    }
};

/// Collects the limits of all faces.
class Limits {
  public:
    Limits(const FilletPlan& plan, const std::vector<double>& wanted)
        : plan_(plan), topology_(plan.topology()), bound_(wanted) {
        for (int h = 0; h < topology_.halfCount(); ++h) addLength(h);
        boundAlone();
        for (int f = 0; at(f) < topology_.solid().faces().size(); ++f) addFace(f);
    }
    std::vector<Limit> take() { return std::move(limits_); }

  private:
    /// A point of a face that moves with the setbacks of two edges.
    struct Mover {
        int half;  ///< its sector
        int edgeA;
        int edgeB;
        Vec3 a;
        Vec3 b;
    };

    int edge(int h) const { return topology_.half(h).edge; }
    double bound(int e) const { return bound_[at(e)]; }

    void addStart(Limit& limit, int h, bool across) const {
        if (across) {
            const int before = topology_.cw(h);
            const FilletSector& s = plan_.sector(before);
            limit.add(edge(h), s.lastOwn);
            limit.add(edge(plan_.lastBeside(before)), s.lastOther);
        } else {
            const FilletSector& s = plan_.sector(h);
            limit.add(edge(h), s.firstOwn);
            limit.add(edge(plan_.firstBeside(h)), s.firstOther);
        }
    }

    /// What is cut from both ends of an edge must leave a rest: on a filleted edge per face, on a
    /// sharp one, which both faces share, in every combination.
    void addLength(int h) {
        const FilletHalfEdge& half = topology_.half(h);
        for (const bool sameSide : {true, false}) {
            if (plan_.filleted(h) && !sameSide) continue;
            if (!plan_.filleted(h) && h > half.twin && !sameSide) continue;
            for (const bool across : {false, true}) {
                // Per face the half-edge of the face itself speaks; across pairs once an edge.
                if (sameSide && across) continue;
                Limit limit;
                limit.room = half.length * (1.0 - tol::kFilletRest);
                limit.edge = half.edge;
                addStart(limit, h, across);
                addStart(limit, half.twin, sameSide ? !across : across);
                dropHelpers(limit, h);
                push(limit);
            }
        }
    }

    /// Positions behind the corner of a sharp edge do not lengthen it.
    void dropHelpers(Limit& limit, int h) const {
        if (plan_.filleted(h)) return;
        std::size_t kept = 0;
        for (std::size_t k = 0; k < limit.count; ++k) {
            if (limit.terms[k].weight > 0.0) limit.terms[kept++] = limit.terms[k];
        }
        limit.count = kept;
    }

    void push(const Limit& limit) {
        const bool binds = std::any_of(
            limit.terms.begin(), limit.terms.begin() + static_cast<std::ptrdiff_t>(limit.count),
            [](const Limit::Term& t) { return t.weight > 0.0; });
        if (binds) limits_.push_back(limit);
    }

    /// The most that an edge could get if all others stayed sharp.
    void boundAlone() {
        for (const Limit& limit : limits_) {
            bool helped = false;
            for (std::size_t k = 0; k < limit.count; ++k) helped |= limit.terms[k].weight < 0.0;
            if (helped) continue;
            for (std::size_t k = 0; k < limit.count; ++k) {
                double& b = bound_[at(limit.terms[k].edge)];
                b = std::min(b, limit.room / limit.terms[k].weight);
            }
        }
        // A face is never wider than the solid.
        const auto box = topology_.solid().bounds();
        for (double& b : bound_) b = std::min(b, (box[1] - box[0]).norm());
    }

    void addMovers(int h, std::vector<Mover>& out) const {
        const FilletSector& s = plan_.sector(h);
        using Kind = FilletSector::Kind;
        if (s.kind == Kind::Bare) return;
        const int g = topology_.ccw(h);
        const bool pushes = topology_.half(h).angle > std::numbers::pi || s.kind == Kind::Step ||
                            s.kind == Kind::End;
        if (!pushes) return;
        const FilletHalfEdge& first = topology_.half(h);
        const FilletHalfEdge& last = topology_.half(g);
        const Vec3 lastInward = topology_.half(last.twin).inward;
        if (plan_.filleted(h)) {
            out.push_back({h, first.edge, edge(plan_.firstBeside(h)),
                           s.firstOwn * first.dir + first.inward, s.firstOther * first.dir});
        }
        if (plan_.filleted(g) && s.kind != Kind::Miter) {
            out.push_back({h, last.edge, edge(plan_.lastBeside(h)),
                           s.lastOwn * last.dir + lastInward, s.lastOther * last.dir});
        }
        if (s.kind != Kind::Arc || std::abs(std::sin(first.angle)) < tol::kFilletStraightSine)
            return;
        // An arc stays inside of where the sides would meet.
        const MiterWeights miter = miterWeights(first.angle);
        out.push_back({h, first.edge, last.edge, miter.own * first.dir + first.inward,
                       miter.other * first.dir});
    }

    Box3 reach(const Mover& m) const {
        const Vec3& v = topology_.position(topology_.half(m.half).origin);
        const Vec3 a = bound(m.edgeA) * m.a;
        const Vec3 b = bound(m.edgeB) * m.b;
        Box3 box(v);
        box.extend(v + a);
        box.extend(v + b);
        box.extend(v + a + b);
        return box;
    }

    /// How far the side of an edge may run beyond its two ends.
    std::array<double, 2> beyond(int h) const {
        const auto least = [&](int own, int other, double ownWeight, double otherWeight) {
            return std::max(0.0, -ownWeight * bound(own)) +
                   std::max(0.0, -otherWeight * bound(other));
        };
        const int t = topology_.half(h).twin;
        const int before = topology_.cw(t);
        const FilletSector& s = plan_.sector(h);
        const FilletSector& e = plan_.sector(before);
        return {least(edge(h), edge(plan_.firstBeside(h)), s.firstOwn, s.firstOther),
                least(edge(h), edge(plan_.lastBeside(before)), e.lastOwn, e.lastOther)};
    }

    Box3 reach(int h) const {
        const FilletHalfEdge& half = topology_.half(h);
        const auto ends = beyond(h);
        const Vec3& p = topology_.position(half.origin);
        const Vec3 a = p - ends[0] * half.dir;
        const Vec3 b = p + (half.length + ends[1]) * half.dir;
        const double s = plan_.filleted(h) ? bound(half.edge) : 0.0;
        Box3 box(a);
        box.extend(b);
        box.extend(a + s * half.inward);
        box.extend(b + s * half.inward);
        return box;
    }

    void addFace(int face) {
        std::vector<int> sides;
        std::vector<Mover> movers;
        for (const int first : topology_.loops(face)) {
            int h = first;
            do {
                sides.push_back(h);
                addMovers(h, movers);
                h = topology_.half(h).next;
            } while (h != first);
        }
        if (movers.empty()) return;
        constexpr std::size_t kFew = 4096;
        if (movers.size() * sides.size() <= kFew) {
            for (const Mover& m : movers) {
                for (const int side : sides) addMeeting(m, side);
            }
            return;
        }
        std::vector<Box3> boxes;
        boxes.reserve(sides.size());
        for (const int side : sides) boxes.push_back(reach(side));
        const BoxTree tree(boxes);
        for (const Mover& m : movers) {
            tree.overlapping(reach(m), [&](int i) { addMeeting(m, sides[at(i)]); });
        }
    }

    /// The moving corner stays on its side of another edge, which moves towards it.
    void addMeeting(const Mover& m, int side) {
        if (side == m.half || side == topology_.half(m.half).prev) return;
        const FilletHalfEdge& wall = topology_.half(side);
        const int vertex = topology_.half(m.half).origin;
        const Vec3 from = topology_.position(vertex) - topology_.position(wall.origin);
        const double distance = wall.inward.dot(from);
        if (distance <= tol::kSamePlaneRelative * wall.length) return;
        const double sa = bound(m.edgeA);
        const double sb = bound(m.edgeB);
        const auto ends = beyond(side);
        const double foot = wall.dir.dot(from);
        const double alongA = sa * wall.dir.dot(m.a);
        const double alongB = sb * wall.dir.dot(m.b);
        if (foot + std::max(0.0, alongA) + std::max(0.0, alongB) < -ends[0]) return;
        if (foot + std::min(0.0, alongA) + std::min(0.0, alongB) > wall.length + ends[1]) return;
        Limit limit;
        limit.room = distance * (1.0 - tol::kFilletRest);
        limit.edge = wall.edge;
        limit.vertex = vertex;
        limit.add(m.edgeA, -wall.inward.dot(m.a));
        limit.add(m.edgeB, -wall.inward.dot(m.b));
        if (plan_.filleted(side)) limit.add(wall.edge, 1.0);
        double most = 0.0;
        for (std::size_t k = 0; k < limit.count; ++k) {
            most += std::max(0.0, limit.terms[k].weight) * bound(limit.terms[k].edge);
        }
        if (most > limit.room) push(limit);
    }

    const FilletPlan& plan_;
    const FilletTopology& topology_;
    std::vector<double> bound_;
    std::vector<Limit> limits_;
};

/// Lets all setbacks grow together.
class Filling {
  public:
    Filling(std::vector<Limit> limits, const std::vector<double>& wanted)
        : limits_(std::move(limits)), wanted_(wanted), stopped_(wanted.size(), false) {
        fit_.setbacks.assign(wanted.size(), 0.0);
        fit_.limitingEdge.assign(wanted.size(), -1);
        fit_.limitingVertex.assign(wanted.size(), -1);
        start_.assign(wanted.size() + 1, 0);
        for (const Limit& limit : limits_) {
            for (std::size_t k = 0; k < limit.count; ++k) ++start_[at(limit.terms[k].edge) + 1];
        }
        for (std::size_t e = 0; e < wanted.size(); ++e) start_[e + 1] += start_[e];
        users_.resize(start_.back());
        std::vector<std::size_t> fill = start_;
        for (std::size_t l = 0; l < limits_.size(); ++l) {
            for (std::size_t k = 0; k < limits_[l].count; ++k) {
                users_[fill[at(limits_[l].terms[k].edge)]++] = l;
            }
        }
        used_.assign(limits_.size(), 0.0);
        rate_.assign(limits_.size(), 0.0);
        version_.assign(limits_.size(), 0);
    }

    FilletFit run() {
        for (std::size_t e = 0; e < wanted_.size(); ++e) {
            if (wanted_[e] > 0.0) {
                events_.push({wanted_[e], false, e, 0});
            } else {
                stopped_[e] = true;
            }
        }
        for (std::size_t l = 0; l < limits_.size(); ++l) {
            for (std::size_t k = 0; k < limits_[l].count; ++k) {
                if (!stopped_[at(limits_[l].terms[k].edge)]) rate_[l] += limits_[l].terms[k].weight;
            }
            schedule(l, 0.0);
        }
        while (!events_.empty()) {
            const Event event = events_.top();
            events_.pop();
            if (!event.isLimit) {
                if (!stopped_[event.index]) stop(event.index, event.time);
                continue;
            }
            if (event.version != version_[event.index]) continue;
            const Limit& limit = limits_[event.index];
            double heaviest = 0.0;
            for (std::size_t k = 0; k < limit.count; ++k) {
                heaviest = std::max(heaviest, limit.terms[k].weight);
            }
            for (std::size_t k = 0; k < limit.count; ++k) {
                const auto e = at(limit.terms[k].edge);
                if (stopped_[e]) continue;
                if (limit.terms[k].weight <= tol::kFilletLightWeight * heaviest) continue;
                blame(e, limit);
                stop(e, event.time);
            }
        }
        return std::move(fit_);
    }

  private:
    struct Event {
        double time;
        bool isLimit;
        std::size_t index;
        int version;
        bool operator<(const Event& o) const {  // the earliest on top, wishes before limits
            if (time != o.time) return time > o.time;
            if (isLimit != o.isLimit) return isLimit;
            return index > o.index;
        }
    };

    void schedule(std::size_t l, double now) {
        ++version_[l];
        if (rate_[l] <= 0.0) return;
        const double time = std::max(now, (limits_[l].room - used_[l]) / rate_[l]);
        events_.push({time, true, l, version_[l]});
    }

    void stop(std::size_t e, double time) {
        stopped_[e] = true;
        fit_.setbacks[e] = time;
        for (std::size_t i = start_[e]; i < start_[e + 1]; ++i) {
            const std::size_t l = users_[i];
            used_[l] = 0.0;
            rate_[l] = 0.0;
            for (std::size_t k = 0; k < limits_[l].count; ++k) {
                const auto& term = limits_[l].terms[k];
                if (stopped_[at(term.edge)]) {
                    used_[l] += term.weight * fit_.setbacks[at(term.edge)];
                } else {
                    rate_[l] += term.weight;
                }
            }
            schedule(l, time);
        }
    }

    void blame(std::size_t e, const Limit& limit) {
        const int self = static_cast<int>(e);
        fit_.limitingVertex[e] = limit.vertex;
        if (limit.edge != self) {
            fit_.limitingEdge[e] = limit.edge;
            return;
        }
        // Its own length is used up, by its neighbours; or another corner runs into it.
        double most = 0.0;
        for (std::size_t k = 0; k < limit.count; ++k) {
            if (limit.terms[k].edge == self || limit.terms[k].weight <= most) continue;
            most = limit.terms[k].weight;
            fit_.limitingEdge[e] = limit.terms[k].edge;
        }
        if (fit_.limitingEdge[e] < 0) fit_.limitingEdge[e] = self;
    }

    std::vector<Limit> limits_;
    const std::vector<double>& wanted_;
    FilletFit fit_;
    std::vector<bool> stopped_;
    std::vector<std::size_t> start_;  ///< limits by edge, as offsets into users_
    std::vector<std::size_t> users_;
    std::vector<double> used_;
    std::vector<double> rate_;
    std::vector<int> version_;
    std::priority_queue<Event> events_;
};

}  // namespace

FilletFit fitSetbacks(const FilletPlan& plan, const std::vector<double>& wanted) {
    return Filling(Limits(plan, wanted).take(), wanted).run();
}

}  // namespace ew
