// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "core/reading/extract/line_drawing.h"
#include "core/reading/solve/polyhedron_fit.h"

namespace ew {

/// A solid that a drawing may show: all its faces, with rough places, and which of its corners are
/// which nodes of the drawing.
struct ShapeHypothesis {
    std::string family;        ///< "prism", "pyramid", "frustum", "polyhedron"
    int sides = 0;             ///< corners of the base, 0 for a polyhedron
    PolyhedronSpec rough;      ///< camera space [px], faces counter-clockwise from outside
    std::vector<int> pieceOf;  ///< per face of `rough`: pieces of one face have one number; empty
                               ///< where each is a face by itself
    Mat3 frame = Mat3::Identity();  ///< body to camera
    std::vector<int> node;          ///< per vertex: node of the drawing, -1 where it is not seen
    std::vector<DrawnStretch> stretches;  ///< lines that end behind something
    int lift = -1;  ///< proposals of one number show the same faces and close them in other ways
    double price = 0.0;     ///< of what it takes for granted, twice a log-likelihood
    std::vector<int> ring;  ///< faces round the third axis, where they may be a regular
                            ///< polygon's sides
};

/// A body's frame with its third axis along `axis` (unit) and its first as near as can be to
/// `edge`.
inline Mat3 frameAlong(const Vec3& axis, const Vec3& edge) {
    Mat3 frame;
    frame.col(2) = axis;
    frame.col(0) = (edge - edge.dot(axis) * axis).normalized();
    frame.col(1) = axis.cross(frame.col(0));
    return frame;
}

}  // namespace ew
