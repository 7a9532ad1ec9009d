// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/edge_graph/build.h"
#include "core/reading/types/interpretation.h"

namespace ew {

/// A drawing in free space: Edge Graphs of the ink (case 1), corrections of them and
/// aspects laid over the ink as a whole, matched with the library and reconstructed;
/// all candidates compete under one cost.
/// \paper{4.1.1}
Interpretation readFreeDrawing(const InkReading& ink, const TemplateLibrary& library,
                               const InterpretOptions& options);

}  // namespace ew
