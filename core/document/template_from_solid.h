// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/solid/solid.h"
#include "core/tlib/template.h"

namespace ew {

/// The one body as a template: its vertices and faces (body frame), every class of parallel edges,
/// and one perpendicular pair for every two edge directions that meet in a vertex at a right angle.
/// Equal lengths are not taken over: they are mostly chance.
/// Errors: NoSolid; BadTemplate for several bodies and for faces with holes. Whether the template
/// can be used is checked by TemplateLibrary::with. O(E^2).
/// \paper{4.2}
Result<Template> templateFromBodies(const std::vector<Body>& bodies, const std::string& id,
                                    const std::string& name);

}  // namespace ew
