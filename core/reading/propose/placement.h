// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/reading/evidence/sighting.h"
#include "core/reading/extract/joint_graph.h"
#include "core/reading/solve/placement_directions.h"
#include "core/reading/types/interpretation.h"
#include "core/solid/exact_tool.h"
#include "core/tlib/matcher.h"

namespace ew {

/// A template placed on a solid: some of its faces lie in faces of the solid, the
/// rest is new.
/// \paper{5.2.1}
struct Placement {
    Operation operation = Operation::Cut;        ///< Add or Cut
    std::vector<std::array<int, 2>> coinciding;  ///< template face, face of the solid
    CameraPoints points;                         ///< per template vertex, camera space [px]
    ToolSpec tool;                   ///< the same in the solid's frame, with what is exact
    DirectionAssignment directions;  ///< what it was solved with
    double residualPx = 0.0;         ///< rms distance of line ends to the projected edges
    double misfit = 0.0;  ///< squared distances of line ends over the noise's variance, summed
    int open = 0;         ///< degrees of freedom that only regularity closed
    int parameters = 0;   ///< degrees of freedom, those included
    double cost = 0.0;    ///< misfit and prices; see RatedCandidate
};

struct PlacementOptions {
    Thresholds thresholds;
    double noisePx = 1.0;  ///< how far this hand's line ends miss what they aim at
    bool plain = false;    ///< only where all directions are the model's: much quicker
};

/// All ways to place a matched template: a mouth or cavity lies in the faces under it and cuts, a
/// body seen from outside stands with one of its hidden faces on a face and adds. Vertices on
/// faces, edges and corners are anchored there; directions within the angle threshold of the
/// model's are the model's; faces within the distance threshold of a parallel face of the model lie
/// in it. Cheapest first.
/// \paper{5.2.1}
std::vector<Placement> placementsOf(const JointGraph& joint, const JointReading& reading,
                                    const GraphMatch& match, const ModelView& model,
                                    const PlacementOptions& options);

/// What a template is known to do on a solid.
struct Seat {
    Operation operation = Operation::Cut;  ///< Add or Cut
    FacePairs faces;                       ///< template face, face of the solid
};

/// The template placed with just these of its faces in faces of the solid.
std::vector<Placement> placementsOn(const Seat& seat, const JointGraph& joint,
                                    const JointReading& reading, const GraphMatch& match,
                                    const ModelView& model, const PlacementOptions& options);

/// The placement with one of its hidden faces moved into the plane of a parallel face of the solid,
/// so that the body becomes smaller; the ink that speaks against it is overruled. Nothing where no
/// hidden face is parallel.
/// \paper{5.2.3}
std::optional<Placement> adjustedPlacement(const JointGraph& joint, const JointReading& reading,
                                           const GraphMatch& match, const ModelView& model,
                                           const PlacementOptions& options,
                                           const Placement& placement, int face);

/// The placement with one of its hidden faces moved parallel to itself so that the body stays clear
/// of some faces of the solid by a distance threshold; the ink that speaks against it is overruled.
/// Nothing where no single face can be moved that far.
std::optional<Placement> clearPlacement(const JointGraph& joint, const JointReading& reading,
                                        const GraphMatch& match, const ModelView& model,
                                        const PlacementOptions& options, const Placement& placement,
                                        const std::vector<int>& faces);

}  // namespace ew
