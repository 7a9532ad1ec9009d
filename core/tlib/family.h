// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/tlib/template.h"

namespace ew {

/// Shapes that there are over a polygon of any number of corners.
enum class Family { Prism, Pyramid, Frustum };

inline constexpr int kFewestCorners = 3;
inline constexpr int kMostCorners = 24;

/// A right prism, pyramid or frustum over a regular polygon as the reference shape: about as high
/// as it is wide, base on z = 0. It keeps its parallel edges and right angles; pyramid and frustum
/// keep the lengths of their slanting edges equal, too. Its id and name are English words:
/// "prism-6", "Prism over 6 corners".
/// \param corners  of the base, kFewestCorners to kMostCorners.
Template familyTemplate(Family family, int corners);

}  // namespace ew
