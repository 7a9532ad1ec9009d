// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/reading/score/candidates.h"
#include "core/reading/score/slips.h"
#include "core/reading/types/interpretation.h"

namespace ew {

/// What the pipeline knows when no candidate was accepted.
struct Findings {
    const std::vector<RatedCandidate>* candidates = nullptr;  ///< best first
    const Slip* slip = nullptr;         ///< what it was more likely meant as, were it drawn right
    std::vector<EdgeGraph> otherParts;  ///< further connected drawings
    bool onlyOutlines = false;          ///< the candidates are none of the graph's
    bool ambiguous = false;             ///< two different candidates too close
    bool leavesInk = false;             ///< the best leaves more ink aside than a slip of the pen
    bool twoFaces = false;              ///< just two faces of the best were drawn
    bool accidental = false;            ///< nothing that is seen tells the best from simpler shapes
    bool flat = false;                  ///< one outline and nothing inside it
    bool absurd = false;                ///< the best is far deeper or thinner than it was drawn
    bool blockedByOpenEnd = false;      ///< a match exists, but only without an open line
};

/// Says why: fills problem, culprits, repairs and nearest of an interpretation whose graph and
/// candidates are set. The first reason that applies is the one told; see Errc.
void explain(Interpretation& reading, const Findings& findings, const TemplateLibrary& library,
             const InterpretOptions& options);

}  // namespace ew
