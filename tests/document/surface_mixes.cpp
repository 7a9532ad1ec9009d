// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/document/surface_mixes.h"

#include <algorithm>
#include <cmath>
#include <cstdio>

#include "tests/support/random.h"

namespace ew::test {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

bool chosen(const SurfaceMix& mix, const SolidEdge& edge, Random& random) {
    switch (mix.edges) {
        case SurfaceMix::Edges::None:
            return false;
        case SurfaceMix::Edges::All:
            return true;
        case SurfaceMix::Edges::Convex:
            return edge.convex;
        case SurfaceMix::Edges::Concave:
            return !edge.convex;
        case SurfaceMix::Edges::Picked:
            return random.chance(0.4);
    }
    return false;
}

double sizeOf(const Body& body) { return (body.solid.bounds()[1] - body.solid.bounds()[0]).norm(); }

/// Settings of the fillets for one body.
std::vector<double> radiiOf(const Body& body, const SurfaceMix& mix) {
    Random random(Random::mix(body.solid.edges().size(), 19));
    std::vector<double> out;
    for (const SolidEdge& edge : body.solid.edges()) {
        out.push_back(chosen(mix, edge, random) ? mix.radius * sizeOf(body) : 0.0);
    }
    return out;
}

}  // namespace

const char* SurfaceMix::edgesName() const {
    switch (edges) {
        case Edges::None:
            return "none";
        case Edges::All:
            return "all";
        case Edges::Convex:
            return "convex";
        case Edges::Concave:
            return "concave";
        case Edges::Picked:
            return "picked";
    }
    return "";
}

std::string SurfaceMix::name() const {
    char text[80];
    const char* how = scheme == SubdivisionScheme::Loop ? "loop" : "cc";
    std::snprintf(text, sizeof(text), "%s_r%g_s%d_%s%s", edgesName(), radius, segments,
                  levels == 0 && tolerance == 0.0 ? "cage" : how,
                  tolerance > 0.0 ? "t" : (levels > 0 ? std::to_string(levels).c_str() : ""));
    return text;
}

std::vector<SurfaceMix> allMixes() {
    using Edges = SurfaceMix::Edges;
    std::vector<SurfaceMix> out;
    const auto addSurfaces = [&](SurfaceMix mix) {
        out.push_back(mix);
        for (const auto scheme : {SubdivisionScheme::CatmullClark, SubdivisionScheme::Loop}) {
            mix.scheme = scheme;
            mix.tolerance = 0.0;
            for (mix.levels = 1; mix.levels <= 3; ++mix.levels) out.push_back(mix);
            mix.levels = 1;
            mix.tolerance = 1e-3;
            out.push_back(mix);
        }
    };
    SurfaceMix none;
    none.edges = Edges::None;
    addSurfaces(none);
    for (const Edges edges : {Edges::All, Edges::Convex, Edges::Concave, Edges::Picked}) {
        for (const double radius : {0.02, 0.1, 0.5, 2.0}) {
            for (const int segments : {1, 5}) {
                SurfaceMix mix;
                mix.edges = edges;
                mix.radius = radius;
                mix.segments = segments;
                addSurfaces(mix);
            }
        }
    }
    return out;
}

std::optional<ShapeInput> inputFor(const std::vector<Body>& bodies, const SurfaceMix& mix) {
    ShapeInput out;
    out.bodies = bodies;
    out.settings.segments = mix.segments;
    for (const Body& body : bodies) out.settings.edges.push_back({radiiOf(body, mix), {}});
    if (mix.edges != SurfaceMix::Edges::None && !out.settings.hasFillet()) return std::nullopt;
    SubdivisionSettings& s = out.settings.subdivision;
    s.scheme = mix.scheme;
    s.on = mix.levels > 0 || mix.tolerance > 0.0;
    s.levels = std::max(mix.levels, 1);
    double size = 0.0;
    for (const Body& body : bodies) size = std::max(size, sizeOf(body));
    s.tolerance = mix.tolerance * size;
    return out;
}

ShapeFaults& ShapeFaults::operator+=(const ShapeFaults& other) {
    badNormals += other.badNormals;
    backwardNormals += other.backwardNormals;
    reading.withoutArea += other.reading.withoutArea;
    reading.openEdges += other.reading.openEdges;
    notManifold += other.notManifold;
    notMade += other.notMade;
    return *this;
}

ShapeFaults faultsOf(const ShapeInput& input, const DerivedShape& shape) {
    ShapeFaults out;
    out.notMade = shape.problem ? 1 : 0;
    for (std::size_t b = 0; b < input.bodies.size(); ++b) {
        const ShapeMesh mesh = shapeMesh(input.bodies[b], shape.bodies[b]);
        PolyMesh byIndex;
        byIndex.points = mesh.positions;
        for (const auto& t : mesh.triangles) byIndex.addFace({t[0], t[1], t[2]});
        const ReadingFaults reading = readingFaults(mesh.positions, mesh.triangles);
        out.reading.withoutArea += reading.withoutArea;
        out.reading.openEdges += reading.openEdges;
        if (!checkClosed(byIndex)) ++out.notManifold;
        constexpr double kUnit = 1e-3;
        for (const Vec3& n : mesh.normals) {
            if (!(std::abs(n.norm() - 1.0) < kUnit)) ++out.badNormals;
        }
        if (mesh.normals.empty()) continue;
        const auto& ids = mesh.normalTriangles.empty() ? mesh.triangles : mesh.normalTriangles;
        for (std::size_t t = 0; t < ids.size(); ++t) {
            const auto& c = mesh.triangles[t];
            const Vec3& a = mesh.positions[at(c[0])];
            const Vec3 area = (mesh.positions[at(c[1])] - a).cross(mesh.positions[at(c[2])] - a);
            for (const int n : ids[t]) {
                if (mesh.normals[at(n)].dot(area) < 0.0) ++out.backwardNormals;
            }
        }
    }
    return out;
}

}  // namespace ew::test
