// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/actions/sketch_actions.h"

#include <QAbstractSpinBox>
#include <QAction>
#include <QApplication>
#include <QKeyEvent>
#include <QMenu>
#include <algorithm>

#include "core/document/template_from_solid.h"
#include "core/document/template_id.h"
#include "core/tlib/family.h"
#include "ui/actions/mirror_actions.h"
#include "ui/apply_controller.h"
#include "ui/body_selection.h"
#include "ui/core_text.h"
#include "ui/live_reading.h"
#include "ui/panels/message_bar.h"
#include "ui/template_editor/template_editor.h"
#include "ui/theme/themed_icon.h"

namespace ew {

namespace {
constexpr int kFirstCorners = 6;
}

SketchActions::SketchActions(const WindowContext& context, QWidget* window)
    : QObject(window),
      applyAction(new QAction(themedIcon("apply"), tr("&Apply"), this)),
      automaticAction(
          new QAction(themedIcon("automatic"), tr("Apply by &itself when clear"), this)),
      levelAction(new QAction(tr("Set new solids &level"), this)),
      context_(context),
      window_(window),
      templateAction_(new QAction(themedIcon("add-template"), tr("&Template editor\u2026"), this)) {
    window->installEventFilter(this);
    applyAction->setShortcuts({QKeySequence(Qt::Key_Return), QKeySequence(Qt::Key_Enter)});
    applyAction->setToolTip(tr("Make a solid of the drawing (Enter)"));
    automaticAction->setCheckable(true);
    automaticAction->setChecked(context_.apply.automatic());
    automaticAction->setShortcut(QKeySequence(QStringLiteral("A")));
    automaticAction->setToolTip(
        tr("Make a solid without asking when one reading is clearly the best (A)"));
    levelAction->setCheckable(true);
    levelAction->setChecked(context_.apply.level());
    levelAction->setToolTip(
        tr("A new solid that leans by no more than the angle threshold is turned upright and "
           "stands on the ground"));
    connect(levelAction, &QAction::toggled, &context_.apply, &ApplyController::setLevel);
    connect(applyAction, &QAction::triggered, &context_.apply, &ApplyController::apply);
    connect(automaticAction, &QAction::toggled, &context_.apply, &ApplyController::setAutomatic);
    connect(&context_.apply, &ApplyController::automaticChanged, automaticAction,
            &QAction::setChecked);
    connect(templateAction_, &QAction::triggered, this, [this] { editTemplate({}, true); });
    for (int i = 0; i < 9; ++i) {
        auto* action = new QAction(tr("Reading &%1").arg(i + 1), this);
        action->setShortcut(QKeySequence(QString::number(i + 1)));
        connect(action, &QAction::triggered, this, [this, i] { context_.apply.pick(i); });
        readingActions.append(action);
    }
    // Shortcuts work without their menu having been opened.
    window->addActions(readingActions);
    connect(&context_.apply, &ApplyController::changed, this, &SketchActions::refresh);
    connect(&context_.document, &Document::changed, this, [this](DocumentChange what) {
        if (what == DocumentChange::Bodies) refresh();
    });
    refresh();
}

/// Enter ends what is typed into a number; it is the key of Apply elsewhere.
bool SketchActions::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::ShortcutOverride &&
        qobject_cast<QAbstractSpinBox*>(QApplication::focusWidget()) != nullptr) {
        const int key = static_cast<QKeyEvent*>(event)->key();
        if (key == Qt::Key_Return || key == Qt::Key_Enter) {
            event->accept();
            return true;
        }
    }
    return QObject::eventFilter(watched, event);
}

void SketchActions::fill(QMenu* menu) {
    menu->addAction(applyAction);
    menu->addAction(automaticAction);
    menu->addAction(levelAction);
    (new MirrorActions(context_, window_))->fill(menu);
    menu->addSeparator();
    menu->addActions(readingActions);
    menu->addSeparator();
    menu->addAction(templateAction_);
}

void SketchActions::refresh() {
    const auto& candidates = context_.apply.shown().candidates;
    for (int i = 0; i < readingActions.size(); ++i) {
        const bool there = static_cast<std::size_t>(i) < candidates.size();
        QAction* action = readingActions[i];
        action->setVisible(there || i == 0);
        action->setEnabled(there);
        if (!there) {
            action->setText(tr("Reading &%1").arg(i + 1));
            continue;
        }
        const Candidate& c = candidates[static_cast<std::size_t>(i)];
        const QString name = coreText(c.templateName);
        const QString reading = coreText(c.readingName);
        action->setText(reading.isEmpty()
                            ? tr("Reading &%1: %2").arg(i + 1).arg(name)
                            : tr("Reading &%1: %2, %3").arg(i + 1).arg(name, reading));
    }
}

/// A solid that cannot be a template is no reason not to open: the editor offers other shapes.
Result<Template> SketchActions::templateToBegin() const {
    const auto& bodies = context_.document.state().bodies;
    if (bodies.empty()) return familyTemplate(Family::Prism, kFirstCorners);
    const std::vector<int>& chosen = context_.bodies.chosen();
    const auto body = static_cast<std::size_t>(chosen.empty() ? 0 : chosen.front());
    return templateFromBodies({bodies[body]}, {}, {});
}

void SketchActions::editTemplate(const QString& id, bool copy) {
    context_.messages.clearNotice();
    const DocumentState& state = context_.document.state();
    const int place = state.library.find(id.toStdString());
    const bool own = std::find(state.addedTemplates.begin(), state.addedTemplates.end(),
                               id.toStdString()) != state.addedTemplates.end();
    Result<Template> start =
        place >= 0 ? state.library.at(static_cast<std::size_t>(place)) : templateToBegin();
    if (!start) {
        context_.messages.showError(start.error());
        start = familyTemplate(Family::Prism, kFirstCorners);
    }
    const bool replaces = place >= 0 && own && !copy;
    if (place < 0) {
        start->id = {};
        start->name = {};
    } else if (!replaces) {
        const auto taken = [&](const std::string& wanted) {
            return state.library.find(wanted) >= 0;
        };
        start->name = tr("Copy of %1").arg(coreText(start->name)).toStdString();
        start->id = freeId(idFromName(start->name), taken);
    }
    auto* editor = new TemplateEditor(context_.document, context_.appearance, *std::move(start),
                                      replaces, window_);
    editor->setAttribute(Qt::WA_DeleteOnClose);
    editor->setWindowModality(Qt::WindowModal);
    connect(editor, &TemplateEditor::saved, this, [this](const QString& name) {
        context_.messages.showNotice(tr("%1 can be drawn from now on.").arg(name));
    });
    editor->show();
}

}  // namespace ew
