// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/edge_graph/repair.h"

#include <algorithm>
#include <cmath>
#include <memory>
#include <queue>
#include <set>

#include "core/base/tolerance.h"
#include "core/edge_graph/canonical.h"
#include "core/edge_graph/prune.h"

namespace ew {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// How heavy the tail of a hand's misses is (Student's t).
constexpr double kTail = 5.0;
/// No open end is mended for less.
constexpr double kOpenEndPrice = 4.0;

struct State {
    std::size_t draft = 0;
    RawGraph raw;               ///< nothing pruned yet
    std::vector<int> straight;  ///< vertices that are no corners, ascending
    double price = 0.0;
    double promise = 0.0;  ///< price, and what its open ends will cost at least
    int dropped = 0;
};

bool samePiece(const LinePiece& a, const LinePiece& b) {
    return a.line == b.line && ((a.t0 == b.t0 && a.t1 == b.t1) || (a.t0 == b.t1 && a.t1 == b.t0));
}

/// What identifies a graph whatever the order of the corrections that led to it.
std::vector<int> keyOf(std::size_t draft, const RawGraph& raw) {
    std::vector<std::pair<int, int>> edges;
    for (const RawGraph::Edge& e : raw.edges) {
        if (e.alive) edges.emplace_back(std::minmax(e.v[0], e.v[1]));
    }
    std::sort(edges.begin(), edges.end());
    std::vector<int> key{static_cast<int>(draft)};
    for (const auto& [a, b] : edges) {
        key.push_back(a);
        key.push_back(b);
    }
    return key;
}

std::vector<int> keyOf(const State& s) {
    std::vector<int> key = keyOf(s.draft, s.raw);
    key.push_back(-1);
    key.insert(key.end(), s.straight.begin(), s.straight.end());
    return key;
}

PlaneGraph shapeOf(const RawGraph& raw) {
    PlaneGraph plane;
    std::vector<int> number(raw.vertices.size(), -1);
    for (const RawGraph::Edge& e : raw.edges) {
        if (!e.alive) continue;
        std::array<int, 2> ends{};
        for (std::size_t k = 0; k < 2; ++k) {
            int& n = number[at(e.v[k])];
            if (n < 0) {
                n = static_cast<int>(plane.points.size());
                plane.points.push_back(raw.vertices[at(e.v[k])]);
            }
            ends[k] = n;
        }
        plane.edges.push_back(ends);
    }
    return plane;
}

class Search {
  public:
    Search(const InkReading& ink, const std::vector<GraphDraft>& drafts,
           const RepairOptions& options)
        : ink_(ink),
          drafts_(drafts),
          options_(options),
          reach_(std::min(4.0 * options.spreadPx, 1.6 * options.distancePx)) {}

    std::vector<RepairedGraph> run() {
        for (std::size_t d = 0; d < drafts_.size(); ++d) {
            State start;
            start.draft = d;
            start.raw = drafts_[d].raw;
            start.price = drafts_[d].price;
            push(std::move(start));
        }
        double limit = options_.maxPrice;
        for (std::size_t n = 0; n < options_.maxStates && !queue_.empty(); ++n) {
            const std::shared_ptr<State> s = queue_.top();
            queue_.pop();
            if (s->price > limit) continue;
            RawGraph settled = s->raw;
            pruneOpen(settled);
            straighten(settled, s->straight, options_.distancePx);
            const PlaneGraph shape = shapeOf(settled);
            if (shape.edges.size() >= 5 && options_.known(shape) &&
                settled_.insert(keyOf(s->draft, settled)).second) {
                RepairedGraph r{settleEdgeGraph(ink_, drafts_[s->draft].lines, s->raw, s->straight,
                                                options_.distancePx),
                                s->price, s->dropped};
                double stray = 0;
                for (const DanglingEdge& d : r.graph.dangling) {
                    stray += (d.ends[1] - d.ends[0]).norm() / (4.0 * options_.distancePx);
                }
                limit =
                    std::min(limit, s->price + tol::kExtraEdgeCost * stray + options_.pastFirst);
                found_.push_back(std::move(r));
            }
            if (settled.edges.size() < 200) expand(*s, settled);
        }
        return std::move(found_);
    }

  private:
    struct Dearer {
        bool operator()(const std::shared_ptr<State>& a, const std::shared_ptr<State>& b) const {
            return a->promise > b->promise;
        }
    };

    void push(State&& s) {
        if (s.price > options_.maxPrice) return;
        s.promise = s.price + kOpenEndPrice * openEnds(s.raw);
        if (known_.insert(keyOf(s)).second) queue_.push(std::make_shared<State>(std::move(s)));
    }

    /// Ends of lines too long to be overshoot that nothing meets.
    double openEnds(const RawGraph& raw) const {
        const auto incidence = raw.incidence();
        int open = 0;
        for (std::size_t v = 0; v < incidence.size(); ++v) {
            if (incidence[v].size() != 1) continue;
            const RawGraph::Edge& e = raw.edges[at(incidence[v].front())];
            const double length = (raw.vertices[at(e.v[0])] - raw.vertices[at(e.v[1])]).norm();
            if (length > tol::kOvershootReach * options_.distancePx) ++open;
        }
        return open;
    }

    double missPrice(double px) const {
        const double x = px / options_.spreadPx;
        // A heavy tail: hands that miss once miss by far.
        return 1.0 + kTail * std::log1p(x * x / kTail);
    }

    void expand(const State& s, const RawGraph& settled) {
        joins(s);
        landings(s);
        drops(s, settled);
        for (const Bend& bend : doubtfulBends(settled, options_.distancePx)) {
            State next = s;
            next.straight.insert(
                std::upper_bound(next.straight.begin(), next.straight.end(), bend.vertex),
                bend.vertex);
            next.price += 0.25;
            push(std::move(next));
        }
    }

    void joins(const State& s) {
        const auto incidence = s.raw.incidence();
        const int n = static_cast<int>(s.raw.vertices.size());
        for (int u = 0; u < n; ++u) {
            if (incidence[at(u)].empty()) continue;
            for (int v = u + 1; v < n; ++v) {
                if (incidence[at(v)].empty()) continue;
                const double d = (s.raw.vertices[at(u)] - s.raw.vertices[at(v)]).norm();
                if (d > reach_) continue;
                State next = s;
                next.price += missPrice(d);
                const double a = static_cast<double>(incidence[at(u)].size());
                const double b = static_cast<double>(incidence[at(v)].size());
                next.raw.vertices[at(u)] =
                    (a * s.raw.vertices[at(u)] + b * s.raw.vertices[at(v)]) / (a + b);
                for (RawGraph::Edge& e : next.raw.edges) {
                    if (!e.alive) continue;
                    for (int& w : e.v) {
                        if (w == v) w = u;
                    }
                    if (e.v[0] == e.v[1]) e.alive = false;
                }
                push(std::move(next));
            }
        }
    }

    /// Open ends close to the inside of an edge.
    void landings(const State& s) {
        const auto incidence = s.raw.incidence();
        for (std::size_t u = 0; u < incidence.size(); ++u) {
            if (incidence[u].size() != 1) continue;
            const Vec2& p = s.raw.vertices[u];
            for (std::size_t e = 0; e < s.raw.edges.size(); ++e) {
                const RawGraph::Edge& bar = s.raw.edges[e];
                if (!bar.alive || bar.v[0] == static_cast<int>(u) ||
                    bar.v[1] == static_cast<int>(u)) {
                    continue;
                }
                const Vec2& a = s.raw.vertices[at(bar.v[0])];
                const Vec2& b = s.raw.vertices[at(bar.v[1])];
                const double d = distanceToSegment(p, a, b);
                const double along = (p - a).dot(b - a) / std::max((b - a).squaredNorm(), 1e-12);
                if (d > reach_ || along < 0.1 || along > 0.9) continue;
                State next = s;
                next.price += missPrice(d) + 1.0;
                split(next.raw, e, static_cast<int>(u), along);
                push(std::move(next));
            }
        }
    }

    static void split(RawGraph& raw, std::size_t e, int vertex, double along) {
        raw.vertices[at(vertex)] = raw.vertices[at(raw.edges[e].v[0])] * (1 - along) +
                                   raw.vertices[at(raw.edges[e].v[1])] * along;
        RawGraph::Edge second = raw.edges[e];
        RawGraph::Edge& first = raw.edges[e];
        first.v[1] = vertex;
        second.v[0] = vertex;
        // Pieces are cut at the same share of their common length.
        double total = 0;
        for (const LinePiece& p : first.pieces) total += std::abs(p.t1 - p.t0);
        double left = along * total;
        std::vector<LinePiece> head;
        std::vector<LinePiece> tail;
        for (const LinePiece& p : first.pieces) {
            const double len = std::abs(p.t1 - p.t0);
            if (left >= len) {
                head.push_back(p);
            } else if (left <= 0) {
                tail.push_back(p);
            } else {
                const double cut = p.t0 + (p.t1 - p.t0) * left / len;
                head.push_back({p.line, p.t0, cut});
                tail.push_back({p.line, cut, p.t1});
            }
            left -= len;
        }
        if (head.empty()) head.push_back(tail.front());
        if (tail.empty()) tail.push_back(head.back());
        first.pieces = std::move(head);
        second.pieces = std::move(tail);
        raw.edges.push_back(std::move(second));
    }

    void drops(const State& s, const RawGraph& settled) {
        for (std::size_t e = 0; e < settled.edges.size(); ++e) {
            if (!settled.edges[e].alive) continue;
            const double beside = farthestFromOthers(s.draft, settled, e);
            const double redundant = 2.0 + std::pow(beside / options_.spreadPx, 2);
            const bool extra = redundant > tol::kExtraEdgeCost;
            State next = s;
            next.price += extra ? tol::kExtraEdgeCost : redundant;
            next.dropped += extra ? 1 : 0;
            for (RawGraph::Edge& raw : next.raw.edges) {
                if (!raw.alive || raw.pieces.empty()) continue;
                for (const LinePiece& p : settled.edges[e].pieces) {
                    if (std::any_of(raw.pieces.begin(), raw.pieces.end(),
                                    [&](const LinePiece& q) { return samePiece(p, q); })) {
                        raw.alive = false;
                    }
                }
            }
            push(std::move(next));
        }
    }

    /// How far the middle of an edge is from its neighbours: an edge drawn twice has one beside it.
    double farthestFromOthers(std::size_t draft, const RawGraph& settled, std::size_t edge) const {
        double farthest = 0;
        for (const LinePiece& piece : settled.edges[edge].pieces) {
            const InkLine& line = drafts_[draft].lines[at(piece.line)];
            for (const double share : {0.1, 0.5, 0.9}) {
                const double t = piece.t0 + share * (piece.t1 - piece.t0);
                const Vec2 p = line.a + t * line.direction();
                double nearest = std::numeric_limits<double>::infinity();
                for (std::size_t o = 0; o < settled.edges.size(); ++o) {
                    if (o == edge || !settled.edges[o].alive) continue;
                    nearest = std::min(
                        nearest, distanceToSegment(p, settled.vertices[at(settled.edges[o].v[0])],
                                                   settled.vertices[at(settled.edges[o].v[1])]));
                }
                farthest = std::max(farthest, nearest);
            }
        }
        return farthest;
    }

    const InkReading& ink_;
    const std::vector<GraphDraft>& drafts_;
    const RepairOptions& options_;
    double reach_;
    std::priority_queue<std::shared_ptr<State>, std::vector<std::shared_ptr<State>>, Dearer> queue_;
    std::set<std::vector<int>> known_;
    std::set<std::vector<int>> settled_;
    std::vector<RepairedGraph> found_;
};

}  // namespace

std::vector<RepairedGraph> repairedGraphs(const InkReading& ink,
                                          const std::vector<GraphDraft>& drafts,
                                          const RepairOptions& options) {
    return Search(ink, drafts, options).run();
}

}  // namespace ew
