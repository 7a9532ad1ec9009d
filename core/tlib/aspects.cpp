// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tlib/aspects.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

#include "core/base/tolerance.h"
#include "core/edge_graph/canonical.h"
#include "core/tlib/aspect_view.h"

namespace ew {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// Builds the visible graph of one view.
class Occlusion {
  public:
    Occlusion(const PolyhedronSpec& shape, const TemplateAnalysis& analysis, const AspectView& view)
        : shape_(shape), analysis_(analysis), view_(view) {}

    /// False where the view is accidental.
    bool run(Aspect& aspect) {
        const std::size_t n = analysis_.edges.size();
        splits_.assign(n, {0.0, 1.0});
        for (std::size_t e = 0; e < n; ++e) {
            drawn_.push_back(frontFacing(analysis_.edges[e].faces[0]) ||
                             frontFacing(analysis_.edges[e].faces[1]));
        }
        if (!analysis_.convex && !splitAtCrossings()) return false;
        std::vector<std::vector<std::array<double, 2>>> visible(n);
        for (std::size_t e = 0; e < n; ++e) {
            if (!drawn_[e]) continue;
            auto& cuts = splits_[e];
            std::sort(cuts.begin(), cuts.end());
            for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
                if (hidden(e, 0.5 * (cuts[i] + cuts[i + 1]))) continue;
                if (!visible[e].empty() && visible[e].back()[1] == cuts[i]) {
                    visible[e].back()[1] = cuts[i + 1];
                } else {
                    visible[e].push_back({cuts[i], cuts[i + 1]});
                }
            }
        }
        return assemble(visible, aspect);
    }

  private:
    struct Crossing {
        int front, back;  ///< edges
        double tFront, tBack;
    };

    bool frontFacing(int face) const { return view_.facing[at(face)] < 0; }
    Vec3 pointOn(std::size_t e, double t) const {
        const auto& ends = analysis_.edges[e].ends;
        return (1 - t) * view_.points[at(ends[0])] + t * view_.points[at(ends[1])];
    }

    bool splitAtCrossings() {
        const std::size_t n = analysis_.edges.size();
        for (std::size_t e = 0; e < n; ++e) {
            for (std::size_t f = e + 1; f < n; ++f) {
                if (!drawn_[e] || !drawn_[f]) continue;
                const auto& a = analysis_.edges[e].ends;
                const auto& b = analysis_.edges[f].ends;
                if (a[0] == b[0] || a[0] == b[1] || a[1] == b[0] || a[1] == b[1]) continue;
                const Vec2 p = view_.points[at(a[0])].head<2>();
                const Vec2 u = view_.points[at(a[1])].head<2>() - p;
                const Vec2 q = view_.points[at(b[0])].head<2>();
                const Vec2 v = view_.points[at(b[1])].head<2>() - q;
                const double sine = cross2(u, v);
                if (std::abs(sine) < 1e-12) continue;
                const double t = cross2(q - p, v) / sine;
                const double s = cross2(q - p, u) / sine;
                constexpr double m = tol::kAccidentalView;
                if (t < -m || t > 1 + m || s < -m || s > 1 + m) continue;
                if (t < m || t > 1 - m || s < m || s > 1 - m) return false;
                const bool eInFront = pointOn(e, t).z() < pointOn(f, s).z();
                splits_[e].push_back(t);
                splits_[f].push_back(s);
                if (eInFront) {
                    crossings_.push_back({static_cast<int>(e), static_cast<int>(f), t, s});
                } else {
                    crossings_.push_back({static_cast<int>(f), static_cast<int>(e), s, t});
                }
            }
        }
        return true;
    }

    bool hidden(std::size_t e, double t) const {
        if (analysis_.convex) return false;
        const Vec3 p = pointOn(e, t);
        for (std::size_t f = 0; f < shape_.faces.size(); ++f) {
            const int fi = static_cast<int>(f);
            if (!frontFacing(fi)) continue;
            if (analysis_.edges[e].faces[0] == fi || analysis_.edges[e].faces[1] == fi) continue;
            if (!insideLoop(view_, shape_.faces[f], p.head<2>())) continue;
            if (depthAt(f, p.head<2>()) < p.z() - 1e-9) return true;
        }
        return false;
    }

    double depthAt(std::size_t f, const Vec2& p) const {
        const auto& loop = shape_.faces[f];
        Vec3 n = Vec3::Zero();
        for (std::size_t i = 0; i < loop.size(); ++i) {
            n += view_.points[at(loop[i])].cross(view_.points[at(loop[(i + 1) % loop.size()])]);
        }
        const Vec3& q = view_.points[at(loop[0])];
        return q.z() - (n.x() * (p.x() - q.x()) + n.y() * (p.y() - q.y())) / n.z();
    }

    bool assemble(const std::vector<std::vector<std::array<double, 2>>>& visible, Aspect& aspect) {
        std::map<int, int> vertexOf;                // template vertex -> graph vertex
        std::map<std::pair<int, double>, int> tOf;  // (edge, t) -> T junction on it
        auto vertex = [&](int v) {
            const auto [it, added] = vertexOf.emplace(v, static_cast<int>(aspect.vertex.size()));
            if (added) {
                aspect.vertex.push_back(v);
                aspect.graph.points.emplace_back(view_.points[at(v)].head<2>());
            }
            return it->second;
        };
        // A visible edge that stops in the middle stops where it passes behind another: a T
        // junction there.
        std::map<int, std::vector<std::pair<double, int>>> onBar;
        for (std::size_t e = 0; e < visible.size(); ++e) {
            for (const auto& piece : visible[e]) {
                for (const double t : piece) {
                    if (t == 0.0 || t == 1.0) continue;
                    const auto c =
                        std::find_if(crossings_.begin(), crossings_.end(), [&](const Crossing& x) {
                            return x.back == static_cast<int>(e) && x.tBack == t;
                        });
                    if (c == crossings_.end()) return false;
                    const int id = static_cast<int>(aspect.vertex.size());
                    aspect.vertex.push_back(-1);
                    aspect.graph.points.emplace_back(pointOn(e, t).head<2>());
                    tOf[{static_cast<int>(e), t}] = id;
                    onBar[c->front].emplace_back(c->tFront, id);
                }
            }
        }
        for (std::size_t e = 0; e < visible.size(); ++e) {
            for (const auto& piece : visible[e]) {
                std::vector<std::pair<double, int>> stops;
                for (const double t : piece) {
                    const int v = t == 0.0   ? vertex(analysis_.edges[e].ends[0])
                                  : t == 1.0 ? vertex(analysis_.edges[e].ends[1])
                                             : tOf[{static_cast<int>(e), t}];
                    stops.emplace_back(t, v);
                }
                for (const auto& [t, id] : onBar[static_cast<int>(e)]) {
                    if (t > piece[0] && t < piece[1]) stops.emplace_back(t, id);
                }
                std::sort(stops.begin(), stops.end());
                for (std::size_t i = 0; i + 1 < stops.size(); ++i) {
                    aspect.graph.edges.push_back({stops[i].second, stops[i + 1].second});
                    aspect.edge.push_back(static_cast<int>(e));
                }
            }
        }
        return true;
    }

    const PolyhedronSpec& shape_;
    const TemplateAnalysis& analysis_;
    const AspectView& view_;
    std::vector<bool> drawn_;
    std::vector<std::vector<double>> splits_;
    std::vector<Crossing> crossings_;
};

}  // namespace

void indexAspect(Aspect& aspect) {
    aspect.form = canonicalForm(aspect.graph);
    if (aspect.form.walks.size() > 1) aspect.form.walks.resize(1);
    aspect.outer = outerVertices(aspect.graph);
}

Aspect viewAspect(const PolyhedronSpec& shape, const TemplateAnalysis& analysis,
                  const Vec3& direction) {
    Aspect aspect;
    const AspectView view = makeView(shape, analysis, direction);
    for (std::size_t f = 0; f < view.facing.size(); ++f) {
        if (std::abs(view.facing[f]) < tol::kAccidentalView) return {};
        if (view.facing[f] < 0) aspect.visibleFaces.push_back(static_cast<int>(f));
    }
    if (!Occlusion(shape, analysis, view).run(aspect)) return {};
    aspect.directions = {direction};
    aspect.name = "explicit-" + std::to_string(aspect.visibleFaces.size());
    return aspect;
}

std::vector<Aspect> explicitAspects(const Template& tmpl, const TemplateAnalysis& analysis) {
    std::vector<Aspect> aspects;
    std::map<std::string, std::size_t> known;
    std::map<std::vector<int>, std::size_t> knownMasks;
    for (const Vec3& d : spreadDirections(analysis.convex ? 400 : 300)) {
        std::vector<int> mask;
        bool accidental = false;
        for (std::size_t f = 0; f < analysis.faceNormals.size(); ++f) {
            const double facing = analysis.faceNormals[f].dot(d);
            accidental = accidental || std::abs(facing) < tol::kAccidentalView;
            if (facing < 0) mask.push_back(static_cast<int>(f));
        }
        if (accidental || mask.size() < 2) continue;
        if (analysis.convex) {
            // A convex shape's view is settled by which faces are seen.
            if (const auto it = knownMasks.find(mask); it != knownMasks.end()) {
                keepDirection(aspects[it->second], d);
                continue;
            }
        }
        Aspect aspect = viewAspect(tmpl.shape, analysis, d);
        if (aspect.name.empty()) continue;
        // Faces that are turned to the eye but hidden do not count as seen.
        if (!analysis.convex) {
            std::set<int> seen;
            for (std::size_t e = 0; e < aspect.edge.size(); ++e) {
                for (const int f : analysis.edges[at(aspect.edge[e])].faces) {
                    if (analysis.faceNormals[at(f)].dot(d) < 0) seen.insert(f);
                }
            }
            aspect.name = "explicit-" + std::to_string(seen.size());
        }
        const auto [it, added] = known.emplace(labelledKey(aspect), aspects.size());
        if (!added) {
            keepDirection(aspects[it->second], d);
            continue;
        }
        indexAspect(aspect);
        if (aspect.form.code.empty()) {
            known.erase(it);
            continue;
        }
        if (analysis.convex) knownMasks.emplace(mask, aspects.size());
        aspects.push_back(std::move(aspect));
    }
    return aspects;
}

std::vector<Aspect> edgeOnAspects(const Template& tmpl, const TemplateAnalysis& analysis) {
    std::vector<Aspect> aspects;
    if (!analysis.convex) return aspects;
    for (const AnalysedEdge& edge : analysis.edges) {
        const Vec3 direction =
            -(analysis.faceNormals[at(edge.faces[0])] + analysis.faceNormals[at(edge.faces[1])])
                 .normalized();
        AspectView view = makeView(tmpl.shape, analysis, direction);
        Aspect aspect;
        for (std::size_t f = 0; f < view.facing.size(); ++f) {
            if (std::abs(view.facing[f]) < tol::kAccidentalView) {
                aspect.edgeOn = true;
                view.facing[f] = 1.0;
            }
            if (view.facing[f] < 0) aspect.visibleFaces.push_back(static_cast<int>(f));
        }
        if (!aspect.edgeOn || aspect.visibleFaces.size() != 2) continue;
        if (!Occlusion(tmpl.shape, analysis, view).run(aspect)) continue;
        aspect.directions = {direction};
        aspect.name = "edge-on-2";
        indexAspect(aspect);
        if (!aspect.form.code.empty()) aspects.push_back(std::move(aspect));
    }
    return aspects;
}

}  // namespace ew
