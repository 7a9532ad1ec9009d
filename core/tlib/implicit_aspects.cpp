// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

#include "core/base/tolerance.h"
#include "core/tlib/aspect_view.h"

namespace ew {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

constexpr std::size_t kLargestMouth = 4;
constexpr int kCavityDirections = 120;
constexpr std::array<double, 3> kStretches{1.0, 0.3, 3.0};

/// All connected subsets of the faces, up to kLargestMouth each, ascending.
std::set<std::vector<int>> connectedSubsets(const std::vector<int>& faces,
                                            const TemplateAnalysis& analysis) {
    std::set<std::vector<int>> found;
    std::vector<std::vector<int>> open;
    for (const int f : faces) open.push_back({f});
    while (!open.empty()) {
        std::vector<int> set = std::move(open.back());
        open.pop_back();
        if (!found.insert(set).second || set.size() == kLargestMouth) continue;
        for (const AnalysedEdge& e : analysis.edges) {
            for (std::size_t side = 0; side < 2; ++side) {
                const int in = e.faces[side];
                const int out = e.faces[1 - side];
                if (!std::binary_search(set.begin(), set.end(), in)) continue;
                if (std::binary_search(set.begin(), set.end(), out)) continue;
                if (std::find(faces.begin(), faces.end(), out) == faces.end()) continue;
                std::vector<int> more = set;
                more.insert(std::upper_bound(more.begin(), more.end(), out), out);
                open.push_back(std::move(more));
            }
        }
    }
    return found;
}

/// Builds one implicit aspect from a view; false where the view is accidental or shows nothing.
class ImplicitView {
  public:
    ImplicitView(const PolyhedronSpec& shape, const TemplateAnalysis& analysis,
                 const AspectView& view, const std::vector<int>& mouth, Aspect& out)
        : shape_(shape), analysis_(analysis), view_(view), mouth_(mouth), out_(out) {}

    bool outlines() {
        for (std::size_t e = 0; e < analysis_.edges.size(); ++e) {
            if (mouthFaces(e) > 0) addEdge(e);
        }
        return !selfCrossing();
    }

    bool throughTheMouth() {
        for (std::size_t e = 0; e < analysis_.edges.size(); ++e) {
            if (mouthFaces(e) == 1) rim_.push_back(e);
        }
        std::vector<Piece> pieces;
        for (std::size_t e = 0; e < analysis_.edges.size(); ++e) {
            const auto& faces = analysis_.edges[e].faces;
            if (mouthFaces(e) > 0 || view_.facing[at(faces[0])] < 0 ||
                view_.facing[at(faces[1])] < 0) {
                continue;
            }
            if (!clip(e, pieces)) return false;
        }
        if (pieces.empty()) return false;
        addRim(pieces);
        for (const Piece& p : pieces) {
            out_.graph.edges.push_back({p.ends[0], p.ends[1]});
            out_.edge.push_back(static_cast<int>(p.edge));
        }
        return true;
    }

  private:
    /// A visible stretch of a wall's edge between two graph vertices.
    struct Piece {
        std::size_t edge;
        std::array<int, 2> ends;
    };
    struct OnRim {
        double t;
        int vertex;
    };

    int mouthFaces(std::size_t e) const {
        int count = 0;
        for (const int f : analysis_.edges[e].faces) {
            count += std::binary_search(mouth_.begin(), mouth_.end(), f) ? 1 : 0;
        }
        return count;
    }

    Vec2 point(int v) const { return view_.points[at(v)].head<2>(); }

    int vertex(int v) {
        const auto [it, added] = vertexOf_.emplace(v, static_cast<int>(out_.vertex.size()));
        if (added) {
            out_.vertex.push_back(v);
            out_.graph.points.push_back(point(v));
        }
        return it->second;
    }

    void addEdge(std::size_t e) {
        const auto& ends = analysis_.edges[e].ends;
        out_.graph.edges.push_back({vertex(ends[0]), vertex(ends[1])});
        out_.edge.push_back(static_cast<int>(e));
    }

    bool selfCrossing() const {
        for (std::size_t i = 0; i < out_.graph.edges.size(); ++i) {
            for (std::size_t j = i + 1; j < out_.graph.edges.size(); ++j) {
                const auto& a = out_.graph.edges[i];
                const auto& b = out_.graph.edges[j];
                if (a[0] == b[0] || a[0] == b[1] || a[1] == b[0] || a[1] == b[1]) continue;
                double t = 0;
                double s = 0;
                if (cross(out_.graph.points[at(a[0])], out_.graph.points[at(a[1])],
                          out_.graph.points[at(b[0])], out_.graph.points[at(b[1])], t, s) &&
                    t > 0 && t < 1 && s > 0 && s < 1) {
                    return true;
                }
            }
        }
        return false;
    }

    static bool cross(const Vec2& p, const Vec2& p1, const Vec2& q, const Vec2& q1, double& t,
                      double& s) {
        const Vec2 u = p1 - p;
        const Vec2 v = q1 - q;
        const double sine = cross2(u, v);
        if (std::abs(sine) < 1e-12) return false;
        t = cross2(q - p, v) / sine;
        s = cross2(q - p, u) / sine;
        return true;
    }

    bool inMouth(const Vec2& p) const {
        return std::any_of(mouth_.begin(), mouth_.end(),
                           [&](int f) { return insideLoop(view_, shape_.faces[at(f)], p); });
    }

    bool clip(std::size_t e, std::vector<Piece>& pieces) {
        const auto& ends = analysis_.edges[e].ends;
        const Vec2 a = point(ends[0]);
        const Vec2 b = point(ends[1]);
        std::vector<std::array<double, 3>> cuts;  // t here, rim index, t there
        for (std::size_t r = 0; r < rim_.size(); ++r) {
            const auto& bar = analysis_.edges[rim_[r]].ends;
            if (bar[0] == ends[0] || bar[0] == ends[1] || bar[1] == ends[0] || bar[1] == ends[1]) {
                continue;
            }
            double t = 0;
            double s = 0;
            if (!cross(a, b, point(bar[0]), point(bar[1]), t, s)) continue;
            constexpr double m = tol::kAccidentalView;
            if (t < -m || t > 1 + m || s < -m || s > 1 + m) continue;
            if (t < m || t > 1 - m || s < m || s > 1 - m) return false;
            cuts.push_back({t, static_cast<double>(r), s});
        }
        std::sort(cuts.begin(), cuts.end());
        std::vector<double> stops{0.0};
        for (const auto& c : cuts) stops.push_back(c[0]);
        stops.push_back(1.0);
        for (std::size_t i = 0; i + 1 < stops.size(); ++i) {
            if (!inMouth(a + 0.5 * (stops[i] + stops[i + 1]) * (b - a))) continue;
            Piece piece{e, {-1, -1}};
            for (std::size_t side = 0; side < 2; ++side) {
                const std::size_t stop = i + side;
                if (stop == 0 || stop + 1 == stops.size()) {
                    piece.ends[side] = vertex(ends[stop == 0 ? 0 : 1]);
                } else {
                    const auto& c = cuts[stop - 1];
                    piece.ends[side] = static_cast<int>(out_.vertex.size());
                    out_.vertex.push_back(-1);
                    out_.graph.points.emplace_back(a + c[0] * (b - a));
                    onRim_[static_cast<std::size_t>(c[1])].push_back({c[2], piece.ends[side]});
                }
            }
            pieces.push_back(piece);
        }
        return true;
    }

    void addRim(const std::vector<Piece>&) {
        for (std::size_t r = 0; r < rim_.size(); ++r) {
            const auto& ends = analysis_.edges[rim_[r]].ends;
            std::vector<OnRim> stops = onRim_[r];
            stops.push_back({0.0, vertex(ends[0])});
            stops.push_back({1.0, vertex(ends[1])});
            std::sort(stops.begin(), stops.end(),
                      [](const OnRim& x, const OnRim& y) { return x.t < y.t; });
            for (std::size_t i = 0; i + 1 < stops.size(); ++i) {
                out_.graph.edges.push_back({stops[i].vertex, stops[i + 1].vertex});
                out_.edge.push_back(static_cast<int>(rim_[r]));
            }
        }
    }

    const PolyhedronSpec& shape_;
    const TemplateAnalysis& analysis_;
    const AspectView& view_;
    const std::vector<int>& mouth_;
    Aspect& out_;
    std::vector<std::size_t> rim_;
    std::map<int, int> vertexOf_;
    std::map<std::size_t, std::vector<OnRim>> onRim_;
};

/// The shape stretched along the mean normal of some faces: planes stay planes.
PolyhedronSpec stretched(const PolyhedronSpec& shape, const Vec3& normal, double factor) {
    PolyhedronSpec out = shape;
    for (Vec3& p : out.vertices) p += (factor - 1.0) * normal * normal.dot(p);
    return out;
}

TemplateAnalysis withNormals(TemplateAnalysis analysis, const PolyhedronSpec& shape) {
    for (std::size_t f = 0; f < shape.faces.size(); ++f) {
        Vec3 n = Vec3::Zero();
        const auto& loop = shape.faces[f];
        for (std::size_t i = 0; i < loop.size(); ++i) {
            n += shape.vertices[at(loop[i])].cross(shape.vertices[at(loop[(i + 1) % loop.size()])]);
        }
        analysis.faceNormals[f] = n.normalized();
    }
    return analysis;
}

class Collector {
  public:
    Collector(const Template& tmpl, const TemplateAnalysis& analysis)
        : tmpl_(tmpl), analysis_(analysis) {}

    std::vector<Aspect> run() {
        for (const Vec3& d : spreadDirections(kCavityDirections)) look(d);
        return std::move(aspects_);
    }

  private:
    void look(const Vec3& d) {
        std::vector<int> front;
        for (std::size_t f = 0; f < analysis_.faceNormals.size(); ++f) {
            const double facing = analysis_.faceNormals[f].dot(d);
            if (std::abs(facing) < tol::kAccidentalView) return;
            if (facing < 0) front.push_back(static_cast<int>(f));
        }
        for (const std::vector<int>& mouth : connectedSubsets(front, analysis_)) {
            if (mouth.size() >= 2) {
                add(tmpl_.shape, analysis_, d, mouth, AspectKind::Mouth);
            }
            if (!analysis_.convex) continue;
            Vec3 normal = Vec3::Zero();
            for (const int f : mouth) normal += analysis_.faceNormals[at(f)];
            if (normal.norm() < 1e-6) continue;
            normal.normalize();
            for (const double factor : kStretches) {
                const PolyhedronSpec shape = stretched(tmpl_.shape, normal, factor);
                add(shape, withNormals(analysis_, shape), d, mouth, AspectKind::Cavity);
            }
        }
    }

    void add(const PolyhedronSpec& shape, const TemplateAnalysis& analysis, const Vec3& d,
             const std::vector<int>& mouth, AspectKind kind) {
        const AspectView view = makeView(shape, analysis, d);
        for (const double facing : view.facing) {
            if (std::abs(facing) < tol::kAccidentalView) return;
        }
        for (const int f : mouth) {
            if (view.facing[at(f)] >= 0) return;
        }
        Aspect aspect;
        aspect.kind = kind;
        aspect.mouth = mouth;
        aspect.directions = {d};
        ImplicitView builder(shape, analysis, view, mouth, aspect);
        const bool mouthOnly = kind == AspectKind::Mouth;
        if (!(mouthOnly ? builder.outlines() : builder.throughTheMouth())) return;
        aspect.name = (mouthOnly ? "mouth-" : "cavity-") + std::to_string(mouth.size());
        for (std::size_t f = 0; f < view.facing.size(); ++f) {
            const int fi = static_cast<int>(f);
            const bool isMouth = std::binary_search(mouth.begin(), mouth.end(), fi);
            if (mouthOnly ? isMouth : view.facing[f] > 0) aspect.visibleFaces.push_back(fi);
        }
        std::string key = aspect.name + labelledKey(aspect);
        for (const int f : mouth) key += "m" + std::to_string(f);
        if (!known_.insert(key).second) return;
        indexAspect(aspect);
        if (aspect.form.code.empty()) return;
        for (std::size_t v = 0; v < aspect.vertex.size(); ++v) {
            if (aspect.vertex[v] < 0) addMerged(aspect, static_cast<int>(v));
        }
        aspects_.push_back(std::move(aspect));
    }

    /// The same with a T junction drawn so near to a corner of the mouth that it is that corner.
    void addMerged(const Aspect& whole, int t) {
        for (std::size_t e = 0; e < whole.graph.edges.size(); ++e) {
            const auto& ends = whole.graph.edges[e];
            if (ends[0] != t && ends[1] != t) continue;
            const int corner = ends[0] == t ? ends[1] : ends[0];
            if (!onRim(whole, e) || whole.vertex[at(corner)] < 0) continue;
            Aspect a;
            a.kind = whole.kind;
            a.name = whole.name;
            a.mouth = whole.mouth;
            a.visibleFaces = whole.visibleFaces;
            a.directions = whole.directions;
            const auto renamed = [&](int v) {
                const int w = v == t ? corner : v;
                return w > t ? w - 1 : w;
            };
            for (std::size_t v = 0; v < whole.vertex.size(); ++v) {
                if (static_cast<int>(v) == t) continue;
                a.vertex.push_back(whole.vertex[v]);
                a.graph.points.push_back(whole.graph.points[v]);
            }
            for (std::size_t k = 0; k < whole.graph.edges.size(); ++k) {
                if (k == e) continue;
                a.graph.edges.push_back(
                    {renamed(whole.graph.edges[k][0]), renamed(whole.graph.edges[k][1])});
                a.edge.push_back(whole.edge[k]);
            }
            std::string key = a.name + "t" + labelledKey(a);
            for (const int f : a.mouth) key += "m" + std::to_string(f);
            if (!known_.insert(key).second) continue;
            indexAspect(a);
            if (!a.form.code.empty()) aspects_.push_back(std::move(a));
        }
    }

    bool onRim(const Aspect& a, std::size_t graphEdge) const {
        int count = 0;
        for (const int f : analysis_.edges[at(a.edge[graphEdge])].faces) {
            count += std::binary_search(a.mouth.begin(), a.mouth.end(), f) ? 1 : 0;
        }
        return count == 1;
    }

    const Template& tmpl_;
    const TemplateAnalysis& analysis_;
    std::set<std::string> known_;
    std::vector<Aspect> aspects_;
};

}  // namespace

std::vector<Aspect> implicitAspects(const Template& tmpl, const TemplateAnalysis& analysis) {
    return Collector(tmpl, analysis).run();
}

}  // namespace ew
