// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/base/error.h"
#include "core/reading/score/misfit.h"
#include "core/reading/solve/rectilinear_fit.h"
#include "core/tlib/library_index.h"

namespace ew {

/// What a drawing may have been meant as, were it drawn right in one place. It makes no solid; it
/// keeps a freer shape, which explains the slip as a part of itself, from being taken in silence,
/// and it says why nothing else fits.
struct Slip {
    Errc code = Errc::NotParallel;  ///< NotParallel: a corner is out of place; ImpossibleCorner: a
                                    ///< right-angled corner that no view shows
    Vec2 at = Vec2::Zero();         ///< the corner as it is drawn [px]
    Vec2 meant = Vec2::Zero();      ///< where it would fit [px]; `at` for ImpossibleCorner
    double cost = 0.0;              ///< in the units of RatedCandidate::cost
    double misfit = 0.0;            ///< Misfit::perEnd of what is not the slip
    std::string templateId;
    std::string templateName;
};

/// Of a template with edges in three directions, drawn with one corner out of place: the corner
/// without which the rest fits best.
/// \param noisePx, cornerPx  see misfitOf().
/// \return nothing where no corner lies farther off than `leastPx`, or leaving one out helps
/// little. Cost: one linear fit a corner. \pre the template is rectilinear.
std::optional<Slip> movedCorner(const Sighting& sighting, const LibraryEntry& entry, double noisePx,
                                double cornerPx, double leastPx);

/// The least of them that another shape than this template might be a slip of, where the rest of
/// the drawing fits as hands draw; nullptr: none costs less than `below`.
const Slip* likeliestSlip(const std::vector<Slip>& slips, const std::string& templateId,
                          double below);

}  // namespace ew
