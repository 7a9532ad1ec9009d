// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/document/document.h"

namespace ew {

/// What keeps a pupil's result from being the one that a lesson wants.
enum class Unlike {
    Nothing,      ///< it is that one
    NotYet,       ///< nothing was made or changed
    Bodies,       ///< "separate-drawings": more solids than wanted
    Side,         ///< "wrong-side": cut where it was to be added, or the other way round
    Shape,        ///< "wrong-shape": another kind of shape
    Place,        ///< "wrong-place": the right shape where it does not belong
    Proportions,  ///< "wrong-proportions": much longer, flatter or larger than wanted
    Settings,     ///< "wrong-settings": another fillet, surface, template or stroke on the surface
};

/// Stable text of it; empty for Nothing.
std::string unlikeName(Unlike unlike);

/// A sentence that says it to a pupil; empty for Nothing.
std::string unlikeSentence(Unlike unlike);

/// Compares what a step of a lesson made. Where it makes or changes solids, their counts of
/// corners, edges and faces count, and their proportions within `tolerance`; where a solid is, how
/// it is turned and how large it is do not, nor which of the places of a change it is that a turn
/// or a mirror image of the solid before brings over each other. Cost: O(solids' sizes). \param
/// before  the state from which both began
Unlike likeness(const DocumentState& before, const DocumentState& wanted, const DocumentState& made,
                double tolerance);

/// How far the proportions of one made solid are off from those of the wanted one, as a share; 1
/// where either has not exactly one.
double proportionsOff(const DocumentState& wanted, const DocumentState& made);

}  // namespace ew
