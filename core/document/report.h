// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <string>
#include <vector>

#include "core/document/document.h"
#include "core/document/replay.h"

namespace ew {

/// The bodies of a document together, in world coordinates.
struct SolidSummary {
    int vertices = 0, edges = 0, faces = 0;  ///< as a person counts them
    int shells = 0, genus = 0;
    double volume = 0.0;                                     ///< [mm^3]
    double area = 0.0;                                       ///< [mm^2]
    std::array<Vec3, 2> bounds{Vec3::Zero(), Vec3::Zero()};  ///< [mm]
    std::vector<Vec3> positions;                             ///< [mm], body after body
};

SolidSummary summarize(const std::vector<Body>& bodies);

/// The report of a replay as the sketch script contract lays it down, as JSON text. Numbers read
/// back to the bit. Every step has every key; `edge_graph` and `match` are null where there was
/// none, and a failed apply that had readings lists them under `candidates`.
/// \param scriptName  file name of the script.
std::string writeReport(const Document& document, const ReplayReport& report,
                        const std::string& scriptName);

}  // namespace ew
