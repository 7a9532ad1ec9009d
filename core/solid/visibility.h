// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <memory>
#include <optional>
#include <vector>

#include "core/base/camera.h"
#include "core/base/result.h"
#include "core/solid/solid.h"

namespace ew {

/// Why a visible piece of an edge ends where it does.
struct PieceEnd {
    enum class Kind {
        Vertex,    ///< the edge's own end; `index` is the solid's vertex
        Occluded,  ///< it goes on behind something (T junction); `index` is the edge that it
                   ///< disappears behind
    };
    Kind kind = Kind::Vertex;
    int index = -1;
};

/// A visible part of an edge.
struct VisiblePiece {
    int edge = -1;                                       ///< of Solid::edges()
    double t0 = 0.0, t1 = 1.0;                           ///< along the edge, ends[0] is 0
    std::array<Vec2, 2> px{Vec2::Zero(), Vec2::Zero()};  ///< [Sketch Plane px]
    std::array<PieceEnd, 2> ends;
    bool silhouette = false;  ///< what is behind it is no neighbour: one face looks away
    bool point = false;       ///< the edge is seen end-on: both px are one
};

/// What a ray from the eye meets first.
struct Pick {
    int face = -1;
    double depthPx = 0.0;       ///< behind the Sketch Plane [px], as OrthographicCamera::depthPx
    Vec3 body = Vec3::Zero();   ///< [mm]
    Vec3 world = Vec3::Zero();  ///< [mm]
};

/// How a face stands to the eye.
enum class Facing { Front, EdgeOn, Back };

/// A solid as a camera sees it: hidden-line removal and picking. Holds a copy of the solid and a
/// grid over the picture; making it is part of the cost, so keep it as long as nothing moves.
///
/// In doubles, exact enough: faces under tol::kEdgeOnSine are seen edge-on and hide nothing,
/// something hides an edge only where it is nearer by tol::kViewDepth of the picture. An edge that
/// coincides in the picture with a nearer edge is hidden, so every line of the drawing comes once;
/// edges of touching parts and edges on the border of the faces round them are not hidden by those.
///
/// Cost: O(n log n) for n faces of a size; 10,000 faces in some tens of ms.
/// \paper{4.1.2}
class SolidView {
  public:
    /// Errors: BadValue for a camera that is none.
    static Result<SolidView> make(const Solid& solid, const Pose& pose,
                                  const OrthographicCamera& camera);

    /// The visible pieces of all edges, by edge and along it.
    std::vector<VisiblePiece> visiblePieces() const;

    /// The nearest face under a point of the Sketch Plane; nothing beside the solid.
    std::optional<Pick> pick(const Vec2& px) const;

    const std::vector<Vec2>& points() const;    ///< by vertex [px]
    const std::vector<double>& depths() const;  ///< by vertex, behind the Sketch Plane [px]
    Facing facing(int face) const;

    struct Data;

  private:
    explicit SolidView(std::shared_ptr<const Data> data) : data_(std::move(data)) {}
    std::shared_ptr<const Data> data_;
};

}  // namespace ew
