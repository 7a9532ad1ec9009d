// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tlib/matcher.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <tuple>

#include "core/base/tolerance.h"

namespace ew {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }
constexpr double kRadian = 180.0 / std::numbers::pi;

/// Edge angles in [0, pi) and lengths, measured once a drawing.
struct Drawn {
    std::vector<double> angle;
    std::vector<double> length;

    explicit Drawn(const EdgeGraph& graph) {
        for (const GraphEdge& e : graph.edges) {
            const Vec2 d = e.tips[1] - e.tips[0];
            double a = std::atan2(d.y(), d.x());
            if (a < 0) a += std::numbers::pi;
            angle.push_back(a);
            length.push_back(
                (graph.junctions[at(e.ends[1])].position - graph.junctions[at(e.ends[0])].position)
                    .norm());
        }
    }
};

/// Angle modulo pi folded to [-pi/2, pi/2).
double fold(double a) {
    constexpr double pi = std::numbers::pi;
    return a - pi * std::floor(a / pi + 0.5);
}

/// Fills parallelDeg: for each direction class the length-weighted mean, then the worst deviation.
void measureParallels(GraphMatch& m, const Drawn& drawn, double excusePx) {
    const TemplateAnalysis& a = m.entry->analysis;
    std::vector<Vec2> mean(at(a.classCount), Vec2::Zero());
    for (std::size_t e = 0; e < m.edge.size(); ++e) {
        // Doubled angles: directions without sense.
        mean[at(a.edges[at(m.edge[e])].directionClass)] +=
            drawn.length[e] * Vec2(std::cos(2 * drawn.angle[e]), std::sin(2 * drawn.angle[e]));
    }
    for (std::size_t e = 0; e < m.edge.size(); ++e) {
        const Vec2& v = mean[at(a.edges[at(m.edge[e])].directionClass)];
        const double off =
            std::abs(fold(drawn.angle[e] - 0.5 * std::atan2(v.y(), v.x()))) * kRadian;
        const double excuse = std::atan(excusePx / std::max(drawn.length[e], 1.0)) * kRadian;
        m.parallelDeg = std::max(m.parallelDeg, off - excuse);
    }
}

void measureBars(GraphMatch& m, const EdgeGraph& graph, const Drawn& drawn) {
    for (std::size_t v = 0; v < m.vertex.size(); ++v) {
        if (m.vertex[v] >= 0) continue;
        std::vector<std::size_t> around;
        for (std::size_t e = 0; e < graph.edges.size(); ++e) {
            if (graph.edges[e].ends[0] == static_cast<int>(v) ||
                graph.edges[e].ends[1] == static_cast<int>(v)) {
                around.push_back(e);
            }
        }
        for (std::size_t i = 0; i < around.size(); ++i) {
            for (std::size_t j = i + 1; j < around.size(); ++j) {
                if (m.edge[around[i]] != m.edge[around[j]]) continue;
                m.bentDeg = std::max(
                    m.bentDeg,
                    std::abs(fold(drawn.angle[around[i]] - drawn.angle[around[j]])) * kRadian);
            }
        }
    }
}

/// The least image of a vertex map under the template's symmetries: equal for equivalent matches.
std::vector<int> orbitKey(const GraphMatch& m) {
    std::vector<int> best;
    for (const auto& map : m.entry->symmetries) {
        std::vector<int> image;
        image.reserve(m.vertex.size());
        for (const int v : m.vertex) image.push_back(v < 0 ? -1 : map[at(v)]);
        if (best.empty() || image < best) best = std::move(image);
    }
    return best;
}

class Matcher {
  public:
    Matcher(const EdgeGraph& graph, const LibraryIndex& library, const MatchOptions& options)
        : graph_(graph),
          library_(library),
          options_(options),
          drawn_(graph),
          plane_(planeGraph(graph)),
          form_(canonicalForm(plane_)),
          outer_(outerVertices(plane_)) {}

    std::vector<GraphMatch> run() {
        if (form_.code.empty()) return {};
        if (const auto it = library_.byCode.find(form_.code); it != library_.byCode.end()) {
            for (const AspectRef& ref : it->second) {
                const auto& entry = library_.entries[at(ref.entry)];
                if (!wanted(*entry)) continue;
                // Shares ownership with the entry.
                tryAspect(ref.entry, entry,
                          std::shared_ptr<const Aspect>(entry, &entry->aspects[at(ref.aspect)]), 0);
            }
        }
        if (options_.allowMissing) tryIncomplete();
        std::stable_sort(found_.begin(), found_.end(),
                         [](const GraphMatch& a, const GraphMatch& b) {
                             return a.parallelDeg + a.bentDeg + 20 * a.missingEdges <
                                    b.parallelDeg + b.bentDeg + 20 * b.missingEdges;
                         });
        if (found_.size() > options_.maxMatches) found_.resize(options_.maxMatches);
        return std::move(found_);
    }

  private:
    bool wanted(const LibraryEntry& entry) const {
        return options_.templateId.empty() || entry.tmpl.id == options_.templateId;
    }

    void tryIncomplete() {
        const auto it = library_.bySignature.find(graphSignature(plane_));
        if (it == library_.bySignature.end()) return;
        int tried = 0;
        for (const AspectRef& ref : it->second) {
            const auto& entry = library_.entries[at(ref.entry)];
            if (!wanted(*entry)) continue;
            if (++tried > 400)
                break;  // a library of look-alikes: the first are as good as the rest
            const Aspect& whole = entry->aspects[at(ref.aspect)];
            auto less = std::make_shared<const Aspect>(withoutEdge(whole, ref.removedEdge));
            const int missing =
                static_cast<int>(whole.graph.edges.size() - less->graph.edges.size());
            tryAspect(ref.entry, entry, less, missing);
        }
    }

    void tryAspect(int id, const std::shared_ptr<const LibraryEntry>& entry,
                   const std::shared_ptr<const Aspect>& aspect, int missing) {
        if (aspect->form.code != form_.code) return;
        const CanonicalWalk& theirs = aspect->form.walks.front();
        for (const CanonicalWalk& ours : form_.walks) {
            GraphMatch m;
            m.entry = entry;
            m.aspect = aspect;
            m.mirrored = ours.mirrored != theirs.mirrored;
            m.missingEdges = missing;
            m.vertex.assign(plane_.points.size(), -1);
            std::vector<int> aspectVertex(plane_.points.size(), -1);
            bool sameOutline = true;  // the code knows the sphere only, not which face is outside
            for (std::size_t i = 0; i < ours.vertices.size(); ++i) {
                sameOutline = sameOutline &&
                              outer_[at(ours.vertices[i])] == aspect->outer[at(theirs.vertices[i])];
                aspectVertex[at(ours.vertices[i])] = theirs.vertices[i];
                m.vertex[at(ours.vertices[i])] = aspect->vertex[at(theirs.vertices[i])];
            }
            if (!sameOutline || !mapEdges(m, *aspect, aspectVertex)) continue;
            // Implicit aspects say more than which vertex is where.
            const void* kind = aspect->kind == AspectKind::Explicit ? nullptr : aspect.get();
            if (!known_.insert({id, kind, orbitKey(m)}).second) continue;
            measureParallels(m, drawn_,
                             std::max(tol::kTurnExcuse * options_.distancePx,
                                      tol::kTurnSpreads * options_.spreadPx));
            measureBars(m, graph_, drawn_);
            found_.push_back(std::move(m));
        }
    }

    bool mapEdges(GraphMatch& m, const Aspect& aspect, const std::vector<int>& aspectVertex) const {
        for (const auto& e : plane_.edges) {
            const auto want = std::minmax(aspectVertex[at(e[0])], aspectVertex[at(e[1])]);
            int image = -1;
            for (std::size_t f = 0; f < aspect.graph.edges.size(); ++f) {
                const auto have = std::minmax(aspect.graph.edges[f][0], aspect.graph.edges[f][1]);
                if (have == want) image = aspect.edge[f];
            }
            if (image < 0) return false;
            m.edge.push_back(image);
        }
        return true;
    }

    const EdgeGraph& graph_;
    const LibraryIndex& library_;
    const MatchOptions& options_;
    Drawn drawn_;
    PlaneGraph plane_;
    CanonicalForm form_;
    std::vector<bool> outer_;
    std::set<std::tuple<int, const void*, std::vector<int>>> known_;
    std::vector<GraphMatch> found_;
};

}  // namespace

PlaneGraph planeGraph(const EdgeGraph& graph) {
    PlaneGraph plane;
    for (const Junction& j : graph.junctions) plane.points.push_back(j.position);
    for (const GraphEdge& e : graph.edges) plane.edges.push_back(e.ends);
    return plane;
}

void measureMatch(GraphMatch& match, const EdgeGraph& graph, double excusePx) {
    const Drawn drawn(graph);
    match.parallelDeg = match.bentDeg = 0.0;
    measureParallels(match, drawn, excusePx);
    measureBars(match, graph, drawn);
}

std::vector<GraphMatch> matchGraph(const EdgeGraph& graph, const LibraryIndex& library,
                                   const MatchOptions& options) {
    return Matcher(graph, library, options).run();
}

}  // namespace ew
