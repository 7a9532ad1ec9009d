// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/edge_graph/build.h"
#include "core/reading/types/interpretation.h"

namespace ew {

/// What strokes on the solids that are there may mean.
struct ModificationReading {
    Interpretation interpretation;  ///< graph, candidates that add or cut, accepted or problem
    bool touches = false;           ///< some stroke meets a solid, or most of the ink lies over one
    bool redraws = false;           ///< all strokes are edges of a solid already
};

/// Step 4: extracts the model edges that the strokes meet, matches the joint
/// graph with the aspects of templates on a solid, anchors, and carries every candidate's change
/// out, exactly. Nothing is changed in place.
/// \paper{5.2}
ModificationReading readModification(const InkReading& ink, const TemplateLibrary& library,
                                     const InterpretOptions& options);

}  // namespace ew
