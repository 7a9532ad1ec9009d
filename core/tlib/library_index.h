// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <mutex>
#include <set>
#include <string>
#include <unordered_map>
#include <vector>

#include "core/edge_graph/canonical.h"
#include "core/tlib/aspects.h"
#include "core/tlib/template.h"

namespace ew {

/// A template with what was derived from it.
struct LibraryEntry {
    Template tmpl;
    TemplateAnalysis analysis;
    std::vector<std::vector<int>> symmetries;  ///< vertex permutations, identity first
    std::vector<Aspect> aspects;               ///< one of each class that symmetries unite
};

struct AspectRef {
    int entry = -1;
    int aspect = -1;
    int removedEdge = -1;  ///< graph edge left out, -1 for the whole aspect
};

struct LazyIndex;

struct LibraryIndex {
    std::vector<std::shared_ptr<const LibraryEntry>> entries;
    std::unordered_map<std::string, int> byId;
    std::unordered_map<std::string, std::vector<AspectRef>> byCode;       ///< canonical code
    std::unordered_map<std::size_t, std::vector<AspectRef>> bySignature;  ///< aspects less one edge
    std::shared_ptr<LazyIndex> onSolid;                                   ///< see onSolidIndex
};

/// Made when it is first asked for.
struct LazyIndex {
    std::once_flag once;
    LibraryIndex index;
};

/// The same templates with their implicit aspects in addition, for drawings on a solid. Derived
/// once, on first use. Thread-safe.
/// \paper{4.2.2}
const LibraryIndex& onSolidIndex(const LibraryIndex& index);

/// What follows from a checked template, with its explicit aspects.
std::shared_ptr<const LibraryEntry> makeEntry(Template tmpl);

/// Adds what makeEntry() gave.
void addEntry(LibraryIndex& index, std::shared_ptr<const LibraryEntry> entry);

/// The entry with its implicit aspects in addition and without those seen edge-on, as
/// onSolidIndex() has it.
std::shared_ptr<const LibraryEntry> entryOnSolid(const LibraryEntry& entry);

/// What an aspect shows in terms of template vertices, mapped by a symmetry: equal where the two
/// are one to somebody who looks. Sets of {vertex, vertex, edge}, -1 for the end of a T.
using ShownEdges = std::set<std::array<int, 3>>;
ShownEdges shownEdges(const Aspect& aspect, const TemplateAnalysis& analysis,
                      const std::vector<int>& symmetry);

/// The aspect without one of its edges: what is left dangling by that is removed too, and a T
/// junction that lost its stem is dissolved. Empty graph where nothing closed is left.
Aspect withoutEdge(const Aspect& aspect, int edge);

}  // namespace ew
