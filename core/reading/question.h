// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/reading/propose/whole_drawing.h"
#include "core/reading/types/interpretation.h"

namespace ew {

/// What was taken becomes a question.
/// \param but  what is to be said of it, after "This could be a Cube"; may be empty.
/// \pre something was taken.
void askInstead(Interpretation& reading, const std::string& but);

/// The first solid that explains a drawing, taken.
/// \pre there is one.
Interpretation wholeOf(WholeReading whole);

/// The same, not taken: it explains the drawing, but not without doubt.
Interpretation offeredWhole(WholeReading whole);

}  // namespace ew
