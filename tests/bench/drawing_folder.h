// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace ew::test {

/// Replays every sketch script that `FOLDER/expect.json` names and prints how each was read.
///
/// expect.json: {"NAME": {"expect": TEXT}, ...} for FOLDER/NAME.json. TEXT up to a semicolon says
/// what is right: "box" or another template's name or id, "nothing ..." (a flat drawing: nothing
/// may be made), anything else is a shape that no single template is; "..., or refusal" after it
/// is allowed. A drawing of such a shape is wrong in silence where a solid is made of it without a
/// question.
/// \return 0, or 2 where the folder cannot be read.
int runDrawingFolder(const std::string& folder);

}  // namespace ew::test
