// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/edge_graph/planarize.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "core/base/tolerance.h"

namespace ew {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

struct Attachment {
    double t;
    int vertex;
};

class Planarizer {
  public:
    Planarizer(const std::vector<InkLine>& lines, const PlanarizeOptions& options)
        : lines_(lines), options_(options), on_(lines.size()) {}

    RawGraph run(const std::vector<EndCluster>& clusters) {
        for (const EndCluster& c : clusters) {
            const int v = addVertex(c.position);
            for (const LineEnd& e : c.ends) attach(e.line, v);
        }
        for (std::size_t c = 0; c < clusters.size(); ++c) {
            if (clusters[c].ends.size() == 1) {
                landOnLine(clusters[c].ends[0], static_cast<int>(c));
            } else {
                passThrough(static_cast<int>(c));
            }
        }
        cutCrossings();
        return collect();
    }

  private:
    int addVertex(const Vec2& p) {
        graph_.vertices.push_back(p);
        cutLine_.push_back(-1);
        return static_cast<int>(graph_.vertices.size()) - 1;
    }
    double parameter(int line, const Vec2& p) const {
        return (p - lines_[at(line)].a).dot(lines_[at(line)].direction());
    }
    double offset(int line, const Vec2& p) const {
        return std::abs(cross2(lines_[at(line)].direction(), p - lines_[at(line)].a));
    }
    void attach(int line, int vertex) {
        on_[at(line)].push_back({parameter(line, graph_.vertices[at(vertex)]), vertex});
    }
    bool attached(int line, int vertex) const {
        return std::any_of(on_[at(line)].begin(), on_[at(line)].end(),
                           [&](const Attachment& a) { return a.vertex == vertex; });
    }
    /// Parameters of the line's own two ends.
    std::array<double, 2> span(int line) const {
        const auto& own = on_[at(line)];
        return {std::min(own[0].t, own[1].t), std::max(own[0].t, own[1].t)};
    }
    bool inside(int line, double t) const {
        const auto s = span(line);
        const double margin =
            std::min(0.5 * options_.join.distancePx, 0.2 * lines_[at(line)].length());
        return t > s[0] + margin && t < s[1] - margin;
    }

    /// A lone end close to the inside of another line: a T junction there.
    void landOnLine(const LineEnd& end, int vertex) {
        const InkLine& stem = lines_[at(end.line)];
        const Vec2 p = graph_.vertices[at(vertex)];
        const double reach = joinReach(stem, options_.join);
        double nearest = std::numeric_limits<double>::infinity();
        int bar = -1;
        for (std::size_t l = 0; l < lines_.size(); ++l) {
            const int line = static_cast<int>(l);
            if (line == end.line || attached(line, vertex)) continue;
            const double d = offset(line, p);
            if (d < nearest && d <= reach && inside(line, parameter(line, p))) {
                nearest = d;
                bar = line;
            }
        }
        if (bar < 0) return;
        // The stem's direction tells better than its end where it meets the bar.
        const Vec2 d1 = stem.direction();
        const Vec2 d2 = lines_[at(bar)].direction();
        const double sine = cross2(d1, d2);
        Vec2 x = lines_[at(bar)].a + d2 * parameter(bar, p);
        if (std::abs(sine) > 0.25) {
            x = stem.a + d1 * (cross2(lines_[at(bar)].a - stem.a, d2) / sine);
        }
        graph_.vertices[at(vertex)] = x;
        for (Attachment& a : on_[at(end.line)]) {
            if (a.vertex == vertex) a.t = parameter(end.line, x);
        }
        attach(bar, vertex);
    }

    /// A junction of several ends that lies on another line: that line runs through it.
    void passThrough(int vertex) {
        const Vec2 p = graph_.vertices[at(vertex)];
        for (std::size_t l = 0; l < lines_.size(); ++l) {
            const int line = static_cast<int>(l);
            if (attached(line, vertex)) continue;
            const double reach = std::min(options_.throughReach * options_.join.distancePx,
                                          0.2 * lines_[l].length());
            if (offset(line, p) <= reach && inside(line, parameter(line, p))) attach(line, vertex);
        }
    }

    /// Does a vertex of line m lie on the line that is being cut?
    bool meetsCutLine(int l, int m) const {
        return std::any_of(on_[at(m)].begin(), on_[at(m)].end(),
                           [&](const Attachment& a) { return cutLine_[at(a.vertex)] == l; });
    }
    void attachToCutLine(int l, int vertex) {
        attach(l, vertex);
        cutLine_[at(vertex)] = l;
    }

    /// The vertex of `line` nearest to parameter t, if it is close.
    std::optional<int> vertexNear(int line, double t) const {
        const double reach =
            std::min(0.6 * options_.join.distancePx, 0.2 * lines_[at(line)].length());
        std::optional<int> best;
        double nearest = reach;
        for (const Attachment& a : on_[at(line)]) {
            if (std::abs(a.t - t) <= nearest) {
                nearest = std::abs(a.t - t);
                best = a.vertex;
            }
        }
        return best;
    }

    void cutCrossings() {
        const int n = static_cast<int>(lines_.size());
        for (int l = 0; l < n; ++l) {
            for (const Attachment& a : on_[at(l)]) cutLine_[at(a.vertex)] = l;
            for (int m = l + 1; m < n; ++m) {
                const Vec2 dl = lines_[at(l)].direction();
                const Vec2 dm = lines_[at(m)].direction();
                const double sine = cross2(dl, dm);
                if (std::abs(sine) < 0.03) continue;
                const double t = cross2(lines_[at(m)].a - lines_[at(l)].a, dm) / sine;
                const auto sl = span(l);
                if (t <= sl[0] || t >= sl[1]) continue;
                const Vec2 x = lines_[at(l)].a + dl * t;
                const double u = parameter(m, x);
                const auto sm = span(m);
                if (u <= sm[0] || u >= sm[1]) continue;
                if (meetsCutLine(l, m)) continue;
                const auto vl = vertexNear(l, t);
                const auto vm = vertexNear(m, u);
                if (vl) {
                    attach(m, *vl);
                } else if (vm) {
                    attachToCutLine(l, *vm);
                } else {
                    const int v = addVertex(x);
                    attachToCutLine(l, v);
                    attach(m, v);
                }
            }
        }
    }

    RawGraph collect() {
        for (std::size_t l = 0; l < lines_.size(); ++l) {
            auto& list = on_[l];
            std::stable_sort(list.begin(), list.end(),
                             [](const Attachment& a, const Attachment& b) { return a.t < b.t; });
            for (std::size_t i = 0; i + 1 < list.size(); ++i) {
                if (list[i].vertex == list[i + 1].vertex) continue;
                RawGraph::Edge e;
                e.v = {list[i].vertex, list[i + 1].vertex};
                e.pieces = {{static_cast<int>(l), list[i].t, list[i + 1].t}};
                graph_.edges.push_back(std::move(e));
            }
        }
        return std::move(graph_);
    }

    const std::vector<InkLine>& lines_;
    const PlanarizeOptions& options_;
    std::vector<std::vector<Attachment>> on_;
    std::vector<int> cutLine_;  ///< by vertex: the last line that was cut and runs through it
    RawGraph graph_;
};

}  // namespace

std::vector<std::vector<int>> RawGraph::incidence() const {
    std::vector<std::vector<int>> result(vertices.size());
    for (std::size_t e = 0; e < edges.size(); ++e) {
        if (!edges[e].alive) continue;
        for (const int v : edges[e].v) result[at(v)].push_back(static_cast<int>(e));
    }
    return result;
}

RawGraph planarize(const std::vector<InkLine>& lines, const std::vector<EndCluster>& clusters,
                   const PlanarizeOptions& options) {
    return Planarizer(lines, options).run(clusters);
}

}  // namespace ew
