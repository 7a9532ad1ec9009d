// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include "core/reading/types/interpretation.h"

namespace ew {

/// Reads other strokes with the same library and options.
using ReadAgain = std::function<Interpretation(const std::vector<Stroke>&)>;

/// Why a drawing was refused, by what would have been read without the fault: the drawing with one
/// curve straightened, one line added or some lines dropped is read again, and where that is taken
/// by itself, what was changed is the cause. The problem becomes CurvedEdge, MissingEdge, ExtraEdge
/// or HiddenLine with its place, and what was changed the first repair; so a repair that is offered
/// is one that works. Lines that lie nearer together than what counts as meeting are TooSmall, and
/// what nothing else explains and converges is in Perspective.
/// Other readings stay as they are.
/// Cost: a bounded number of readings (kMostReadings), none where the reading names another cause.
/// \param strokes  what was read.
void findCause(const std::vector<Stroke>& strokes, const TemplateLibrary& library,
               const InterpretOptions& options, const ReadAgain& read, Interpretation& reading);

}  // namespace ew
