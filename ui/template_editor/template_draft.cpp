// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/template_editor/template_draft.h"

#include <algorithm>

namespace ew {

namespace {

bool isParallel(const PolyhedronSpec& shape, const TemplateEdge& a, const TemplateEdge& b) {
    return relationHolds(shape, {RelationKind::Parallel, {a, b}}) ||
           relationHolds(shape, {RelationKind::Parallel, {a, {b[1], b[0]}}});
}

/// Is it the right angle between the same two directions?
bool sameAngle(const PolyhedronSpec& shape, const FoundRelation& a, const FoundRelation& b) {
    if (a.kind != RelationKind::Perpendicular || b.kind != a.kind) return false;
    return (isParallel(shape, a.edges[0], b.edges[0]) &&
            isParallel(shape, a.edges[1], b.edges[1])) ||
           (isParallel(shape, a.edges[0], b.edges[1]) && isParallel(shape, a.edges[1], b.edges[0]));
}

}  // namespace

std::vector<DraftRule> rulesFor(const PolyhedronSpec& shape, const std::vector<DraftRule>& before) {
    std::vector<DraftRule> rules;
    for (const DraftRule& rule : before) {
        if (rule.on) rules.push_back(rule);
    }
    const std::size_t kept = rules.size();
    for (FoundRelation& found : findRelations(shape)) {
        const bool known = std::any_of(
            rules.begin(), rules.begin() + static_cast<std::ptrdiff_t>(kept),
            [&](const DraftRule& rule) {
                return sameRelation(rule.relation, found) || sameAngle(shape, rule.relation, found);
            });
        if (!known) rules.push_back({std::move(found), false});
    }
    std::stable_sort(rules.begin(), rules.end(), [](const DraftRule& a, const DraftRule& b) {
        return a.relation.kind < b.relation.kind;
    });
    return rules;
}

TemplateDraft draftOf(Template tmpl) {
    std::vector<DraftRule> own;
    for (FoundRelation& relation : listRelations(tmpl.relations)) {
        own.push_back({std::move(relation), true});
    }
    TemplateDraft draft;
    draft.rules = rulesFor(tmpl.shape, own);
    draft.tmpl = std::move(tmpl);
    draft.tmpl.relations = {};
    return draft;
}

Template templateOf(const TemplateDraft& draft) {
    Template out = draft.tmpl;
    out.relations = {};
    for (const DraftRule& rule : draft.rules) {
        if (rule.on) addRelation(out.relations, rule.relation);
    }
    return out;
}

}  // namespace ew
