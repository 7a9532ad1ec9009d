// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/reading/extract/model_view.h"
#include "core/reading/propose/placement.h"

namespace ew {

/// Fills in the tool's shape, in the solid's frame and seen from outside counter-clockwise, and the
/// faces that lie in faces of the solid. False where it encloses nothing.
bool finishTool(Placement& placement, const Template& tmpl, const ModelView& model);

}  // namespace ew
