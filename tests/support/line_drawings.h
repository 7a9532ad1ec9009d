// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/stroke/stroke.h"

namespace ew::test {

/// A stroke of a drawing from a file, with what the file says about it.
struct ImportedStroke {
    Stroke stroke;        ///< [Sketch Plane px]; times are 0, as the files have none
    int cluster = -1;     ///< strokes with the same number are meant as one line; -1: not said
    bool hidden = false;  ///< drawn as a hidden line
};

/// A drawing from a file, scaled so that the diagonal of its bounding box has the wanted length
/// and put in the middle of a 1280 x 800 viewport.
struct LineDrawing {
    std::string name;  ///< of the item in its library, else the file's name
    std::vector<ImportedStroke> strokes;
    double pxPerUnit = 1.0;  ///< of the file's units

    /// The strokes that are not hidden lines.
    std::vector<Stroke> visible() const;
    /// The strokes of these clusters, in file order.
    std::vector<Stroke> clusters(const std::vector<int>& numbers) const;
};

inline constexpr double kImportDiagonalPx = 400.0;

/// The clusters of building_SA_cluster.scap that draw the building's outer box: the front's left,
/// upper, right and lower edge, the top's left, back and right edge, the side's far and lower edge.
inline const std::vector<int> kBuildingOuterBox{0, 6, 23, 28, 32, 8, 58, 33, 34};

/// The folder with drawings that were not made for this program: $EDGEWRIGHT_DRAWINGS, else
/// shared/data beside the source tree. They are no part of the project; empty where the folder is
/// not there.
std::string outsideDrawings();

/// Reads the <line> elements of the groups "Visible" and "Hidden" of a hidden-line drawing in SVG
/// as exact strokes with a sample about every 4 px. Understands one transform, scale(1,-1). Errors:
/// Errc::FileNotFound, Errc::WrongFormat.
Result<LineDrawing> readHiddenLineSvg(const std::string& path,
                                      double diagonalPx = kImportDiagonalPx);

/// Reads pen strokes in SCAP: "#width height", "@thickness", then per stroke "{", "#stroke
/// cluster",
/// "@thickness", lines of "x y pressure", "}". Errors: Errc::FileNotFound, Errc::WrongFormat.
Result<LineDrawing> readScap(const std::string& path, double diagonalPx = kImportDiagonalPx);

/// Reads the items of an Excalidraw library: lines and rectangles as exact strokes (their rotation
/// applied, dashed ones as hidden), every other element is left out; an item without any is no
/// drawing. Errors: Errc::FileNotFound, Errc::WrongFormat.
Result<std::vector<LineDrawing>> readExcalidrawLibrary(const std::string& path,
                                                       double diagonalPx = kImportDiagonalPx);

}  // namespace ew::test
