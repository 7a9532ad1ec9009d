// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/document.h"

namespace ew {

/// True where both have the same solids to the bit, in the same poses, the same templates added,
/// surface settings and strokes on the surface.
bool identicalStates(const DocumentState& a, const DocumentState& b);

/// True where both have the same history, by names and by every state, the same number of steps
/// done, and the same ink that waits, sample by sample.
bool identicalDocuments(const Document& a, const Document& b);

}  // namespace ew
