// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/tlib/template.h"

namespace ew {

/// Templates in one file to pass on (.edgewright-templates): a zip archive with manifest.json and
/// templates/ID.json (resources/templates/README.md).
struct TemplatePack {
    std::string name;
    std::string author;   ///< may be empty
    std::string licence;  ///< an SPDX expression, or words; may be empty
    std::string version;  ///< of the pack; may be empty
    std::vector<Template> templates;
};

/// The pack as the bytes of a file; equal packs give equal bytes. Errors: BadValue (no name, no
/// template, a text that is too long), DuplicateId, BadTemplate.
Result<std::string> writeTemplatePack(const TemplatePack& pack);

/// Reads writeTemplatePack's bytes. Nothing is written; what a pack holds besides is refused, and
/// so is what would lead out of a folder. \param source  name for messages. Errors: those of
/// readZip() and readTemplate(), MissingKey, UnknownKey, WrongType, WrongFormat, WrongVersion,
/// BadValue, DuplicateId; messages name the file in the pack and the JSON path.
Result<TemplatePack> readTemplatePack(const std::string& bytes, const std::string& source);

}  // namespace ew
