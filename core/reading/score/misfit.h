// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/reading/evidence/sighting.h"

namespace ew {

/// How far line ends are from the projected edges.
struct Misfit {
    double perEnd = 0.0;  ///< squared distance over its variance, on average
    double cost = 0.0;    ///< twice the negative log-likelihood
};

/// What a hand explains of it: ends that miss the corner, and corners that are not where they are
/// meant to be. The tails are Student's, so that one slip, or a hand that is worse than it looks,
/// does not make a freer shape out of a plain one.
/// \param points   per template vertex, as fitted; camera space.
/// \param noisePx  how far lines of this hand miss what they are meant to meet.
/// \param cornerPx how far its corners lie from where they are meant.
/// \param without  a template vertex whose line ends do not count, -1: all do.
Misfit misfitOf(const Sighting& sighting, const TemplateAnalysis& analysis,
                const CameraPoints& points, double noisePx, double cornerPx, int without = -1);

}  // namespace ew
