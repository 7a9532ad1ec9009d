// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/document/export_faces.h"

namespace ew {

/// What one unit of length is in a mesh file that does not say so itself (.obj, .stl, .ply).
enum class ExportUnit {
    Millimetre,  ///< "mm"
    Centimetre,  ///< "cm"
    Metre,       ///< "m"
    Inch,        ///< "inch"
};

/// The word of a script, a command line or a settings file for it.
std::string_view exportUnitName(ExportUnit unit);
/// Nothing for any other word.
std::optional<ExportUnit> exportUnitFromName(std::string_view name);
/// How many of these units a millimetre is.
double unitsPerMm(ExportUnit unit);

/// Does the format of this file leave open what its numbers mean?
/// \param path  its extension counts, in any case of letters.
bool formatLacksUnit(const std::string& path);

struct ExportOptions {
    ExportOptions(ExportFaces wanted = ExportFaces::Simple)  // NOLINT: faces alone are enough
        : faces(wanted) {}

    ExportFaces faces;
    ExportUnit unit = ExportUnit::Millimetre;  ///< where formatLacksUnit()
    std::vector<int> bodies;                   ///< by index; empty: all of them
    /// Told how much is done, 0..1, at least every 100,000 faces; where it returns false, nothing
    /// is written. May be empty. Called on the thread that exports.
    std::function<bool(double share)> progress;
};

}  // namespace ew
