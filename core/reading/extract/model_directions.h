// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/reading/extract/model_view.h"

namespace ew {

/// Directions of the edges and normals of some faces and of their neighbours, each once; those of
/// the faces themselves first. Last those that lie in one of these faces across one of its edges.
const std::vector<ModelDirection>& directionsNear(const ModelView& model,
                                                  const std::vector<int>& faces);

}  // namespace ew
