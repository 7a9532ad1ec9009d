// SPDX-License-Identifier: GPL-3.0-or-later
// Private to core/surface.
#pragma once

#include <cstdint>
#include <unordered_map>
#include <vector>

#include "core/surface/face_classes.h"

namespace ew {

/// Finds faces of a control cage that are moved copies of others, with all that is round them:
/// what is measured on one of them need not be measured on the next.
class CongruentFaces {
  public:
    /// \param precision  to which control points are compared [mm], > 0.
    CongruentFaces(const ControlCage& cage, const FaceClasses& classes, double precision)
        : mesh_(cage.mesh), classes_(classes), precision_(precision) {}

    /// The first face asked for that has the shape of this one; the face itself where there is none
    /// yet. Corners and sides of the two correspond.
    int first(int face);

  private:
    struct Known {
        int face = -1;
        std::vector<std::int64_t> shape;
    };
    /// False where the face has no area, and so no frame: it is like no other.
    bool describe(int face);

    const PolyMesh& mesh_;
    const FaceClasses& classes_;
    double precision_;
    std::vector<std::int64_t> shape_;  ///< of the face under way: control points in its own frame
    std::unordered_map<std::uint64_t, Known> byHash_;
};

}  // namespace ew
