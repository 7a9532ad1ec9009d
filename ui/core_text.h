// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <string>

namespace ew {

/// A text of the core (a problem's sentence, a label, a note, the name of a shipped template) in
/// the language of the window. The core speaks English and knows nothing of Qt, so its sentences
/// are recognised by their wording; one that is not known stays English. The names that people gave
/// their own templates are told as ownTemplateText() has them.
QString coreText(const std::string& english);

/// A template's shape in a sentence about what was done, in the language of the window: "a box",
/// "an L-prism"; with its article where the language wants one.
QString solidText(const std::string& templateName);

/// A step of a script by its word in files ("export"), in the language of the window.
QString stepText(const std::string& word);

}  // namespace ew
