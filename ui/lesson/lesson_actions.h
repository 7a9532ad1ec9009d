// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <functional>
#include <string>

#include "ui/window_context.h"

class QMenu;

namespace ew {

class ClassActions;
class ClassSession;
class LessonGuide;
class PracticeActions;

/// The lessons that there are, and how one is begun and ended.
class LessonActions : public QObject {
    Q_OBJECT

  public:
    /// \param mayDiscard  asks about work that is not saved; false: nothing is to be done.
    LessonActions(const WindowContext& context, LessonGuide& guide, ClassSession& session,
                  ClassActions& classes, PracticeActions& practice,
                  std::function<bool()> mayDiscard, QWidget* window);

    /// A menu of its own with every lesson (those of the class, where a pupil works in one; else
    /// the shipped ones), a file to be chosen, exercises, and what there is to do in classes.
    void fill(QMenu* menu);
    /// Begins a lesson, after asking about work that is not saved; false where it does not.
    bool begin(const QString& path);

  private:
    void fillLessons(QMenu* menu);
    bool wasFinished(const std::string& lesson, std::size_t steps) const;
    void choose();

    WindowContext context_;
    LessonGuide& guide_;
    ClassSession& session_;
    ClassActions& classes_;
    PracticeActions& practice_;
    std::function<bool()> mayDiscard_;
    QWidget* window_;
};

}  // namespace ew
