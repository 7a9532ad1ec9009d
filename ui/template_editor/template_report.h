// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <vector>

#include "core/tlib/aspect_facts.h"
#include "core/tlib/library.h"
#include "ui/template_editor/template_draft.h"

namespace ew {

/// Something that is wrong with a draft, or worth knowing.
struct DraftFault {
    enum class Weight {
        Error,    ///< the template cannot be used so
        Warning,  ///< it can, but hardly as it is meant
    };
    enum class Place { Name, Id, Words, Shape, Rule };
    enum class Mend { None, UseId, DropRule };
    Weight weight = Weight::Error;
    Place place = Place::Shape;
    int rule = -1;  ///< Place::Rule: which one
    QString text;   ///< a sentence in the window's language
    Mend mend = Mend::None;
    QString mendText;  ///< for a button
    std::string id;    ///< Mend::UseId
};

/// What is told of a draft at once.
struct DraftReport {
    std::vector<DraftFault> faults;  ///< errors first
    std::vector<bool> follows;       ///< per rule: it is on and says nothing new
    int openFreedoms = -1;  ///< besides place, attitude and size; -1 where shape or rules are bad
    bool usable() const;    ///< checked, with no error
};

/// Names, shape, rules and freedoms: 10 ms at 64 vertices.
/// \param others  the templates in use, without the one that is edited.
DraftReport checkDraft(const TemplateDraft& draft, const TemplateLibrary& others);

/// What its views tell of a draft.
struct AspectReport {
    std::vector<AspectFacts> aspects;  ///< as aspectFacts() has them, with those of cuts
    std::vector<DraftFault> faults;
};

/// Views and rivals: 30 ms for a box, up to 2 s at 24 edges.
/// \pre checkDraft() counted its freedoms.
AspectReport lookAtAspects(const TemplateDraft& draft, const TemplateLibrary& others);

/// The template that is read when a draft is tried, which may be before it has a name or an id of
/// its own.
Template readableDraft(const TemplateDraft& draft, const TemplateLibrary& others);

/// Edges of a rule for people: "0\u20133, 1\u20134".
QString edgesText(const std::vector<TemplateEdge>& edges);

}  // namespace ew
