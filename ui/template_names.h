// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace ew {

class TemplateLibrary;

/// Takes note of what templates say of themselves in the language of the window: names and
/// descriptions, by what they are in the template itself. Noted once, they stay known.
void learnTemplateNames(const TemplateLibrary& library);

/// A template's name or description in the language of the window; the text itself where nothing is
/// known of it.
QString ownTemplateText(const QString& text);

}  // namespace ew
