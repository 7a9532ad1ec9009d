// SPDX-License-Identifier: GPL-3.0-or-later
// Private to core/document: the steps of a script that are about whole bodies.
#pragma once

#include "core/document/json_text.h"
#include "core/document/sketch_script.h"

namespace ew {

// Each reads one step. Throws ReadError.
ScriptStep readPullStep(const ObjectReader& step);
ScriptStep readMoveBodyStep(const ObjectReader& step);
ScriptStep readNameBodyStep(const ObjectReader& step);
ScriptStep readShowBodyStep(const ObjectReader& step);
ScriptStep readDeleteBodyStep(const ObjectReader& step);
ScriptStep readCombineBodiesStep(const ObjectReader& step);
ScriptStep readMirrorPlaneStep(const ObjectReader& step);

}  // namespace ew
