// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/random_modifications.h"

#include <algorithm>
#include <cmath>

#include "core/solid/boolean.h"
#include "tests/support/random_shapes.h"

namespace ew::test {
namespace {

/// A frame on a face: origin on it, x along an edge, z outwards.
struct FaceFrame {
    int face = -1;
    int edge = -1;  ///< of the solid, along x
    Mat3 axes;
    Vec3 origin;
    double room = 0.0;  ///< length of the edge
};

FaceFrame randomFrame(const Solid& solid, Random& random) {
    FaceFrame frame;
    frame.edge = random.index(static_cast<int>(solid.edges().size()));
    const SolidEdge& edge = solid.edges()[static_cast<std::size_t>(frame.edge)];
    frame.face = edge.faces[0];
    const SolidFace& face = solid.faces()[static_cast<std::size_t>(frame.face)];
    const Vec3 a = solid.vertices()[static_cast<std::size_t>(edge.ends[0])];
    const Vec3 b = solid.vertices()[static_cast<std::size_t>(edge.ends[1])];
    frame.room = (b - a).norm();
    frame.axes.col(0) = (b - a).normalized();
    frame.axes.col(2) = face.normal;
    frame.axes.col(1) = face.normal.cross(frame.axes.col(0));  // into the face
    frame.origin = a;
    return frame;
}

PolyhedronSpec randomStart(Random& random) {
    const int kind = random.index(3);
    const double size = random.uniform(30.0, 60.0);
    if (kind == 0) {
        return boxSpec(size, size * random.uniform(0.4, 1.0), size * random.uniform(0.3, 1.0));
    }
    PolyhedronSpec spec =
        randomShape(kind == 1 ? "triangular-prism" : "triangular-pyramid", random);
    for (Vec3& p : spec.vertices) p *= size;
    return spec;
}

}  // namespace

ToolSpec randomTool(const Solid& solid, bool inward, Random& random) {
    const FaceFrame frame = randomFrame(solid, random);
    const double width = std::min(frame.room, 25.0) * random.uniform(0.2, 0.6);
    const double depth = random.uniform(3.0, 12.0);
    const double height = (inward ? -1.0 : 1.0) * random.uniform(2.0, 9.0);
    const bool atCorner = random.chance(0.3);
    const bool atEdge = atCorner || random.chance(0.4);
    const double x = atCorner ? 0.0 : frame.room * random.uniform(0.1, 0.4);
    const double y = atEdge ? 0.0 : random.uniform(1.0, 4.0);
    ToolSpec spec;
    const int kind = random.index(3);
    if (kind == 0) {
        spec.shape = boxSpec(width, depth, std::abs(height));
    } else if (kind == 1) {
        spec.shape.vertices = {{0, 0, 0},
                               {width, 0, 0},
                               {width, depth, 0},
                               {0, depth, 0},
                               {0, 0, std::abs(height)},
                               {width, 0, std::abs(height)}};
        spec.shape.faces = {{0, 3, 2, 1}, {0, 1, 5, 4}, {4, 5, 2, 3}, {0, 4, 3}, {1, 2, 5}};
    } else {
        spec.shape.vertices = {{0, 0, 0},
                               {width, 0, 0},
                               {width, depth, 0},
                               {0, depth, 0},
                               {0.4 * width, 0.5 * depth, std::abs(height)}};
        spec.shape.faces = {{0, 3, 2, 1}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};
    }
    for (Vec3& p : spec.shape.vertices) {
        const Vec3 local(x + p.x(), y + p.y(), height < 0 ? -p.z() : p.z());
        p = frame.origin + frame.axes * local;
    }
    if (height < 0) {
        for (auto& face : spec.shape.faces) std::reverse(face.begin(), face.end());
    }
    spec.faces.push_back({0, ToolFaceRule::Kind::InFace, frame.face});
    if (kind < 2) {
        // The uprights along the face's normal, the front along its edge, all exactly.
        spec.edges.push_back({{0, 4}, ToolEdgeRule::Kind::AlongNormal, frame.face});
        spec.edges.push_back({{1, 5}, ToolEdgeRule::Kind::AlongNormal, frame.face});
        spec.edges.push_back({{0, 1}, ToolEdgeRule::Kind::AlongEdge, frame.edge});
        spec.edges.push_back({{2, 3}, ToolEdgeRule::Kind::AlongEdge, frame.edge});
    }
    const SolidEdge& edge = solid.edges()[static_cast<std::size_t>(frame.edge)];
    if (atCorner) {
        spec.vertices.push_back({0, ToolVertexRule::Kind::AtVertex, edge.ends[0], -1, 0.0});
    } else if (atEdge) {
        spec.vertices.push_back({0, ToolVertexRule::Kind::OnEdge, frame.edge, -1, 0.0});
    }
    if (atEdge) spec.vertices.push_back({1, ToolVertexRule::Kind::OnEdge, frame.edge, -1, 0.0});
    return spec;
}

Solid randomModifiedSolid(int most, Random& random) {
    auto start = Solid::fromSpec(randomStart(random));
    while (!start) start = Solid::fromSpec(randomStart(random));
    Solid solid = *start;
    const int count = 1 + random.index(most);
    for (int i = 0; i < count; ++i) {
        const bool cut = random.chance(0.5);
        const auto tool = makeTool(solid, randomTool(solid, cut, random));
        if (!tool) continue;
        const auto out = combine(solid, *tool, cut ? BooleanKind::Cut : BooleanKind::Add);
        if (out) solid = out->solid;
    }
    return solid;
}

}  // namespace ew::test
