// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDockWidget>
#include <functional>

#include "ui/window_context.h"

class QMainWindow;
class QMenu;

namespace ew {

class LessonActions;
class LessonGuide;

/// The place of a lesson in a window: its panel, which is there while one runs and in no list of
/// panels, and its menu.
class LessonDock : public QDockWidget {
    Q_OBJECT

  public:
    /// \param mayDiscard  asks about work that is not saved; false: nothing is to be done.
    LessonDock(const WindowContext& context, std::function<bool()> mayDiscard, QMainWindow* window);

    LessonGuide& guide() { return *guide_; }
    void fill(QMenu* menu);
    /// Begins a lesson, after asking about work that is not saved; false where it does not.
    bool begin(const QString& path);

  private:
    void refresh();

    LessonGuide* guide_;
    LessonActions* actions_;
};

}  // namespace ew
