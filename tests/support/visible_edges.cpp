// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/visible_edges.h"

#include <algorithm>
#include <map>
#include <set>

namespace ew::test {
namespace {

constexpr double kDepthSlackPx = 1e-6;  ///< a face must be this much nearer to hide something

/// The polyhedron as the camera sees it: x right, y down, z away from the eye, all [px].
struct SeenPolyhedron {
    const PolyhedronSpec& spec;
    std::vector<Vec3> points;

    Vec2 flat(int v) const { return points[static_cast<std::size_t>(v)].head<2>(); }
    const Vec3& point(int v) const { return points[static_cast<std::size_t>(v)]; }
};

bool insideLoop(const SeenPolyhedron& seen, const std::vector<int>& face, const Vec2& p) {
    bool inside = false;
    for (std::size_t i = 0; i < face.size(); ++i) {
        const Vec2 a = seen.flat(face[i]);
        const Vec2 b = seen.flat(face[(i + 1) % face.size()]);
        if ((a.y() > p.y()) == (b.y() > p.y())) continue;
        const double x = a.x() + (p.y() - a.y()) / (b.y() - a.y()) * (b.x() - a.x());
        if (p.x() < x) inside = !inside;
    }
    return inside;
}

/// True where a face other than the edge's own two lies between the eye and the point.
bool hidden(const SeenPolyhedron& seen, const SpecEdge& edge, const Vec3& p) {
    for (std::size_t f = 0; f < seen.spec.faces.size(); ++f) {
        if (edge.faces[0] == static_cast<int>(f) || edge.faces[1] == static_cast<int>(f)) continue;
        const std::vector<int>& face = seen.spec.faces[f];
        if (!insideLoop(seen, face, p.head<2>())) continue;
        Vec3 n = Vec3::Zero();
        for (std::size_t i = 0; i < face.size(); ++i) {
            n += seen.point(face[i]).cross(seen.point(face[(i + 1) % face.size()]));
        }
        if (std::abs(n.z()) < 1e-12 * n.norm()) continue;
        const Vec3 d = p - seen.point(face[0]);
        const double faceDepth = seen.point(face[0]).z() - (n.x() * d.x() + n.y() * d.y()) / n.z();
        if (faceDepth < p.z() - kDepthSlackPx) return true;
    }
    return false;
}

/// Parameters 0..1 at which the projection of another edge crosses, with both ends, ascending.
std::vector<double> splits(const SeenPolyhedron& seen, const std::vector<SpecEdge>& edges,
                           const SpecEdge& edge) {
    std::vector<double> at{0.0, 1.0};
    const Vec2 a = seen.flat(edge.ends[0]);
    const Vec2 d = seen.flat(edge.ends[1]) - a;
    for (const SpecEdge& other : edges) {
        const Vec2 b = seen.flat(other.ends[0]);
        const Vec2 e = seen.flat(other.ends[1]) - b;
        const double det = cross2(d, e);
        if (std::abs(det) < 1e-9 * d.norm() * e.norm()) continue;
        const double t = cross2(b - a, e) / det;
        const double u = cross2(b - a, d) / det;
        if (t > 1e-9 && t < 1.0 - 1e-9 && u > 1e-9 && u < 1.0 - 1e-9) at.push_back(t);
    }
    std::sort(at.begin(), at.end());
    return at;
}

}  // namespace

std::vector<SpecEdge> specEdges(const PolyhedronSpec& spec) {
    std::vector<SpecEdge> edges;
    std::map<std::array<int, 2>, std::size_t> known;
    for (std::size_t f = 0; f < spec.faces.size(); ++f) {
        const std::vector<int>& face = spec.faces[f];
        for (std::size_t i = 0; i < face.size(); ++i) {
            const int a = face[i];
            const int b = face[(i + 1) % face.size()];
            const auto twin = known.find({b, a});
            if (twin != known.end()) {
                edges[twin->second].faces[1] = static_cast<int>(f);
                continue;
            }
            known[{a, b}] = edges.size();
            edges.push_back({{a, b}, {static_cast<int>(f), -1}});
        }
    }
    return edges;
}

double specVolume(const PolyhedronSpec& spec) {
    double six = 0.0;
    const Vec3 origin = spec.vertices.empty() ? Vec3(Vec3::Zero()) : spec.vertices.front();
    const auto point = [&](int v) -> Vec3 {
        return spec.vertices[static_cast<std::size_t>(v)] - origin;
    };
    for (const std::vector<int>& face : spec.faces) {
        for (std::size_t i = 2; i < face.size(); ++i) {
            six += point(face[0]).dot(point(face[i - 1]).cross(point(face[i])));
        }
    }
    return six / 6.0;
}

Vec3 specFaceNormal(const PolyhedronSpec& spec, std::size_t face) {
    Vec3 n = Vec3::Zero();
    const std::vector<int>& loop = spec.faces[face];
    const Vec3 origin = spec.vertices[static_cast<std::size_t>(loop[0])];
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const Vec3 a = spec.vertices[static_cast<std::size_t>(loop[i])] - origin;
        const Vec3 b =
            spec.vertices[static_cast<std::size_t>(loop[(i + 1) % loop.size()])] - origin;
        n += a.cross(b);
    }
    return n.normalized();
}

std::vector<Line2> VisibleDrawing::lines() const {
    std::vector<Line2> out;
    for (const VisibleEdge& e : edges) out.push_back(e.line);
    return out;
}

VisibleDrawing visibleEdges(const PolyhedronSpec& spec, const OrthographicCamera& camera) {
    SeenPolyhedron seen{spec, {}};
    for (const Vec3& v : spec.vertices) {
        const Vec2 p = camera.project(v);
        seen.points.emplace_back(p.x(), p.y(), camera.depthPx(v));
    }
    const std::vector<SpecEdge> edges = specEdges(spec);
    VisibleDrawing drawing;
    std::set<int> vertices;
    std::set<int> faces;
    for (std::size_t e = 0; e < edges.size(); ++e) {
        const Vec3 a = seen.point(edges[e].ends[0]);
        const Vec3 b = seen.point(edges[e].ends[1]);
        const std::vector<double> at = splits(seen, edges, edges[e]);
        for (std::size_t i = 0; i + 1 < at.size();) {
            const auto pieceHidden = [&](std::size_t k) {
                return hidden(seen, edges[e], a + (at[k] + at[k + 1]) / 2.0 * (b - a));
            };
            if (pieceHidden(i)) {
                ++i;
                continue;
            }
            std::size_t last = i;
            while (last + 2 < at.size() && !pieceHidden(last + 1)) ++last;
            VisibleEdge piece;
            piece.edge = static_cast<int>(e);
            const auto setEnd = [&](std::size_t end, double t, int vertex) {
                const bool isVertex = t == 0.0 || t == 1.0;
                const Vec2 p = isVertex ? seen.flat(vertex) : Vec2((a + t * (b - a)).head<2>());
                piece.line[end] = p;
                piece.vertices[end] = isVertex ? vertex : -1;
                if (isVertex)
                    vertices.insert(vertex);
                else
                    drawing.tJunctions.push_back(p);
            };
            setEnd(0, at[i], edges[e].ends[0]);
            setEnd(1, at[last + 1], edges[e].ends[1]);
            drawing.edges.push_back(piece);
            for (const int f : edges[e].faces) {
                const Vec3 n = specFaceNormal(spec, static_cast<std::size_t>(f));
                if (n.dot(camera.direction) < 0.0) faces.insert(f);
            }
            i = last + 1;
        }
    }
    drawing.vertices.assign(vertices.begin(), vertices.end());
    drawing.faces.assign(faces.begin(), faces.end());
    return drawing;
}

}  // namespace ew::test
