// SPDX-License-Identifier: GPL-3.0-or-later
// Private to core/surface: brings OpenSubdiv with it.
#pragma once

#include <map>
#include <span>
#include <vector>

#include "core/surface/face_classes.h"
#include "core/surface/limit_surface.h"

namespace ew {

/// Weights of control points in points of the surface; made when they are first asked for.
struct PointWeights {
    std::vector<double> values;  ///< by coordinate: of the position and of both derivatives
    int uses = 0;                ///< faces that they serve
};

/// Points of the limit surface. Where several faces of one class have points at the same
/// coordinates, the weights of their control points are found once; that and not selecting a face
/// of which nothing is wanted is what makes it fast.
class SurfaceEvaluator {
  public:
    SurfaceEvaluator(const ControlCage& cage, const CageEdges& edges, SubdivisionScheme scheme,
                     LimitSurface surface);

    const FaceClasses& classes() const { return classes_; }
    OpenSubdiv::Bfr::Parameterization parameterization(int face) const;

    /// All control points of the face are within this distance of its plane, and with them its
    /// surface.
    bool inPlane(int face, double distance) const;

    /// Chooses the face, the coordinates and the weights that evaluate() speaks of; all of them
    /// must stay until the next call.
    /// \param weights  of faces of this class for these coordinates.
    void begin(int face, const std::vector<Vec2>& coords, PointWeights& weights);
    /// The surface at coordinate i of the chosen face; a zero normal where it has none. False where
    /// the face has no surface.
    bool evaluate(std::size_t i, Vec3& position, Vec3& normal);

    struct Samples {
        std::span<const Vec3> points;  ///< empty where the face has no surface
        bool regular = false;          ///< LimitSurface::regular()
    };
    /// The surface at the places that facePieces() wants, for measuring only: patches beside
    /// extraordinary points are those of three levels.
    Samples measure(int face);

  private:
    /// x, y, z and a zero: twice two numbers are one operation each.
    using Point4 = Eigen::Vector4d;

    void gather(int face);
    bool learn(int face);
    bool makeWeights();
    const std::vector<Vec2>& samples(int face, bool regular);

    const ControlCage& cage_;
    SubdivisionScheme scheme_;
    LimitSurface surface_;
    FaceClasses classes_;
    std::vector<std::vector<int>> control_;  ///< by class: places of the control points in the hull
    std::vector<std::vector<double>> sampleWeights_;  ///< by class
    std::vector<bool> regular_;                       ///< by class, where there are such weights
    std::map<std::pair<int, bool>, std::vector<Vec2>> samples_;  ///< by corners and regularity
    std::size_t budget_;                                         ///< left for weights [numbers]

    int face_ = -1;
    const std::vector<Vec2>* coords_ = nullptr;
    PointWeights* weights_ = nullptr;
    bool ready_ = false;
    std::vector<Point4> points_;  ///< control points of the chosen face
    std::vector<Vec3> measured_;
};

}  // namespace ew
