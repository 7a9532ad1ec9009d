// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/actions/edit_actions.h"

#include <QAction>
#include <QActionGroup>
#include <QMenu>
#include <QUndoStack>

#include "ui/apply_controller.h"
#include "ui/body_selection.h"
#include "ui/panels/message_bar.h"
#include "ui/theme/themed_icon.h"
#include "ui/tools/tool_box.h"

namespace ew {

EditActions::EditActions(const WindowContext& context, QWidget* window)
    : QObject(window),
      undoAction(new QAction(themedIcon("undo"), tr("&Undo"), this)),
      redoAction(new QAction(themedIcon("redo"), tr("&Redo"), this)),
      clearAction(new QAction(themedIcon("clear"), tr("&Clear ink"), this)),
      deleteAction(new QAction(tr("&Delete solid"), this)),
      context_(context),
      window_(window) {
    undoAction->setShortcut(QKeySequence::Undo);
    redoAction->setShortcuts(
        {QKeySequence(QStringLiteral("Ctrl+Shift+Z")), QKeySequence(QStringLiteral("Ctrl+Y"))});
    clearAction->setShortcut(QKeySequence(QStringLiteral("Ctrl+Backspace")));
    clearAction->setToolTip(tr("Drop all strokes that are no solid yet"));
    deleteAction->setShortcut(QKeySequence(QStringLiteral("Ctrl+Delete")));
    connect(undoAction, &QAction::triggered, this, &EditActions::undo);
    connect(redoAction, &QAction::triggered, this, &EditActions::redo);
    connect(clearAction, &QAction::triggered, this, [this] { context_.document.clearStrokes(); });
    connect(deleteAction, &QAction::triggered, this, &EditActions::deleteChosen);
    addTools();
    auto* escape = new QAction(tr("Cancel"), this);
    escape->setShortcut(Qt::Key_Escape);
    connect(escape, &QAction::triggered, this, &EditActions::cancel);
    window->addAction(escape);
    connect(&context_.document, &Document::changed, this, [this](DocumentChange what) {
        if (what == DocumentChange::Camera) return;
        refresh();
    });
    connect(&context_.tools, &ToolBox::gestureChanged, this, &EditActions::refresh);
    refresh();
}

void EditActions::addTools() {
    struct Entry {
        ToolBox::Kind kind;
        const char* icon;
        QString name;
        QKeySequence key;
        QString tip;
    };
    const Entry entries[] = {
        {ToolBox::Kind::Pen, "pen", tr("&Pen"), QKeySequence(QStringLiteral("P")),
         tr("Draw strokes")},
        {ToolBox::Kind::Eraser, "eraser", tr("&Eraser"), QKeySequence(QStringLiteral("E")),
         tr("Remove strokes; the eraser end of the pen does it too")},
        {ToolBox::Kind::Orbit, "orbit", tr("&Orbit"), QKeySequence(QStringLiteral("O")),
         tr("Turn the view; so do the right and the middle mouse button")},
        {ToolBox::Kind::Pan, "pan", tr("&Move view"), QKeySequence(QStringLiteral("M")),
         tr("Move the view; so do Space with the left button and Shift with the middle one")},
        {ToolBox::Kind::PickEdge, "pick-edge", tr("Pic&k edges"), QKeySequence(QStringLiteral("K")),
         tr("Choose edges for a fillet; Shift adds")},
        {ToolBox::Kind::SurfacePen, "surface-pen", tr("Draw on the &surface"),
         QKeySequence(QStringLiteral("B")), tr("Every stroke goes straight onto the surface")},
        {ToolBox::Kind::Pull, "pull", tr("Pu&ll faces"), QKeySequence(QStringLiteral("L")),
         tr("Drag a face out of the solid or into it, or type how far")},
    };
    auto* group = new QActionGroup(this);
    for (const Entry& entry : entries) {
        auto* action = new QAction(themedIcon(QLatin1String(entry.icon)), entry.name, group);
        action->setCheckable(true);
        action->setShortcut(entry.key);
        action->setToolTip(tr("%1 (%2)").arg(entry.tip, entry.key.toString()));
        action->setChecked(context_.tools.active() == entry.kind);
        connect(action, &QAction::triggered, this,
                [this, kind = entry.kind] { context_.tools.setActive(kind); });
        toolActions.append(action);
    }
    connect(&context_.tools, &ToolBox::activeChanged, this,
            [this](ToolBox::Kind kind) { toolActions[static_cast<int>(kind)]->setChecked(true); });
}

void EditActions::fill(QMenu* menu) {
    menu->addAction(undoAction);
    menu->addAction(redoAction);
    menu->addSeparator();
    menu->addActions(toolActions);
    menu->addSeparator();
    menu->addAction(clearAction);
    menu->addAction(deleteAction);
}

void EditActions::undo() {
    // What was done last comes off first: what is under way, then ink and steps in one line.
    if (context_.tools.takeGestureBack()) return;
    if (context_.document.undoInk()) return;
    if (auto done = context_.document.undo(); !done) {
        context_.messages.showError(done.error());
    }
}

void EditActions::redo() {
    if (context_.document.redoInk()) return;
    if (auto done = context_.document.redo(); !done) context_.messages.showError(done.error());
}

void EditActions::deleteChosen() {
    if (auto done = context_.bodies.remove(); !done) context_.messages.showError(done.error());
}

void EditActions::cancel() {
    if (context_.tools.cancelGesture()) return;
    context_.apply.hold();
}

void EditActions::refresh() {
    const Document& document = context_.document;
    const QUndoStack& stack = document.undoStack();
    const bool gesture = context_.tools.gestureUnderWay();
    const bool ink = gesture || document.canUndoInk();
    const bool inkAgain = document.canRedoInk();
    undoAction->setEnabled(ink || stack.canUndo());
    redoAction->setEnabled(inkAgain || stack.canRedo());
    undoAction->setText(ink               ? tr("&Undo stroke")
                        : stack.canUndo() ? tr("&Undo %1").arg(stack.undoText())
                                          : tr("&Undo"));
    redoAction->setText(inkAgain          ? tr("&Redo stroke")
                        : stack.canRedo() ? tr("&Redo %1").arg(stack.redoText())
                                          : tr("&Redo"));
    clearAction->setEnabled(!document.pendingStrokes().empty());
    deleteAction->setEnabled(!document.state().bodies.empty());
}

}  // namespace ew
