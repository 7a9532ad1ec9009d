// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/reading/evidence/sighting.h"
#include "core/reading/propose/placement.h"

namespace ew {

/// Squared distances of the drawn line ends to the lines of the placed edges, over the variance of
/// the hand's noise, summed.
double misfitOf(const Sighting& sighting, const TemplateAnalysis& analysis,
                const CameraPoints& points, double noisePx);

/// Direction classes that come out along no direction of the model near the faces that the
/// placement lies in.
int strangeDirections(const Placement& placement, const TemplateAnalysis& analysis,
                      const ModelView& model);

/// What a placement's cost is made of.
/// \param cost  with what the drawing as a whole has to pay.
Evidence evidenceOf(const Placement& placement, double cost);

}  // namespace ew
