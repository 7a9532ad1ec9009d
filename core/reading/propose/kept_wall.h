// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "core/reading/extract/model_view.h"
#include "core/reading/solve/general_fit.h"

namespace ew {

/// A plane that a face of a template is to lie in.
struct KeptWall {
    int face = -1;                ///< of the template
    Vec3 normal = Vec3::UnitX();  ///< outwards, unit, camera space
    double offset = 0.0;          ///< normal . vertex = offset [px]
};

/// Where a convex body that meets faces of the solid has to end so that it stays clear of them: of
/// the faces that may move the one that has to move least, parallel to itself and inwards. Nothing
/// where no single face can do it or where too little of the body would be left.
/// \param faces    vertex loops of the body
/// \param points   its vertices, camera space [px]
/// \param movable  indices of `faces`
/// \param met      faces of the solid
/// \param gapPx    to stay clear by, and at least to be left
/// \paper{5.2.3}
std::optional<KeptWall> wallClearOf(const std::vector<std::vector<int>>& faces,
                                    const CameraPoints& points, const std::vector<int>& movable,
                                    const ModelView& model, const std::vector<int>& met,
                                    double gapPx);

/// Moves a face of a body into that plane: its corners go along the edges that lead there. False
/// where a corner has several of those, and where one runs along the plane.
bool moveWall(const KeptWall& wall, const std::vector<std::vector<int>>& faces,
              CameraPoints& points);

}  // namespace ew
