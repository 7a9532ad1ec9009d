// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/hand/hand_plan.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <queue>

namespace ew {
namespace {

constexpr double kSameEndPx = 1e-6;

/// The lines as a graph; `at[n]` lists the edges that end in node n.
struct LineGraph {
    std::vector<Vec2> nodes;
    std::vector<std::array<int, 2>> edges;
    std::vector<std::vector<int>> at;

    int other(int edge, int node) const {
        const auto& e = edges[static_cast<std::size_t>(edge)];
        return e[0] == node ? e[1] : e[0];
    }
    const Vec2& node(int n) const { return nodes[static_cast<std::size_t>(n)]; }
    const std::vector<int>& edgesAt(int n) const { return at[static_cast<std::size_t>(n)]; }
};

LineGraph buildGraph(const std::vector<Line2>& lines) {
    LineGraph g;
    const auto nodeAt = [&](const Vec2& p) {
        for (std::size_t i = 0; i < g.nodes.size(); ++i) {
            if ((g.nodes[i] - p).norm() <= kSameEndPx) return static_cast<int>(i);
        }
        g.nodes.push_back(p);
        g.at.emplace_back();
        return static_cast<int>(g.nodes.size()) - 1;
    };
    for (const Line2& line : lines) {
        const int a = nodeAt(line[0]);
        const int b = nodeAt(line[1]);
        const int e = static_cast<int>(g.edges.size());
        g.edges.push_back({a, b});
        g.at[static_cast<std::size_t>(a)].push_back(e);
        g.at[static_cast<std::size_t>(b)].push_back(e);
    }
    return g;
}

/// The pen's way over nodes, and the edge of every step.
struct Trail {
    std::vector<int> nodes;
    std::vector<int> edges;
};

class TrailMaker {
  public:
    TrailMaker(const LineGraph& graph, Random& random)
        : graph_(graph), random_(random), drawn_(graph.edges.size(), false) {}

    std::vector<Trail> take() { return std::move(trails_); }

    void singleEdges() {
        for (std::size_t e = 0; e < graph_.edges.size(); ++e) {
            if (drawn_[e]) continue;
            drawn_[e] = true;
            trails_.push_back({{graph_.edges[e][0], graph_.edges[e][1]}, {static_cast<int>(e)}});
        }
    }

    /// Trails that go on over a corner with this probability.
    void walks(double goOn) {
        for (int edge = anyUndrawn(); edge >= 0; edge = anyUndrawn()) {
            const int start = graph_.edges[static_cast<std::size_t>(edge)]
                                          [static_cast<std::size_t>(random_.index(2))];
            Trail trail{{start}, {}};
            step(trail, edge);
            while (random_.chance(goOn) || goOn >= 1.0) {
                const int next = undrawnAt(trail.nodes.back());
                if (next < 0) break;
                step(trail, next);
            }
            trails_.push_back(std::move(trail));
        }
    }

    /// Closed strokes round regions whose lines are all still undrawn.
    void faceLoops() {
        std::vector<int> order(2 * graph_.edges.size());
        for (std::size_t i = 0; i < order.size(); ++i) order[i] = static_cast<int>(i);
        random_.shuffle(order);
        for (const int directed : order) {
            Trail loop = turnLeftFrom(directed);
            if (loop.edges.size() < 3) continue;
            for (const int e : loop.edges) drawn_[static_cast<std::size_t>(e)] = true;
            trails_.push_back(std::move(loop));
        }
    }

    /// Never lifts the pen inside a connected part: where it is stuck it goes back over drawn
    /// lines, the shortest way to an undrawn one.
    void withoutLifting() {
        for (int edge = anyUndrawn(); edge >= 0; edge = anyUndrawn()) {
            Trail trail{{graph_.edges[static_cast<std::size_t>(edge)]
                                     [static_cast<std::size_t>(random_.index(2))]},
                        {}};
            step(trail, edge);
            while (true) {
                const int next = undrawnAt(trail.nodes.back());
                if (next >= 0) {
                    step(trail, next);
                    continue;
                }
                const std::vector<int> back = wayToUndrawn(trail.nodes.back());
                if (back.empty()) break;
                for (const int e : back) step(trail, e);
            }
            trails_.push_back(std::move(trail));
        }
    }

  private:
    void step(Trail& trail, int edge) {
        drawn_[static_cast<std::size_t>(edge)] = true;
        trail.edges.push_back(edge);
        trail.nodes.push_back(graph_.other(edge, trail.nodes.back()));
    }

    int pick(const std::vector<int>& candidates) {
        if (candidates.empty()) return -1;
        const int i = random_.index(static_cast<int>(candidates.size()));
        return candidates[static_cast<std::size_t>(i)];
    }

    int anyUndrawn() {
        std::vector<int> left;
        for (std::size_t e = 0; e < drawn_.size(); ++e) {
            if (!drawn_[e]) left.push_back(static_cast<int>(e));
        }
        return pick(left);
    }

    int undrawnAt(int node) {
        std::vector<int> left;
        for (const int e : graph_.edgesAt(node)) {
            if (!drawn_[static_cast<std::size_t>(e)]) left.push_back(e);
        }
        return pick(left);
    }

    /// The loop that a directed edge (2e forwards, 2e + 1 backwards) runs into by always turning
    /// left most; empty where it meets drawn lines or is the outline.
    Trail turnLeftFrom(int directed) const {
        const int first = directed / 2;
        const auto& ends = graph_.edges[static_cast<std::size_t>(first)];
        const int start = directed % 2 == 0 ? ends[0] : ends[1];
        Trail loop{{start}, {}};
        double turned = 0.0;
        int edge = first;
        do {
            if (drawn_[static_cast<std::size_t>(edge)] || loop.edges.size() > graph_.edges.size()) {
                return {};
            }
            const int from = loop.nodes.back();
            const int to = graph_.other(edge, from);
            loop.edges.push_back(edge);
            loop.nodes.push_back(to);
            double turn = 0.0;
            const int next = leftMost(from, to, edge, turn);
            if (next < 0) return {};
            turned += turn;
            edge = next;
        } while (loop.nodes.back() != start || edge != first);
        return turned > 0.0 ? loop : Trail{};
    }

    int leftMost(int from, int to, int edge, double& turn) const {
        int best = -1;
        const Vec2 in = graph_.node(to) - graph_.node(from);
        for (const int e : graph_.edgesAt(to)) {
            if (e == edge) continue;
            const Vec2 out = graph_.node(graph_.other(e, to)) - graph_.node(to);
            const double angle = std::atan2(cross2(in, out), in.dot(out));
            if (best < 0 || angle > turn) {
                best = e;
                turn = angle;
            }
        }
        return best;
    }

    std::vector<int> wayToUndrawn(int start) const {
        std::vector<int> via(graph_.nodes.size(), -1);
        std::vector<bool> seen(graph_.nodes.size(), false);
        std::queue<int> queue;
        queue.push(start);
        seen[static_cast<std::size_t>(start)] = true;
        while (!queue.empty()) {
            const int n = queue.front();
            queue.pop();
            for (const int e : graph_.edgesAt(n)) {
                if (!drawn_[static_cast<std::size_t>(e)]) return traceBack(via, start, n);
                const int m = graph_.other(e, n);
                if (seen[static_cast<std::size_t>(m)]) continue;
                seen[static_cast<std::size_t>(m)] = true;
                via[static_cast<std::size_t>(m)] = e;
                queue.push(m);
            }
        }
        return {};
    }

    std::vector<int> traceBack(const std::vector<int>& via, int start, int node) const {
        std::vector<int> way;
        while (node != start) {
            const int e = via[static_cast<std::size_t>(node)];
            way.push_back(e);
            node = graph_.other(e, node);
        }
        std::reverse(way.begin(), way.end());
        return way;
    }

    const LineGraph& graph_;
    Random& random_;
    std::vector<bool> drawn_;
    std::vector<Trail> trails_;
};

std::vector<Trail> makeTrails(const LineGraph& graph, const HandHabits& habits, Random& random) {
    TrailMaker maker(graph, random);
    double pick = random.uniform();
    if ((pick -= habits.oneStrokePerEdge) < 0) {
        maker.singleEdges();
    } else if ((pick -= habits.shortTrails) < 0) {
        maker.walks(0.5);
    } else if ((pick -= habits.wholeFaces) < 0) {
        maker.faceLoops();
        maker.walks(0.5);
    } else if (random.chance(habits.withoutLifting)) {
        maker.withoutLifting();
    } else {
        maker.walks(1.0);
    }
    return maker.take();
}

/// A pen lift inside an edge: where the stroke before it ends and the one after it starts.
struct Lift {
    Vec2 end = Vec2::Zero();
    Vec2 start = Vec2::Zero();
    bool broken = false;
};

bool chooseLift(const Vec2& a, const Vec2& b, const HandLevel& level, const HandHabits& habits,
                Random& random, Lift& lift) {
    const double length = (b - a).norm();
    if (length < 2.0 * habits.shortestPiecePx + 10.0) return false;
    const bool broken = random.chance(level.breakProbability);
    if (!broken && !random.chance(habits.cutProbability)) return false;
    const double margin = std::max(0.25, (habits.shortestPiecePx + 4.0) / length);
    const double at = random.uniform(margin, 1.0 - margin) * length;
    double gap = 0.0;
    if (broken) gap = random.chance(0.7) ? random.uniform(2.0, 8.0) : random.uniform(-6.0, 0.0);
    const Vec2 along = (b - a) / length;
    lift = {a + (at - gap / 2) * along, a + (at + gap / 2) * along, broken};
    return true;
}

void addTrail(const LineGraph& graph, const Trail& trail, const HandLevel& level,
              const HandHabits& habits, Random& random, std::vector<PlannedStroke>& out) {
    PlannedStroke stroke;
    stroke.points.push_back(graph.node(trail.nodes.front()));
    for (std::size_t i = 0; i < trail.edges.size(); ++i) {
        const Vec2& a = graph.node(trail.nodes[i]);
        const Vec2& b = graph.node(trail.nodes[i + 1]);
        Lift lift;
        if (chooseLift(a, b, level, habits, random, lift)) {
            stroke.points.push_back(lift.end);
            stroke.brokenEnd = lift.broken;
            out.push_back(std::move(stroke));
            stroke = {};
            stroke.points.push_back(lift.start);
            stroke.brokenStart = lift.broken;
        }
        stroke.points.push_back(b);
    }
    out.push_back(std::move(stroke));
}

}  // namespace

std::vector<PlannedStroke> planStrokes(const std::vector<Line2>& lines, const HandLevel& level,
                                       const HandHabits& habits, Random& random) {
    const LineGraph graph = buildGraph(lines);
    std::vector<PlannedStroke> strokes;
    for (const Trail& trail : makeTrails(graph, habits, random)) {
        addTrail(graph, trail, level, habits, random, strokes);
    }
    for (const Line2& line : lines) {
        if (!random.chance(level.overtraceProbability)) continue;
        const double part = random.uniform(0.5, 1.1);
        const double start = random.uniform(std::min(0.0, 1.0 - part), std::max(0.0, 1.0 - part));
        const Vec2 whole = line[1] - line[0];
        strokes.push_back({{line[0] + start * whole, line[0] + (start + part) * whole}});
    }
    for (PlannedStroke& stroke : strokes) {
        if (!random.chance(0.5)) continue;
        std::reverse(stroke.points.begin(), stroke.points.end());
        std::swap(stroke.brokenStart, stroke.brokenEnd);
    }
    random.shuffle(strokes);
    return strokes;
}

}  // namespace ew
