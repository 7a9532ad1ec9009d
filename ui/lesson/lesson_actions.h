// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <functional>

#include "ui/window_context.h"

class QMenu;

namespace ew {

class LessonGuide;

/// The lessons that there are, and how one is begun and ended.
class LessonActions : public QObject {
    Q_OBJECT

  public:
    /// \param mayDiscard  asks about work that is not saved; false: nothing is to be done.
    LessonActions(const WindowContext& context, LessonGuide& guide,
                  std::function<bool()> mayDiscard, QWidget* window);

    /// A menu of its own with every shipped lesson, and a file to be chosen.
    void fill(QMenu* menu);
    /// Begins a lesson, after asking about work that is not saved; false where it does not.
    bool begin(const QString& path);

  private:
    void fillLessons(QMenu* menu);
    void choose();

    WindowContext context_;
    LessonGuide& guide_;
    std::function<bool()> mayDiscard_;
    QWidget* window_;
};

}  // namespace ew
