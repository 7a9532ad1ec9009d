// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <functional>

#include "core/base/result.h"
#include "core/document/document.h"
#include "core/tlib/family.h"

class QMenu;

namespace ew {

/// A family in the language of the window: "Prism".
QString familyText(Family family);

/// Fills a menu with everything that a template's shape can come from: the solids of a document,
/// the templates in use, families over polygons. `take` gets the template or why there is none.
void fillSources(QMenu* menu, const DocumentState& state,
                 const std::function<void(Result<Template>)>& take);

}  // namespace ew
