// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/reading/types/interpretation.h"
#include "core/stroke/stroke.h"

namespace ew {

/// What a line across a solid means as the trace of a plane that cuts it in two: a line over two
/// faces or more, in one stroke or several, tells the plane; one over a single face cuts square to
/// it. A plane that is nearly square to an edge, or parallel to a face, is so exactly.
/// \return candidates with Operation::Split, or a problem with its place: NoSurface (the line runs
///     over no solid), OpenEnd (it ends inside a face), CurvedStroke (it lies in no plane), and
///     those of combine().
/// \pre the strokes pass validateStroke(); there is a body.
/// Cost: a SolidView of each body and two exact booleans a candidate.
Interpretation readCuttingPlane(const std::vector<Stroke>& strokes,
                                const InterpretOptions& options);

}  // namespace ew
