// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QUndoStack>
#include <functional>

#include "ui/template_editor/template_draft.h"

namespace ew {

/// What changed in a draft.
struct DraftChange {
    bool words = false;  ///< id, name, what is said about it
    bool shape = false;
    bool rules = false;
    bool trial = false;
};

/// The draft of a template editor and everything that a person can do to it, each a step that can
/// be undone. Knows no widgets.
class TemplateModel : public QObject {
    Q_OBJECT

  public:
    explicit TemplateModel(TemplateDraft draft, QObject* parent = nullptr);

    const TemplateDraft& draft() const { return draft_; }
    QUndoStack& undoStack() { return stack_; }
    /// Would closing lose anything? What was drawn to try it does not count.
    bool isChanged() const;

    /// Changes words. Steps of one field that follow each other are one step.
    /// \param field  names the field; steps of no field (-1) stay apart.
    void setWords(int field, const QString& step, const std::function<void(Template&)>& change);
    void setRule(int rule, bool on);
    void moveVertex(int vertex, const Vec3& to);
    /// Another shape with its relations and its named readings; words stay.
    void takeShape(Template from);
    void addTrial(Stroke stroke);
    /// Takes away the stroke that is nearest to a place, within reach [px].
    void eraseTrial(const Vec2& at, double reachPx);
    void clearTrial();

  signals:
    void changed(ew::DraftChange what);

  private:
    class Step;
    void push(const QString& name, TemplateDraft after, int field = -1);
    void set(const TemplateDraft& draft);

    TemplateDraft draft_;
    std::string atFirst_;  ///< as text
    QUndoStack stack_;
};

}  // namespace ew
