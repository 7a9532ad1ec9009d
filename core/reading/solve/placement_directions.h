// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "core/reading/extract/joint_graph.h"
#include "core/reading/extract/model_directions.h"
#include "core/reading/solve/linear_fit.h"
#include "core/tlib/matcher.h"

namespace ew {

using FacePairs = std::vector<std::array<int, 2>>;  ///< template face, face of the solid
std::vector<int> solidFacesOf(const FacePairs& pairs);

/// Which directions of the model the direction classes of a template take.
struct DirectionAssignment {
    std::vector<std::optional<ModelDirection>> byClass;  ///< not set: free
    double price = 0.0;  ///< how far it is from the obvious; in units of a candidate's cost
    double cost = 0.0;   ///< the part of the price that counts after solving, too

    KnownDirections known() const;
};

struct DirectionOptions {
    double angleDeg = 12.0;  ///< a drawn direction this near to the model's may be the model's
    double noisePx = 1.0;    ///< how far line ends miss
};

/// Assignments of the model's directions to what was drawn, the most obvious first: a class with an
/// edge of the model takes its direction; others those near on the screen that lie in the faces in
/// which the class has edges; or none.
/// \param limit  at most so many.
/// \paper{5.2.2}
std::vector<DirectionAssignment> directionAssignments(
    const JointReading& reading, const GraphMatch& match, const ModelView& model,
    const FacePairs& pairs, const DirectionOptions& options, std::size_t limit);

}  // namespace ew
