// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/document/shape_reading.h"

namespace ew::test {

/// One way to round the edges of a solid and to smooth what comes of it.
struct SurfaceMix {
    enum class Edges { None, All, Convex, Concave, Picked };
    Edges edges = Edges::All;
    double radius = 0.02;  ///< share of the size of the body, which is the diagonal of its box
    int segments = 1;
    SubdivisionScheme scheme = SubdivisionScheme::CatmullClark;
    int levels = 0;          ///< 0: no surface, unless there is a tolerance
    double tolerance = 0.0;  ///< > 0: adaptive, share of the size

    const char* edgesName() const;
    /// "concave_r0.02_s1_cc1"
    std::string name() const;
};

/// All edges, the convex ones, the concave ones, some picked ones and none; radii from 0.02 to 2 of
/// the size; 1 and 5 segments; no surface, and both schemes by 1 to 3 levels and adaptive.
std::vector<SurfaceMix> allMixes();

/// The settings for these bodies; nothing where the bodies have no such edges.
std::optional<ShapeInput> inputFor(const std::vector<Body>& bodies, const SurfaceMix& mix);

/// What is wrong with a shape as it would be exported.
struct ShapeFaults {
    std::size_t badNormals = 0;       ///< not of unit length
    std::size_t backwardNormals = 0;  ///< more than 90 degrees from their triangle's own, as a
                                      ///< surface has that bends more than its triangles: no fault
    ReadingFaults reading;
    std::size_t notManifold = 0;  ///< bodies whose triangles are not closed by index either
    std::size_t notMade = 0;      ///< shapes with a problem

    bool any() const { return badNormals + notManifold + notMade > 0 || !reading.none(); }
    ShapeFaults& operator+=(const ShapeFaults& other);
};
ShapeFaults faultsOf(const ShapeInput& input, const DerivedShape& shape);

}  // namespace ew::test
