// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/json_text.h"
#include "core/document/sketch_script.h"

namespace ew {

// The steps of the surface: fillet, sharpen, crease, subdivide, map_strokes. Each throws ReadError.
ScriptStep readFilletStep(const ObjectReader& step);
ScriptStep readSharpenStep(const ObjectReader& step);
ScriptStep readCreaseStep(const ObjectReader& step);
ScriptStep readSubdivideStep(const ObjectReader& step);
ScriptStep readMapStrokesStep(const ObjectReader& step);

}  // namespace ew
