// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include <array>
#include <vector>

#include "core/document/derived_shape.h"
#include "ui/theme/colours.h"

namespace ew {

/// Straight pieces of lines, world coordinates [mm].
using LinePieces = std::vector<std::array<Vec3, 2>>;

/// The lines that belong to the outermost shape of all bodies.
struct ShapeLines {
    LinePieces crisp;  ///< edges of solids, edges of chamfers, creases of surfaces
    LinePieces soft;   ///< where a round fillet begins
};

ShapeLines shapeLines(const std::vector<Body>& bodies, const DerivedShape& shape);

/// All edges of the cages (of the solids where nothing is filleted), to be shown over a surface.
LinePieces cageLines(const std::vector<Body>& bodies, const DerivedShape& shape);

/// One line a piece, less `origin`.
vtkSmartPointer<vtkPolyData> linesGeometry(const LinePieces& lines, const Vec3& origin);

/// Pieces cut into dashes.
/// \param dashMm  length of a dash [mm]; gaps are two thirds of it.
vtkSmartPointer<vtkPolyData> dashedGeometry(const LinePieces& lines, const Vec3& origin,
                                            double dashMm);

/// Triangles of what is shown flat (solids and cages) with one normal a face.
vtkSmartPointer<vtkPolyData> flatGeometry(const std::vector<Body>& bodies,
                                          const DerivedShape& shape, const Vec3& origin);

/// Triangles of the surfaces with their limit normals.
vtkSmartPointer<vtkPolyData> smoothGeometry(const std::vector<Body>& bodies,
                                            const DerivedShape& shape, const Vec3& origin);

/// Strokes on the surface as flat ribbons that lie on it, as wide as the pen pressed, with their
/// colour at every point, as onBody() shows it.
vtkSmartPointer<vtkPolyData> ribbonGeometry(const DerivedShape& shape,
                                            const std::vector<MappedStroke>& mapped,
                                            const Vec3& origin, const ThemeColours& colours);

}  // namespace ew
