// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reading/evidence/accidental.h"

#include <array>
#include <cmath>

namespace ew {
namespace {

/// Sides of a face whose directions differ by less than this sine (3 degrees) look parallel: no
/// hand draws a taper that slight.
constexpr double kNoTaperSine = 0.05;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

bool sameDirection(const TemplateAnalysis& analysis, const TemplateEdge& a, const TemplateEdge& b) {
    const auto direction = [&](const TemplateEdge& e) {
        return analysis.edges[at(analysis.edgeBetween(e[0], e[1]))].directionClass;
    };
    return direction(a) == direction(b);
}

Vec3 along(const CameraPoints& points, const TemplateEdge& e) {
    return points[at(e[1])] - points[at(e[0])];
}

bool seenParallel(const CameraPoints& points, const TemplateEdge& a, const TemplateEdge& b) {
    const Vec2 u = along(points, a).head<2>().normalized();
    const Vec2 v = along(points, b).head<2>().normalized();
    return std::abs(cross2(u, v)) < kNoTaperSine;
}

bool parallel(const CameraPoints& points, const TemplateEdge& a, const TemplateEdge& b) {
    return along(points, a).normalized().cross(along(points, b).normalized()).norm() < kNoTaperSine;
}

/// The two pairs of opposite sides of a face with four.
std::array<std::array<TemplateEdge, 2>, 2> opposite(const std::vector<int>& face) {
    return {
        {{{{face[0], face[1]}, {face[2], face[3]}}}, {{{face[1], face[2]}, {face[3], face[0]}}}}};
}

/// Does any face of the body itself taper?
bool bodyTapers(const LibraryEntry& entry, const CameraPoints& body) {
    for (const std::vector<int>& face : entry.tmpl.shape.faces) {
        if (face.size() != 4) continue;
        for (const auto& [a, b] : opposite(face)) {
            if (!parallel(body, a, b)) return true;
        }
    }
    return false;
}

}  // namespace

bool hidesItsTaper(const LibraryEntry& entry, const Aspect& aspect, const CameraPoints& body) {
    if (aspect.kind != AspectKind::Explicit) return false;
    bool tapers = false;
    for (const int f : aspect.visibleFaces) {
        const std::vector<int>& face = entry.tmpl.shape.faces[at(f)];
        if (face.size() != 4) return false;
        for (const auto& [a, b] : opposite(face)) {
            if (!seenParallel(body, a, b)) return false;
            tapers = tapers || !sameDirection(entry.analysis, a, b);
        }
    }
    return tapers && bodyTapers(entry, body);
}

}  // namespace ew
