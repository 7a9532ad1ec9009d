// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/examples/model_maker.h"

namespace ew::test {

/// The three models of the paper's section 7. Each throws std::runtime_error where a sketch is not
/// read as it was meant.
/// \paper{7.1} \paper{7.2} \paper{7.3}
void drawPrinter(ModelMaker& m);
void drawClock(ModelMaker& m);
void drawMouse(ModelMaker& m);

}  // namespace ew::test
