// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reading/propose/cracking.h"

#include <algorithm>
#include <cmath>

#include "core/base/tolerance.h"

namespace ew {

std::vector<int> crackedFaces(const Solid& target, const BooleanReport& report,
                              const Placement& placement) {
    std::vector<bool> whole(target.faces().size(), false);
    for (std::size_t f = 0; f < report.faceOrigin.size(); ++f) {
        const FaceOrigin& origin = report.faceOrigin[f];
        if (!origin.fromTool && report.faceUnchanged[f]) {
            whole[static_cast<std::size_t>(origin.face)] = true;
        }
    }
    // What lies in the plane of a face that was drawn on is drawn on.
    const auto drawnOn = [&](const SolidFace& f) {
        return std::any_of(
            placement.coinciding.begin(), placement.coinciding.end(), [&](const auto& pair) {
                const SolidFace& g = target.faces()[static_cast<std::size_t>(pair[1])];
                return f.normal.cross(g.normal).norm() < tol::kSolidDirection &&
                       std::abs(f.offset - g.offset) <=
                           tol::kPlanarRelative * (1 + std::abs(g.offset));
            });
    };
    std::vector<int> cracked;
    for (std::size_t f = 0; f < whole.size(); ++f) {
        if (!whole[f] && !drawnOn(target.faces()[f])) cracked.push_back(static_cast<int>(f));
    }
    return cracked;
}

}  // namespace ew
