// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/reading/types/interpretation.h"

namespace ew {

/// Steps 1 to 3 (and 4 for drawings on a solid): strokes to candidates. Never throws, never reads
/// global state; a drawing that cannot be read gives an Interpretation with `problem` set.
/// \param strokes  pending strokes, Sketch Plane px of options.camera.
/// \paper{3.2}
Interpretation interpret(const std::vector<Stroke>& strokes, const TemplateLibrary& library,
                         const InterpretOptions& options);

}  // namespace ew
