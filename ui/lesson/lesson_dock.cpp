// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lesson/lesson_dock.h"

#include <QMainWindow>

#include "ui/actions/file_actions.h"
#include "ui/lesson/class_actions.h"
#include "ui/lesson/class_session.h"
#include "ui/lesson/lesson_actions.h"
#include "ui/lesson/lesson_guide.h"
#include "ui/lesson/lesson_panel.h"
#include "ui/lesson/practice_actions.h"

namespace ew {

LessonDock::LessonDock(const WindowContext& context, FileActions& files, QMainWindow* window)
    : QDockWidget(tr("Lesson"), window),
      guide_(new LessonGuide(context, this)),
      session_(new ClassSession(context, *guide_, ClassSession::standardShelf(), this)),
      classes_(new ClassActions(context, *session_, files, window)),
      practice_(new PracticeActions(
          context, *guide_, *session_, [&files] { return files.mayDiscard(); }, window)),
      actions_(new LessonActions(
          context, *guide_, *session_, *classes_, *practice_,
          [&files] { return files.mayDiscard(); }, window)) {
    setObjectName(QStringLiteral("lessonDock"));
    setFeatures(QDockWidget::DockWidgetMovable | QDockWidget::DockWidgetFloatable);
    auto* panel = new LessonPanel(*guide_, *session_, context.appearance, this);
    setWidget(panel);
    connect(panel, &LessonPanel::endWanted, guide_, &LessonGuide::stop);
    connect(guide_, &LessonGuide::changed, this, &LessonDock::refresh);
    // A layout that was left while a lesson ran would bring an empty panel back.
    connect(this, &QDockWidget::visibilityChanged, this, &LessonDock::refresh,
            Qt::QueuedConnection);
    window->addDockWidget(Qt::LeftDockWidgetArea, this);
    hide();
}

void LessonDock::fill(QMenu* menu) { actions_->fill(menu); }

bool LessonDock::begin(const QString& path) { return actions_->begin(path); }

void LessonDock::leaveClass() { session_->leave(); }

void LessonDock::refresh() {
    if (isHidden() == guide_->running()) setVisible(guide_->running());
}

}  // namespace ew
