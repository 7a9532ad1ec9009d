// SPDX-License-Identifier: GPL-3.0-or-later
// Private to core/solid.
#pragma once

#include "core/solid/reassemble.h"

namespace ew {

/// reassemble(), after changed faces whose planes have longer coefficients than tol::kLightBits
/// were moved to planes with short ones next to them, and their corners with them (about 1e-12 of
/// the size). Parts that stand on slanted parts that stand on slanted parts would else double the
/// length of the numbers every time. Where no such planes fit together or the gate refuses them,
/// everything stays as it is. Faces that lie in one plane keep doing so, parallel ones too.
/// Errors: those of reassemble(), and TooLarge beyond tol::kMaxExactBits.
Result<std::shared_ptr<const Solid::Impl>> reassembleSimplified(const Solid::Impl& base,
                                                                ChangedBrep changed);

}  // namespace ew
