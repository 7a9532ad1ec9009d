// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "core/base/camera.h"
#include "core/solid/exact_tool.h"
#include "core/solid/solid.h"
#include "core/solid/visibility.h"

namespace ew {

/// A plane in camera space [px]: normal . p = offset.
struct CameraPlane {
    Vec3 normal = Vec3::UnitZ();  ///< unit
    double offset = 0.0;          ///< [px]
};

/// A direction that the model has, and where from.
struct ModelDirection {
    Vec3 direction = Vec3::UnitX();  ///< unit, camera space
    ToolEdgeRule::Kind kind = ToolEdgeRule::Kind::AlongEdge;
    int index = -1;  ///< as in ToolEdgeRule
    int other = -1;
};

/// A body as the Sketch Plane shows it. Camera space: x right, y down, z away from the eye, all in
/// px; x and y are Sketch Plane px. For one thread.
class ModelView {
  public:
    /// Errors: BadValue for a camera that is none.
    static Result<ModelView> make(const Body& body, const OrthographicCamera& camera);

    const Solid& solid() const { return body_.solid; }
    const Pose& pose() const { return body_.pose; }
    const std::vector<VisiblePiece>& pieces() const { return pieces_; }
    const SolidView& view() const { return view_; }

    Vec3 vertex(int v) const;  ///< camera space
    const CameraPlane& plane(int face) const { return planes_[static_cast<std::size_t>(face)]; }
    Vec3 direction(const Vec3& body) const;  ///< unit, camera space
    Vec3 edgeDirection(int edge) const;      ///< unit, camera space
    Vec3 toBody(const Vec3& camera) const;   ///< [mm]
    std::optional<int> faceAt(const Vec2& px) const;
    const std::vector<int>& edgesOf(int face) const {
        return faceEdges_[static_cast<std::size_t>(face)];
    }
    /// Does an edge lie in the plane of a face?
    bool edgeInFace(int edge, int face) const;
    bool vertexInFace(int vertex, int face) const;
    /// Is one of its edges to be seen, or is nothing of the solid beyond it? Others nobody can
    /// mean.
    bool known(int face) const;
    /// Visible pieces that may reach into a part of the picture, in their order: indices of
    /// pieces().
    std::vector<std::size_t> piecesNear(const Eigen::AlignedBox2d& part) const;
    /// See directionsNear(), which fills this in: a large model is asked the same often.
    using DirectionMemo = std::map<std::vector<int>, std::vector<ModelDirection>>;
    DirectionMemo& directionMemo() const { return *directions_; }

  private:
    ModelView(const Body& body, const OrthographicCamera& camera, SolidView view);

    Body body_;
    OrthographicCamera camera_;
    SolidView view_;
    std::vector<VisiblePiece> pieces_;
    std::vector<CameraPlane> planes_;
    std::vector<std::vector<int>> faceEdges_;
    std::vector<bool> outlined_;  ///< by face: some edge of it is seen
    std::shared_ptr<DirectionMemo> directions_ = std::make_shared<DirectionMemo>();
    Mat3 toCamera_ = Mat3::Identity();
    double tolerance_ = 0.0;  ///< [mm]
};

}  // namespace ew
