// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string_view>

namespace ew {

/// What the faces of solids and cages become in .obj and .ply.
enum class ExportFaces {
    Simple,     ///< "simple": convex faces of up to four corners as they are, others as triangles,
                ///< which every reader takes
    Triangles,  ///< "triangles"
    Polygons,   ///< "polygons": whole planar faces, as few as there can be
};

/// The word of a script or command line for it.
std::string_view exportFacesName(ExportFaces faces);
/// Nothing for any other word.
std::optional<ExportFaces> exportFacesFromName(std::string_view name);

}  // namespace ew
