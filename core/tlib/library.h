// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "core/tlib/template.h"

namespace ew {

struct LibraryIndex;  // aspects of all templates and their hash index; see aspects.h, matcher.h

/// The topology library (T-LIB): templates with their derived aspects. A value; copies share the
/// templates. Adding a template returns a new library, so snapshots for undo are cheap.
/// \paper{4.2}
class TemplateLibrary {
  public:
    TemplateLibrary();

    /// The library with one more template, its aspects derived. Errc::DuplicateId where the id is
    /// taken, Errc::BadTemplate where it fails checkTemplate.
    Result<TemplateLibrary> with(Template tmpl) const;
    /// Many at once (linear in their number). All or nothing.
    Result<TemplateLibrary> withAll(std::vector<Template> templates) const;

    /// The library with this template in the place of the one with its id. Errc::UnknownTemplate
    /// where there is none, Errc::BadTemplate.
    Result<TemplateLibrary> withReplaced(Template tmpl) const;
    /// The library without a template; itself where it has none of this id.
    TemplateLibrary without(std::string_view id) const;
    /// Is it the same library, or a copy of it?
    bool sharesDataWith(const TemplateLibrary& other) const { return index_ == other.index_; }

    std::size_t size() const;
    const Template& at(std::size_t i) const;
    /// Index of a template, -1 where there is none.
    int find(std::string_view id) const;

    const LibraryIndex& index() const { return *index_; }

  private:
    std::shared_ptr<const LibraryIndex> index_;
};

/// What was read from a folder of templates, and what was refused.
struct LibraryLoad {
    TemplateLibrary library;
    std::vector<Error> problems;  ///< one a refused file; the others are loaded all the same
};

/// Loads every *.json of a folder in name order. Errc::FileNotFound where there is no folder.
Result<LibraryLoad> loadLibrary(const std::string& folder);

}  // namespace ew
