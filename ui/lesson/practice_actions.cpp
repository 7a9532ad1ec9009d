// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lesson/practice_actions.h"

#include <QGuiApplication>
#include <QMenu>
#include <QSettings>
#include <algorithm>
#include <utility>

#include "core/document/practice/practice_task.h"
#include "ui/lesson/class_session.h"
#include "ui/lesson/lesson_guide.h"
#include "ui/lesson/practice_dialog.h"
#include "ui/panels/message_bar.h"

namespace ew {

namespace {
constexpr const char* kLevel = "practice/level";
}

PracticeActions::PracticeActions(const WindowContext& context, LessonGuide& guide,
                                 ClassSession& session, std::function<bool()> mayDiscard,
                                 QWidget* window)
    : QObject(window),
      context_(context),
      guide_(guide),
      session_(session),
      mayDiscard_(std::move(mayDiscard)),
      window_(window),
      log_(PracticeLog::standardPath()),
      level_(std::clamp(QSettings().value(kLevel, 1).toInt(), 1, kPracticeLevels)) {
    connect(&guide_, &LessonGuide::practiceDone, this, &PracticeActions::keep);
    connect(&guide_, &LessonGuide::anotherWanted, this, &PracticeActions::ask,
            Qt::QueuedConnection);
}

void PracticeActions::fill(QMenu* menu) {
    menu->addAction(tr("&Practice\u2026"), this, &PracticeActions::ask);
}

std::vector<PracticeResult> PracticeActions::results() const {
    if (session_.joined()) return session_.practice();
    return log_.list().value_or(std::vector<PracticeResult>());
}

void PracticeActions::ask() {
    PracticeDialog dialog(context_.appearance, results(), {level_, seed_}, window_);
    if (dialog.exec() != QDialog::Accepted) return;
    const auto [level, seed] = dialog.choice();
    begin(level, seed);
}

bool PracticeActions::begin(int level, std::uint32_t seed) {
    if (!mayDiscard_()) return false;
    QGuiApplication::setOverrideCursor(Qt::WaitCursor);
    auto task = practiceTask(level, seed, context_.document.stateAt(0)->library);
    QGuiApplication::restoreOverrideCursor();
    Result<void> begun;
    if (task)
        begun = guide_.startPractice(*std::move(task));
    else
        begun = fail(task.error());
    if (!begun) {
        context_.messages.showError(begun.error());
        return false;
    }
    level_ = level;
    seed_ = seed;
    QSettings().setValue(kLevel, level);
    return true;
}

void PracticeActions::keep() {
    const PracticeResult& result = *guide_.result();
    ++seed_;  // the next one that is offered
    if (session_.joined()) {
        session_.keepPractice(result);
        return;
    }
    if (auto ok = log_.add(result); !ok) context_.messages.showError(ok.error());
}

}  // namespace ew
