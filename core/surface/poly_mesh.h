// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <vector>

#include "core/base/result.h"
#include "core/base/vec.h"

namespace ew {

/// A polygon mesh in flat arrays: face f owns loops, each a run of point indices. The first loop of
/// a face is its outline, counter-clockwise from outside, the others are holes, clockwise.
struct PolyMesh {
    std::vector<Vec3> points;       ///< [mm]
    std::vector<int> corners;       ///< the loops one after the other
    std::vector<int> loopStart{0};  ///< loop l is corners[loopStart[l] .. loopStart[l + 1])
    std::vector<int> faceStart{0};  ///< face f owns loops faceStart[f] .. faceStart[f + 1]

    int faceCount() const { return static_cast<int>(faceStart.size()) - 1; }
    int loopCount(int face) const { return faceStart[at(face) + 1] - faceStart[at(face)]; }
    std::span<const int> loop(int face, int index) const {
        const auto l = at(faceStart[at(face)] + index);
        return {corners.data() + loopStart[l], corners.data() + loopStart[l + 1]};
    }
    std::span<const int> outline(int face) const { return loop(face, 0); }
    const Vec3& point(int i) const { return points[at(i)]; }

    int addPoint(const Vec3& p) {
        points.push_back(p);
        return static_cast<int>(points.size()) - 1;
    }
    /// Ends the loop of the corners appended since the last call.
    void closeLoop() { loopStart.push_back(static_cast<int>(corners.size())); }
    /// Ends the face of the loops closed since the last call.
    void closeFace() { faceStart.push_back(static_cast<int>(loopStart.size()) - 1); }
    /// Adds a face without holes.
    void addFace(std::span<const int> outlineCorners) {
        corners.insert(corners.end(), outlineCorners.begin(), outlineCorners.end());
        closeLoop();
        closeFace();
    }
    void addFace(std::initializer_list<int> outlineCorners) {
        addFace(std::span<const int>(outlineCorners.begin(), outlineCorners.size()));
    }

  private:
    static std::size_t at(int i) { return static_cast<std::size_t>(i); }
};

/// Triangles over the points of a PolyMesh.
struct PolyTriangles {
    std::vector<std::array<int, 3>> triangles;  ///< counter-clockwise from outside
    std::vector<int> face;                      ///< polygon that a triangle is part of
};

/// Splits every face into triangles without new points: quadrangles along the diagonal that folds
/// least (the first one where both do alike), larger ones and those with holes by a constrained
/// Delaunay triangulation in the plane of the face. The same mesh gives the same triangles.
/// \param brokenFaces  where given, takes the faces that are no simple polygons, whose triangles
///                     are left out; else these are an error.
/// Errors: SelfIntersecting, BadValue for a face of fewer than three corners.
Result<PolyTriangles> triangulate(const PolyMesh& mesh, std::vector<int>* brokenFaces = nullptr);

/// Normal of a loop times twice its area (Newell), outward for an outline.
Vec3 loopAreaVector(const std::vector<Vec3>& points, std::span<const int> loop);

/// Volume enclosed by closed oriented triangles [mm^3].
double enclosedVolume(const std::vector<Vec3>& points,
                      const std::vector<std::array<int, 3>>& triangles);

/// Every edge lies between exactly two faces that run along it in opposite directions, and the
/// faces round every point form one fan. Errors: NotClosed, NotManifold, NotOriented, BadValue.
Result<void> checkClosed(const PolyMesh& mesh);

}  // namespace ew
