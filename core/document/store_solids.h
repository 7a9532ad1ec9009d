// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "core/document/store.h"
#include "core/document/store_blobs.h"
#include "core/solid/solid.h"

namespace ew {

/// The solids in blobs, by as many threads as there are processors.
/// \param whole  each is checked as if it were new, which is most of the work of opening a long
///     history. Else only that its bytes are those that were written: what they say is read and
///     checked when the solid is first looked at (Solid::deferred).
/// \param progress  told on the calling thread; where it gives up, what was not read is Cancelled.
/// \return for each blob its solid, or the errors of unpackBlob() and Solid::deserialize().
std::vector<Result<Solid>> solidsFromBlobs(std::span<const PackedBlob* const> blobs, bool whole,
                                           const ReadProgress& progress);

}  // namespace ew
