// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewport/wireframe.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "core/base/tolerance.h"

namespace ew {

namespace {

struct WireEdge {
    int a = -1;
    int b = -1;
    std::array<int, 2> faces{-1, -1};
};

Vec3 newellNormal(const std::vector<Vec3>& points, const std::vector<int>& loop) {
    Vec3 n = Vec3::Zero();
    for (std::size_t i = 0; i < loop.size(); ++i) {
        const Vec3& p = points[static_cast<std::size_t>(loop[i])];
        const Vec3& q = points[static_cast<std::size_t>(loop[(i + 1) % loop.size()])];
        n += p.cross(q);
    }
    return n;
}

bool inside(const std::vector<Vec2>& polygon, const Vec2& p) {
    bool in = false;
    for (std::size_t i = 0, j = polygon.size() - 1; i < polygon.size(); j = i++) {
        const Vec2& a = polygon[i];
        const Vec2& b = polygon[j];
        if ((a.y() > p.y()) != (b.y() > p.y()) &&
            p.x() < (b.x() - a.x()) * (p.y() - a.y()) / (b.y() - a.y()) + a.x()) {
            in = !in;
        }
    }
    return in;
}

bool indicesInRange(const PolyhedronSpec& spec) {
    const int n = static_cast<int>(spec.vertices.size());
    return std::all_of(spec.faces.begin(), spec.faces.end(), [n](const std::vector<int>& face) {
        return face.size() >= 3 &&
               std::all_of(face.begin(), face.end(), [n](int v) { return v >= 0 && v < n; });
    });
}

std::vector<WireEdge> edgesOf(const PolyhedronSpec& spec) {
    std::map<std::pair<int, int>, WireEdge> edges;
    for (std::size_t f = 0; f < spec.faces.size(); ++f) {
        const auto& loop = spec.faces[f];
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const int a = loop[i];
            const int b = loop[(i + 1) % loop.size()];
            WireEdge& edge = edges[std::minmax(a, b)];
            edge.a = std::min(a, b);
            edge.b = std::max(a, b);
            edge.faces[edge.faces[0] < 0 ? 0U : 1U] = static_cast<int>(f);
        }
    }
    std::vector<WireEdge> out;
    out.reserve(edges.size());
    for (const auto& [key, edge] : edges) out.push_back(edge);
    return out;
}

/// Where along a-b (0..1) the segment c-d crosses it.
void addCrossing(const std::array<Vec2, 2>& ab, const std::array<Vec2, 2>& cd,
                 std::vector<double>& cuts) {
    const Vec2 r = ab[1] - ab[0];
    const Vec2 s = cd[1] - cd[0];
    const double det = cross2(r, s);
    if (std::abs(det) < tol::kWireCrossing) return;
    const double t = cross2(cd[0] - ab[0], s) / det;
    const double u = cross2(cd[0] - ab[0], r) / det;
    if (t > 0.0 && t < 1.0 && u > -tol::kWireCrossing && u < 1.0 + tol::kWireCrossing) {
        cuts.push_back(t);
    }
}

struct Projection {
    std::vector<Vec2> px;
    std::vector<double> depth;
    std::vector<SeenFace> faces;  // of those with the side towards the eye
    std::vector<int> seenIndex;   // per face of the spec: index into faces, -1 if turned away
};

Projection projectAll(const PolyhedronSpec& spec, const Pose& pose,
                      const OrthographicCamera& camera) {
    Projection p;
    std::vector<Vec3> world;
    for (const Vec3& v : spec.vertices) {
        world.push_back(pose.toWorld(v));
        p.px.push_back(camera.project(world.back()));
        p.depth.push_back(camera.depthPx(world.back()));
    }
    const Mat3 toCamera = camera.cameraToWorld().transpose();
    for (const auto& loop : spec.faces) {
        const Vec3 n = newellNormal(world, loop);
        const Vec3 unit = n.norm() > 0.0 ? Vec3(n.normalized()) : Vec3::Zero();
        const Vec3 inCamera = toCamera * unit;
        if (!(inCamera.z() < -tol::kEdgeOnSine)) {
            p.seenIndex.push_back(-1);
            continue;
        }
        SeenFace face;
        face.normal = unit;
        for (const int v : loop) face.outline.push_back(p.px[static_cast<std::size_t>(v)]);
        const std::size_t first = static_cast<std::size_t>(loop[0]);
        const double gx = -inCamera.x() / inCamera.z();
        const double gy = -inCamera.y() / inCamera.z();
        face.depth = {gx, gy, p.depth[first] - gx * p.px[first].x() - gy * p.px[first].y()};
        p.seenIndex.push_back(static_cast<int>(p.faces.size()));
        p.faces.push_back(std::move(face));
    }
    return p;
}

bool hiddenAt(const Projection& p, const WireEdge& edge, double t) {
    const auto a = static_cast<std::size_t>(edge.a);
    const auto b = static_cast<std::size_t>(edge.b);
    const Vec2 at = (1.0 - t) * p.px[a] + t * p.px[b];
    const double depth = (1.0 - t) * p.depth[a] + t * p.depth[b];
    for (std::size_t f = 0; f < p.seenIndex.size(); ++f) {
        const int seen = p.seenIndex[f];
        const bool own =
            edge.faces[0] == static_cast<int>(f) || edge.faces[1] == static_cast<int>(f);
        if (seen < 0 || own) continue;
        const SeenFace& face = p.faces[static_cast<std::size_t>(seen)];
        const double faceDepth = face.depth.x() * at.x() + face.depth.y() * at.y() + face.depth.z();
        if (faceDepth < depth - tol::kWireDepthPx && inside(face.outline, at)) return true;
    }
    return false;
}

}  // namespace

std::vector<SeenFace> seenFaces(const PolyhedronSpec& spec, const Pose& pose,
                                const OrthographicCamera& camera) {
    if (!indicesInRange(spec)) return {};
    return projectAll(spec, pose, camera).faces;
}

std::vector<WireSegment> wireSegments(const PolyhedronSpec& spec, const Pose& pose,
                                      const OrthographicCamera& camera) {
    if (!indicesInRange(spec)) return {};
    const Projection p = projectAll(spec, pose, camera);
    const std::vector<WireEdge> edges = edgesOf(spec);
    const auto endsOf = [&p](const WireEdge& e) {
        return std::array<Vec2, 2>{p.px[static_cast<std::size_t>(e.a)],
                                   p.px[static_cast<std::size_t>(e.b)]};
    };
    std::vector<WireSegment> out;
    for (const WireEdge& edge : edges) {
        const std::array<Vec2, 2> ends = endsOf(edge);
        const auto turnedAway = [&p](int f) {
            return f < 0 || p.seenIndex[static_cast<std::size_t>(f)] < 0;
        };
        if (turnedAway(edge.faces[0]) && turnedAway(edge.faces[1])) {
            out.push_back({ends, true});
            continue;
        }
        std::vector<double> cuts{0.0, 1.0};
        for (const WireEdge& other : edges) {
            if (other.a == edge.a || other.a == edge.b || other.b == edge.a || other.b == edge.b) {
                continue;
            }
            addCrossing(ends, endsOf(other), cuts);
        }
        std::sort(cuts.begin(), cuts.end());
        for (std::size_t i = 0; i + 1 < cuts.size(); ++i) {
            if (cuts[i + 1] - cuts[i] < tol::kWireCrossing) continue;
            const bool hidden = hiddenAt(p, edge, (cuts[i] + cuts[i + 1]) / 2);
            const Vec2 from = (1 - cuts[i]) * ends[0] + cuts[i] * ends[1];
            const Vec2 to = (1 - cuts[i + 1]) * ends[0] + cuts[i + 1] * ends[1];
            const bool goesOn = !out.empty() && i > 0 && out.back().hidden == hidden;
            if (goesOn) {
                out.back().ends[1] = to;
            } else {
                out.push_back({{from, to}, hidden});
            }
        }
    }
    return out;
}

}  // namespace ew
