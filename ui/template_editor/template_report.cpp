// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/template_editor/template_report.h"

#include <QCoreApplication>
#include <algorithm>

#include "core/document/template_id.h"
#include "core/tlib/freedom.h"
#include "core/tlib/template_io.h"
#include "ui/core_text.h"

namespace ew {

namespace {

struct Report {
    Q_DECLARE_TR_FUNCTIONS(TemplateReport)
};

using Place = DraftFault::Place;
using Mend = DraftFault::Mend;

DraftFault fault(Place place, const QString& text) {
    DraftFault out;
    out.place = place;
    out.text = text;
    return out;
}

/// "/faces/3/1" -> 3; -1 for another place.
int numberAfter(const QString& path, const QString& list) {
    if (!path.startsWith(list)) return -1;
    bool whole = false;
    const int number = path.section('/', 2, 2).toInt(&whole);
    return whole ? number : -1;
}

/// What checkTemplate() said, with a place that people know in place of that in a file.
QString sentenceOf(const Error& error, const PolyhedronSpec& shape) {
    // "source: /path: sentence"
    const QString text = QString::fromStdString(error.message);
    const QString path = text.section(QStringLiteral(": "), 1, 1);
    const QString said = coreText(text.section(QStringLiteral(": "), 2).toStdString());
    const int corner = numberAfter(path, QStringLiteral("/vertices/"));
    if (corner >= 0) return Report::tr("Corner %1: %2").arg(QString::number(corner), said);
    const int face = numberAfter(path, QStringLiteral("/faces/"));
    if (face < 0 || static_cast<std::size_t>(face) >= shape.faces.size()) return said;
    QStringList corners;
    for (const int v : shape.faces[static_cast<std::size_t>(face)]) corners << QString::number(v);
    return Report::tr("Face %1: %2").arg(corners.join(QStringLiteral("\u2013")), said);
}

void checkNames(const TemplateDraft& draft, const TemplateLibrary& others,
                std::vector<DraftFault>& out) {
    const Template& t = draft.tmpl;
    if (t.name.empty()) {
        out.push_back(fault(Place::Name, Report::tr("The template needs a name.")));
    }
    const auto taken = [&](const std::string& id) { return others.find(id) >= 0; };
    const bool isTaken = !t.id.empty() && taken(t.id);
    if (!t.id.empty() && !isTaken) return;
    if (t.id.empty() && t.name.empty()) return;
    DraftFault bad = fault(
        Place::Id, isTaken ? Report::tr("Another template has the id \u201c%1\u201d.")
                                 .arg(QString::fromStdString(t.id))
                           : Report::tr("The template needs an id, which names it in files."));
    bad.mend = Mend::UseId;
    bad.id = freeId(isTaken ? t.id : idFromName(t.name), taken);
    bad.mendText = Report::tr("Use \u201c%1\u201d").arg(QString::fromStdString(bad.id));
    out.push_back(std::move(bad));
}

void checkRules(const TemplateDraft& draft, std::vector<DraftFault>& out) {
    for (std::size_t i = 0; i < draft.rules.size(); ++i) {
        const DraftRule& rule = draft.rules[i];
        if (!rule.on || relationHolds(draft.tmpl.shape, rule.relation)) continue;
        const QString edges = edgesText(rule.relation.edges);
        QString text;
        switch (rule.relation.kind) {
            case RelationKind::Parallel:
                text = Report::tr("The edges %1 of this shape are not parallel.").arg(edges);
                break;
            case RelationKind::Perpendicular:
                text = Report::tr("The edges %1 of this shape are at no right angle.").arg(edges);
                break;
            case RelationKind::EqualLength:
                text = Report::tr("The edges %1 of this shape are not equally long.").arg(edges);
                break;
        }
        DraftFault bad = fault(Place::Rule, text);
        bad.rule = static_cast<int>(i);
        bad.mend = Mend::DropRule;
        bad.mendText = Report::tr("Drop the rule");
        out.push_back(std::move(bad));
    }
}

/// What checkTemplate() finds besides: the shape alone first, so that a rule is not blamed for it.
void checkRest(const TemplateDraft& draft, std::vector<DraftFault>& out) {
    Template plain = draft.tmpl;
    plain.id = "t";
    plain.name = "t";
    plain.description = {};
    plain.about = {};
    plain.readings = {};
    if (const auto ok = checkTemplate(plain, "t"); !ok) {
        out.push_back(fault(Place::Shape, sentenceOf(ok.error(), draft.tmpl.shape)));
        return;
    }
    if (!out.empty()) return;
    if (const auto ok = checkTemplate(templateOf(draft), "t"); !ok) {
        out.push_back(fault(Place::Words, sentenceOf(ok.error(), draft.tmpl.shape)));
    }
}

void countFreedoms(const TemplateDraft& draft, DraftReport& report) {
    std::vector<FoundRelation> on;
    for (const DraftRule& rule : draft.rules) {
        if (rule.on) on.push_back(rule.relation);
    }
    const TemplateFreedom freedom = countFreedom(draft.tmpl.shape, on);
    report.openFreedoms = freedom.open;
    std::size_t next = 0;
    for (std::size_t i = 0; i < draft.rules.size(); ++i) {
        if (draft.rules[i].on) report.follows[i] = freedom.follows[next++];
    }
}

}  // namespace

bool DraftReport::usable() const {
    return openFreedoms >= 0 && std::none_of(faults.begin(), faults.end(), [](const auto& f) {
               return f.weight == DraftFault::Weight::Error;
           });
}

Template readableDraft(const TemplateDraft& draft, const TemplateLibrary& others) {
    Template tmpl = templateOf(draft);
    if (tmpl.name.empty()) tmpl.name = Report::tr("This template").toStdString();
    const auto taken = [&](const std::string& id) { return others.find(id) >= 0; };
    if (tmpl.id.empty() || taken(tmpl.id)) tmpl.id = freeId("draft", taken);
    return tmpl;
}

QString edgesText(const std::vector<TemplateEdge>& edges) {
    QStringList words;
    for (const TemplateEdge& e : edges) {
        words << QStringLiteral("%1\u2013%2").arg(e[0]).arg(e[1]);
    }
    return words.join(QStringLiteral(", "));
}

DraftReport checkDraft(const TemplateDraft& draft, const TemplateLibrary& others) {
    DraftReport report;
    report.follows.assign(draft.rules.size(), false);
    checkNames(draft, others, report.faults);
    checkRules(draft, report.faults);
    checkRest(draft, report.faults);
    const bool sound = std::none_of(
        report.faults.begin(), report.faults.end(),
        [](const DraftFault& f) { return f.place == Place::Shape || f.place == Place::Rule; });
    if (sound) countFreedoms(draft, report);
    return report;
}

AspectReport lookAtAspects(const TemplateDraft& draft, const TemplateLibrary& others) {
    AspectReport report;
    const auto entry = makeEntry(templateOf(draft));
    report.aspects = aspectFacts(*entry, others, true);
    const std::string same = sameTemplate(*entry, others);
    if (!same.empty()) {
        const auto index = static_cast<std::size_t>(others.find(same));
        DraftFault bad = fault(
            Place::Shape, Report::tr("\u201c%1\u201d has the same shape and the same rules: no "
                                     "drawing can tell the two apart.")
                              .arg(coreText(others.at(index).name)));
        bad.weight = DraftFault::Weight::Warning;
        report.faults.push_back(std::move(bad));
    }
    const bool readable =
        std::any_of(report.aspects.begin(), report.aspects.end(),
                    [](const AspectFacts& f) { return f.aspect.kind == AspectKind::Explicit; });
    if (!readable) {
        DraftFault bad =
            fault(Place::Shape, Report::tr("From no side it can be seen well enough to be drawn."));
        bad.weight = DraftFault::Weight::Warning;
        report.faults.push_back(std::move(bad));
    }
    return report;
}

}  // namespace ew
