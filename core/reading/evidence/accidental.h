// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/reading/evidence/sighting.h"
#include "core/tlib/library_index.h"

namespace ew {

/// Is what tells this body from simpler ones nowhere to be seen? A parallel projection keeps
/// parallels, so a face that tapers never looks like a parallelogram. Where all visible faces do,
/// although some of them taper in the template and the body goes on to taper where it is hidden,
/// the drawing is more likely one of a box that is seen straight along its other faces.
/// \param body  per template vertex, camera space: its picture and depth as fitted to the ink.
/// \return false for aspects other than explicit ones.
bool hidesItsTaper(const LibraryEntry& entry, const Aspect& aspect, const CameraPoints& body);

}  // namespace ew
