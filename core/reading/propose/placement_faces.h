// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/reading/evidence/sighting.h"
#include "core/reading/extract/joint_graph.h"
#include "core/reading/extract/model_view.h"
#include "core/tlib/matcher.h"

namespace ew {

/// Faces of the solid, at most three, that face `t` of a template may lie in, those with the most
/// evidence first: the model edges that its edges run along, and what is seen beside its edges.
/// \param outside  the template stands on the face, so that it is seen outside of the drawing;
///                 otherwise the face is cut and seen within.
std::vector<int> facesUnder(int t, const JointReading& reading, const GraphMatch& match,
                            const ModelView& model, const Sighting& sighting, bool outside);

}  // namespace ew
