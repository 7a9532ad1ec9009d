// SPDX-License-Identifier: GPL-3.0-or-later
// Private to core/document.
#pragma once

#include <QString>
#include <memory>

#include "core/document/document.h"

namespace ew {

/// The document after a candidate was taken. What stands apart in it becomes a body of its own.
/// \param keep  of a solid that is cut in two: the larger part stays the body that it was, the
///     smaller one becomes the last body.
/// Errors: OperationImpossible, NoSolution, those of Solid::fromSpec().
Result<std::shared_ptr<const DocumentState>> withCandidate(const DocumentState& before,
                                                           const Candidate& candidate,
                                                           SplitKeep keep);

/// The same on both sides of the mirror plane, where there is one; see withMirrorImage().
/// \param reach  how far faces may be from the plane that they were drawn in [mm].
Result<std::shared_ptr<const DocumentState>> withCandidate(const DocumentState& before,
                                                           const Candidate& candidate,
                                                           SplitKeep keep, double reach);

/// What is set for the edges of one of a document's bodies.
EdgeSettings edgesOf(const DocumentState& state, int body);

/// The step's name, as shownStepName() knows it.
QString commandName(const Candidate& candidate);

}  // namespace ew
