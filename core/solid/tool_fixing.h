// SPDX-License-Identifier: GPL-3.0-or-later
// Private to core/solid.
#pragma once

#include <optional>
#include <set>
#include <vector>

#include "core/base/result.h"
#include "core/solid/exact_geometry.h"
#include "core/solid/plane_fit.h"
#include "core/solid/polyhedron_spec.h"

namespace ew {

/// Finds exact points near those of a shape so that every face is planar and what is asked of
/// faces and vertices holds exactly.
///
/// A plane is bound by points that it goes through and directions that it contains, a point by
/// planes that it lies on. What the rules settle alone is settled first; the rest is fixed one
/// after the other in an order in which nothing is bound by more than its freedom (see realize.h).
class ToolFixing {
  public:
    /// \pre coordinates and loops checked, every face has an area.
    explicit ToolFixing(const PolyhedronSpec& shape);

    /// Some planes of a larger whole and the points on them. Every face is a plane of its own here,
    /// with any number of points; one whose plane is to stay is told so by faceIn().
    /// \param reach  how far a point may be moved [mm].
    ToolFixing(std::vector<Vec3> points, std::vector<FittedPlane> planes, double reach);

    bool hasFace(int f) const {
        return f >= 0 && static_cast<std::size_t>(f) < shape_.faces.size();
    }
    bool hasVertex(int v) const {
        return v >= 0 && static_cast<std::size_t>(v) < shape_.vertices.size();
    }
    void faceIn(int face, const RPlane& plane);
    void faceAlong(int face, const RVec& direction);
    void faceThrough(int face, const RVec& point);
    void vertexAt(int vertex, const RVec& point);
    void vertexOn(int vertex, const RPlane& plane);

    /// The points. Error: Contradiction.
    Result<std::vector<RVec>> solve();
    /// \pre solve() gave points.
    const RPlane& plane(int face) const {
        return *planes_[static_cast<std::size_t>(planeOf(face))].fixed;
    }

  private:
    struct PlaneNode {
        FittedPlane wish;
        std::vector<RVec> through;
        std::vector<RVec> along;
        std::optional<RPlane> fixed;
    };
    struct PointNode {
        std::vector<RPlane> on;
        std::optional<RVec> fixed;
    };
    struct Demand {  ///< for the check at the end
        int face = -1, vertex = -1;
        std::optional<RPlane> plane;
        std::optional<RVec> along, point;
    };

    int planeOf(int face) const { return planeOf_[static_cast<std::size_t>(face)]; }
    static std::vector<RVec> spansOf(const PlaneNode& node);
    std::optional<RPlane> planeFrom(const PlaneNode& node) const;
    std::optional<RVec> softNormal(const PlaneNode& node, const std::vector<RVec>& spans) const;
    std::optional<RVec> pointFrom(const PointNode& node, const Vec3& wish) const;
    int freedom(std::size_t node) const;
    void bind(std::size_t node, std::size_t other);
    void settle();
    void spread();
    bool bindSliding(std::size_t point, std::size_t plane);
    bool fixRest();
    bool fixNode(std::size_t node);
    bool isFixed(std::size_t node) const;
    Result<void> check() const;

    PolyhedronSpec shape_;
    double reach_;  ///< largest move of a point [mm]
    std::vector<PlaneNode> planes_;
    std::vector<int> planeOf_;  ///< by face
    std::vector<PointNode> points_;
    std::vector<std::set<std::size_t>> links_;  ///< points, then planes; open ones only
    std::vector<Demand> demands_;
};

}  // namespace ew
