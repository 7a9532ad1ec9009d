// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/base/vec.h"
#include "core/solid/polyhedron_spec.h"

namespace ew {

/// A polyhedron by its planes: what is parallel, perpendicular to an axis of the body or in one
/// plane is so by construction, to the last digit. A vertex is where its faces meet.
struct PlaneModel {
    /// The direction of a family of parallel faces in the body's frame.
    struct Normal {
        enum class Kind {
            Fixed,  ///< is `first`
            Turn,   ///< cos(angle) first + sin(angle) second; the two are unit and perpendicular
            Free,   ///< `first`, turned freely
        };
        Kind kind = Kind::Fixed;
        Vec3 first = Vec3::UnitZ();
        Vec3 second = Vec3::UnitX();
        int angle = -1;  ///< Turn: index into angles; several normals may share one
    };
    struct Face {
        int normal = -1;
        double sense = 1.0;  ///< the outward normal is sense * Normal
        int offset = -1;     ///< index into offsets: of the plane from `center` along Normal
    };
    std::vector<Normal> normals;
    std::vector<double> angles;   ///< [rad]
    std::vector<double> offsets;  ///< [px]
    std::vector<Face> faces;
    std::vector<std::vector<int>> vertexFaces;  ///< per vertex, three or more
    Mat3 bodyToCamera = Mat3::Identity();
    Vec3 center = Vec3::Zero();  ///< camera space [px]; its depth means nothing

    /// Unit, in the body's frame.
    Vec3 direction(const Normal& normal) const;
    /// Numbers that its picture can still be changed by.
    int freedoms() const;
};

/// Where a vertex was drawn.
struct DrawnVertex {
    int vertex = -1;
    Vec2 at = Vec2::Zero();  ///< [px]
    double spreadPx = 1.0;   ///< standard deviation per axis
};

/// A line of which only one end is a vertex that is seen, or none.
struct DrawnStretch {
    std::array<int, 2> vertices{-1, -1};  ///< the edge that it is part of
    Vec2 at = Vec2::Zero();               ///< a point of it [px]
    double spreadPx = 1.0;                ///< across the edge
};

struct PlaneFit {
    PlaneModel model;
    std::vector<Vec3> body;    ///< vertices in the body's frame, from `center` [px]
    std::vector<Vec3> camera;  ///< vertices in camera space [px]
    double cost = 0.0;         ///< twice a negative log-likelihood, Student's distribution
    double misfit = 0.0;       ///< squared distances over their variances, per coordinate drawn
    double gapPx = 0.0;        ///< farthest that a vertex is from one of its planes
};

/// Moves planes and attitude so that the vertices are seen where they were drawn: Levenberg and
/// Marquardt over angles, offsets and attitude. O(iterations * parameters * vertices).
/// \return nothing where three faces of a vertex do not meet in a point.
std::optional<PlaneFit> fitPlanes(PlaneModel model, const std::vector<DrawnVertex>& vertices,
                                  const std::vector<DrawnStretch>& stretches, int mostSteps = 40);

/// The planes of a polyhedron whose vertices are known roughly: normals near an axis of the frame
/// are that axis, those nearly perpendicular to one are exactly so (and alike or mirrored where
/// they nearly are), parallel ones are parallel.
/// \param rough  camera space [px]; faces counter-clockwise from outside.
/// \param frame      body to camera, a rotation.
/// \param angleDeg  directions that differ by less are one.
PlaneModel regularModel(const PolyhedronSpec& rough, const Mat3& frame, double angleDeg);

/// Makes faces the sides of a regular prism, frustum or pyramid: equal turns about the third axis
/// of the body, equal slopes, equal distances from its center.
/// \param sides  faces in the order in which they go round, counter-clockwise about that axis.
void makeRegularRing(PlaneModel& model, const std::vector<int>& sides);

}  // namespace ew
