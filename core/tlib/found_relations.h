// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/tlib/template.h"

namespace ew {

enum class RelationKind { Parallel, Perpendicular, EqualLength };

/// One entry of a template's relations: a class of edges, or a pair where they are perpendicular.
struct FoundRelation {
    RelationKind kind = RelationKind::Parallel;
    std::vector<TemplateEdge> edges;
};

/// What holds among the edges of a shape: every class of parallel edges (all named in one sense),
/// one pair for every two directions that meet in a vertex at a right angle, every class of equally
/// long edges; in this order. Within tol::kSolidDirection, lengths relative to the size. O(E^2).
/// \pre every face has two corners or more, and its indices are those of vertices.
std::vector<FoundRelation> findRelations(const PolyhedronSpec& shape);

/// The same with another tolerance: of a file with numbers of seven digits, say, up to
/// tol::kTemplateRelation.
std::vector<FoundRelation> findRelations(const PolyhedronSpec& shape, double tolerance);

/// Is it true of the shape, within tol::kTemplateRelation as checkTemplate() has it? False where an
/// edge has no length.
bool relationHolds(const PolyhedronSpec& shape, const FoundRelation& relation);

/// The entries of some relations, parallel ones first, as findRelations() orders them.
std::vector<FoundRelation> listRelations(const TemplateRelations& relations);

/// Adds an entry to its list. \pre a perpendicular one has two edges.
void addRelation(TemplateRelations& relations, const FoundRelation& relation);

/// Do two say the same, whatever the order of their edges and the sense in which they are named?
bool sameRelation(const FoundRelation& a, const FoundRelation& b);

}  // namespace ew
