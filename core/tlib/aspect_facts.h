// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "core/tlib/library.h"
#include "core/tlib/library_index.h"

namespace ew {

/// An aspect of a template, and what its author wants to know of it.
struct AspectFacts {
    Aspect aspect;
    /// Share of all directions from which the reference shape shows it, 0..1; of a mouth that all
    /// its faces look at the eye. Not set where proportions settle that: of cavities, and of views
    /// with a face seen as a line.
    std::optional<double> share;
    std::vector<std::string> alsoShownBy;  ///< ids of other templates with an aspect of this graph
};

/// The aspects of a template, explicit ones first, each group by falling share.
/// \param entry     of makeEntry().
/// \param others    compared with; a template of the same id is left out.
/// \param implicit  those of cuts too: some 10 ms more for each template that `others` has, once.
/// Cost: a few ms; with those of cuts up to 2 s at 24 edges.
std::vector<AspectFacts> aspectFacts(const LibraryEntry& entry, const TemplateLibrary& others,
                                     bool implicit);

/// The id of a template of the same shape with the same relations, whatever its vertices are called
/// and whatever its proportions; empty where there is none.
std::string sameTemplate(const LibraryEntry& entry, const TemplateLibrary& others);

}  // namespace ew
