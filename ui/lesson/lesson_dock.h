// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDockWidget>

#include "ui/window_context.h"

class QMainWindow;
class QMenu;

namespace ew {

class ClassActions;
class ClassSession;
class FileActions;
class LessonActions;
class LessonGuide;
class PracticeActions;

/// The place of a lesson in a window: its panel, which is there while one runs and in no list of
/// panels, and its menu.
class LessonDock : public QDockWidget {
    Q_OBJECT

  public:
    /// \param files  asks about work that is not saved before a lesson takes its place.
    LessonDock(const WindowContext& context, FileActions& files, QMainWindow* window);

    LessonGuide& guide() { return *guide_; }
    ClassSession& session() { return *session_; }
    ClassActions& classes() { return *classes_; }
    PracticeActions& practice() { return *practice_; }
    void fill(QMenu* menu);
    /// Begins a lesson, after asking about work that is not saved; false where it does not.
    bool begin(const QString& path);
    /// Keeps what a pupil did, while there is a document.
    void leaveClass();

  private:
    void refresh();

    LessonGuide* guide_;
    ClassSession* session_;
    ClassActions* classes_;
    PracticeActions* practice_;
    LessonActions* actions_;
};

}  // namespace ew
