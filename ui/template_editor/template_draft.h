// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/stroke/stroke.h"
#include "core/tlib/found_relations.h"

namespace ew {

/// A relation of the shape that the person may make a rule.
struct DraftRule {
    FoundRelation relation;
    bool on = false;
};

/// A template while it is made: its relations are the rules that are on.
struct TemplateDraft {
    Template tmpl;  ///< without relations
    std::vector<DraftRule> rules;
    std::vector<Stroke> trial;  ///< what was drawn to try it [px of the canvas]
};

/// The template with its relations as rules that are on, and what else was found in its shape as
/// rules that are off. A right angle stands once for every two directions.
TemplateDraft draftOf(Template tmpl);

/// The template that the draft stands for.
Template templateOf(const TemplateDraft& draft);

/// The rules after the shape changed: those that are on stay, also where they are not true of it
/// any more; the others are what is found in it now.
std::vector<DraftRule> rulesFor(const PolyhedronSpec& shape, const std::vector<DraftRule>& before);

}  // namespace ew
