// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include "core/base/camera.h"
#include "ui/theme/colours.h"

namespace ew {

struct GridLayout {
    double spacing = 0.0;        ///< [mm]: 1, 2 or 5 times a power of ten
    double height = 0.0;         ///< world z [mm]
    Vec2 centre = Vec2::Zero();  ///< world x, y, a multiple of the spacing
    bool operator==(const GridLayout&) const = default;
};

/// A grid that suits the camera: cells of 22 to 60 px, under the bodies, round what is looked at.
GridLayout gridLayout(const OrthographicCamera& camera, double height);

/// Grid lines with a colour at every point that fades into the background.
vtkSmartPointer<vtkPolyData> gridGeometry(const GridLayout& layout, const Vec3& origin,
                                          const ThemeColours& colours);

/// Half the side of the grid, in cells.
inline constexpr int kGridCells = 40;

}  // namespace ew
