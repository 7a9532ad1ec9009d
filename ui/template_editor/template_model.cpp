// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/template_editor/template_model.h"

#include <QUndoCommand>
#include <algorithm>
#include <limits>

#include "core/tlib/template_io.h"

namespace ew {

namespace {

bool sameShape(const PolyhedronSpec& a, const PolyhedronSpec& b) {
    return a.vertices == b.vertices && a.faces == b.faces;
}

bool sameRules(const std::vector<DraftRule>& a, const std::vector<DraftRule>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const auto& x, const auto& y) {
        return x.on == y.on && x.relation.kind == y.relation.kind &&
               x.relation.edges == y.relation.edges;
    });
}

bool sameTrial(const std::vector<Stroke>& a, const std::vector<Stroke>& b) {
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const auto& x, const auto& y) {
        return x.samples.size() == y.samples.size() &&
               x.samples.front().position == y.samples.front().position &&
               x.samples.back().position == y.samples.back().position;
    });
}

bool sameWords(const Template& a, const Template& b) {
    return a.id == b.id && a.name == b.name && a.description == b.description && a.about == b.about;
}

DraftChange difference(const TemplateDraft& a, const TemplateDraft& b) {
    return {!sameWords(a.tmpl, b.tmpl), !sameShape(a.tmpl.shape, b.tmpl.shape),
            !sameRules(a.rules, b.rules), !sameTrial(a.trial, b.trial)};
}

bool isNothing(const DraftChange& c) { return !c.words && !c.shape && !c.rules && !c.trial; }

}  // namespace

/// Undo and redo exchange whole drafts.
class TemplateModel::Step : public QUndoCommand {
  public:
    Step(TemplateModel& model, const QString& name, TemplateDraft after, int field)
        : QUndoCommand(name),
          model_(model),
          before_(model.draft_),
          after_(std::move(after)),
          field_(field) {}

    void undo() override { model_.set(before_); }
    void redo() override { model_.set(after_); }
    int id() const override { return field_; }
    bool mergeWith(const QUndoCommand* next) override {
        after_ = static_cast<const Step*>(next)->after_;
        setObsolete(isNothing(difference(before_, after_)));
        return true;
    }

  private:
    TemplateModel& model_;
    TemplateDraft before_;
    TemplateDraft after_;
    int field_;
};

TemplateModel::TemplateModel(TemplateDraft draft, QObject* parent)
    : QObject(parent), draft_(std::move(draft)), atFirst_(writeTemplate(templateOf(draft_))) {}

bool TemplateModel::isChanged() const { return writeTemplate(templateOf(draft_)) != atFirst_; }

void TemplateModel::push(const QString& name, TemplateDraft after, int field) {
    if (isNothing(difference(draft_, after))) return;
    stack_.push(new Step(*this, name, std::move(after), field));
}

void TemplateModel::set(const TemplateDraft& draft) {
    const DraftChange what = difference(draft_, draft);
    draft_ = draft;
    emit changed(what);
}

void TemplateModel::setWords(int field, const QString& step,
                             const std::function<void(Template&)>& change) {
    TemplateDraft after = draft_;
    change(after.tmpl);
    push(step, std::move(after), field);
}

void TemplateModel::setRule(int rule, bool on) {
    if (rule < 0 || static_cast<std::size_t>(rule) >= draft_.rules.size()) return;
    TemplateDraft after = draft_;
    after.rules[static_cast<std::size_t>(rule)].on = on;
    push(on ? tr("Set rule") : tr("Drop rule"), std::move(after));
}

void TemplateModel::moveVertex(int vertex, const Vec3& to) {
    TemplateDraft after = draft_;
    if (vertex < 0 || static_cast<std::size_t>(vertex) >= after.tmpl.shape.vertices.size()) return;
    after.tmpl.shape.vertices[static_cast<std::size_t>(vertex)] = to;
    after.rules = rulesFor(after.tmpl.shape, after.rules);
    push(tr("Move corner %1").arg(vertex), std::move(after));
}

void TemplateModel::takeShape(Template from) {
    TemplateDraft after = draftOf(std::move(from));
    after.trial = draft_.trial;
    Template& words = after.tmpl;
    const Template& before = draft_.tmpl;
    words.id = before.id;
    words.name = before.name;
    words.description = before.description;
    words.about = before.about;
    push(tr("Take another shape"), std::move(after));
}

void TemplateModel::addTrial(Stroke stroke) {
    TemplateDraft after = draft_;
    after.trial.push_back(std::move(stroke));
    push(tr("Draw"), std::move(after));
}

void TemplateModel::eraseTrial(const Vec2& at, double reachPx) {
    TemplateDraft after = draft_;
    const auto distance = [&](const Stroke& stroke) {
        double best = std::numeric_limits<double>::infinity();
        for (std::size_t i = 0; i < stroke.samples.size(); ++i) {
            const Vec2& a = stroke.samples[i].position;
            const Vec2& b = stroke.samples[std::min(i + 1, stroke.samples.size() - 1)].position;
            best = std::min(best, distanceToSegment(at, a, b));
        }
        return best;
    };
    const auto nearest = std::min_element(
        after.trial.begin(), after.trial.end(),
        [&](const Stroke& a, const Stroke& b) { return distance(a) < distance(b); });
    if (nearest == after.trial.end() || distance(*nearest) > reachPx) return;
    after.trial.erase(nearest);
    push(tr("Erase"), std::move(after));
}

void TemplateModel::clearTrial() {
    TemplateDraft after = draft_;
    after.trial.clear();
    push(tr("Clear drawing"), std::move(after));
}

}  // namespace ew
