// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace ew {

/// Frees the patches that surfaces leave for the next ones of much the same topology; what is being
/// made keeps its own. Any thread.
void forgetPatches();

}  // namespace ew
