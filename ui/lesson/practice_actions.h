// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <cstdint>
#include <functional>

#include "core/document/practice/practice_log.h"
#include "ui/window_context.h"

class QMenu;
class QWidget;

namespace ew {

class ClassSession;
class LessonGuide;

/// Exercises in the menus: one is chosen, led through as a lesson is, and what came of it kept, in
/// the class folder where a pupil works in one, else on this computer.
class PracticeActions : public QObject {
    Q_OBJECT

  public:
    /// \param mayDiscard  asks about work that is not saved; false: nothing is to be done.
    PracticeActions(const WindowContext& context, LessonGuide& guide, ClassSession& session,
                    std::function<bool()> mayDiscard, QWidget* window);

    void fill(QMenu* menu);
    /// Begins an exercise, after asking about work that is not saved; false where it does not.
    bool begin(int level, std::uint32_t seed);

  private:
    void ask();
    void keep();
    std::vector<PracticeResult> results() const;

    WindowContext context_;
    LessonGuide& guide_;
    ClassSession& session_;
    std::function<bool()> mayDiscard_;
    QWidget* window_;
    PracticeLog log_;
    int level_ = 1;
    std::uint32_t seed_ = 1;
};

}  // namespace ew
