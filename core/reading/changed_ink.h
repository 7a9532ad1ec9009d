// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>

#include "core/edge_graph/build.h"
#include "core/reading/interpret.h"

namespace ew {

/// Reads ink as a drawing in free space.
using ReadInk = std::function<Interpretation(const InkReading&)>;

/// Lines that run past the corners, as guide lines do, read as the edges between these. What can
/// be trimmed to two solids at much the same cost is a question.
/// \return nothing where few lines run past anything, or where the drawing may have other lines,
///         too.
std::optional<Interpretation> readWithoutGuides(const InkReading& ink,
                                                const TemplateLibrary& library,
                                                const InterpretOptions& options,
                                                const ReadInk& alone);

/// Few lines that stand for a whole drawing (see completedGestures), offered as what they stand
/// for.
std::optional<Interpretation> readGesture(const InkReading& ink, const InterpretOptions& options,
                                          const ReadInk& alone);

}  // namespace ew
