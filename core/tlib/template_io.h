// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "core/tlib/template.h"

namespace ew {

/// Most vertices that a template may have.
inline constexpr std::size_t kMaxTemplateVertices = 64;

/// Reads a template from JSON text (schema in resources/templates/README.md) and checks it:
/// closed, connected, oriented, planar, indices in range, relations hold for the reference shape.
/// \param source  name for messages, e.g. the file name.
/// Errors: Syntax, WrongFormat, WrongVersion, UnknownKey, MissingKey, WrongType, BadValue,
/// TooLarge, TooDeep, BadTemplate; messages name the JSON path, e.g. "cube.json: /faces/2/0: ...".
/// \paper{4.2}
Result<Template> readTemplate(std::string_view json, const std::string& source);

/// The template as JSON text that readTemplate reads back.
std::string writeTemplate(const Template& tmpl);

/// The checks of readTemplate on a template that did not come from a file: 4 to
/// kMaxTemplateVertices vertices, ids, the shape (closed, connected, oriented, planar, no flat
/// fold, no self-intersection, positive volume) and the relations (real edges, consistent senses,
/// no contradiction, true of the reference shape). Every failure is Errc::BadTemplate.
/// \param source  prefixes the JSON paths in messages.
Result<void> checkTemplate(const Template& tmpl, const std::string& source);

}  // namespace ew
