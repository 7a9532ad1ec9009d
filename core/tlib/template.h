// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/base/result.h"
#include "core/base/vec.h"
#include "core/solid/polyhedron_spec.h"

namespace ew {

/// An edge of a template, named by its two vertices; as a direction it runs first -> second.
using TemplateEdge = std::array<int, 2>;

/// Relations that every instance of a template keeps. Each parallel or equal-length entry is a
/// class of two or more edges; each perpendicular entry is a pair. Planarity of the faces is
/// always meant.
struct TemplateRelations {
    std::vector<std::vector<TemplateEdge>> parallel;
    std::vector<std::array<TemplateEdge, 2>> perpendicular;
    std::vector<std::vector<TemplateEdge>> equalLength;
};

/// A named way to close the degrees of freedom that a drawing leaves open, e.g. "right-angled".
struct TemplateReading {
    std::string id;
    std::string name;
    TemplateRelations relations;  ///< held in addition to the template's own
};

/// Name and description in another language; what is empty is said in English.
struct TemplateWords {
    std::string name;
    std::string description;
    bool operator==(const TemplateWords&) const = default;
};

/// Who made a template, and how it is found among many. Reading never looks at it.
struct TemplateAbout {
    std::string category;           ///< one, e.g. "Buildings"
    std::vector<std::string> tags;  ///< words to search for
    std::string author;             ///< a person's name
    std::string licence;            ///< an SPDX expression, or words
    std::string version;            ///< of the template, in the author's own count
    std::map<std::string, TemplateWords> inLanguage;  ///< by language code, e.g. "de", "pt-BR"
    bool operator==(const TemplateAbout&) const = default;
};

/// A template of T-LIB: a 3D topology with its relations (docs/design.md, step 2).
/// \paper{4.2}
struct Template {
    std::string id;           ///< stable, [a-z0-9-]+
    std::string name;         ///< shown to people
    std::string description;  ///< one sentence, may be empty
    PolyhedronSpec shape;     ///< the reference shape: the most regular instance
    TemplateRelations relations;
    std::vector<TemplateReading> readings;  ///< besides the default, the most regular one
    TemplateAbout about;
};

}  // namespace ew
