// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lesson/lesson_actions.h"

#include <QFileDialog>
#include <QLocale>
#include <QMenu>
#include <algorithm>
#include <vector>

#include "core/document/classroom/class_overview.h"
#include "core/document/resources.h"
#include "ui/lesson/class_actions.h"
#include "ui/lesson/class_session.h"
#include "ui/lesson/lesson_guide.h"
#include "ui/lesson/practice_actions.h"
#include "ui/panels/message_bar.h"

namespace ew {

LessonActions::LessonActions(const WindowContext& context, LessonGuide& guide,
                             ClassSession& session, ClassActions& classes,
                             PracticeActions& practice, std::function<bool()> mayDiscard,
                             QWidget* window)
    : QObject(window),
      context_(context),
      guide_(guide),
      session_(session),
      classes_(classes),
      practice_(practice),
      mayDiscard_(std::move(mayDiscard)),
      window_(window) {
    connect(&guide_, &LessonGuide::failed, &context_.messages, &MessageBar::showError);
}

void LessonActions::fill(QMenu* menu) {
    auto* lessons = menu->addMenu(tr("&Lessons"));
    // Read when somebody looks: the start of the program does not wait for them.
    connect(lessons, &QMenu::aboutToShow, this, [this, lessons] { fillLessons(lessons); });
}

void LessonActions::fillLessons(QMenu* menu) {
    menu->clear();
    const auto resources = resourcesFolder();
    std::vector<FileFault> problems;
    const std::vector<ClassLesson> lessons =
        classLessons(session_.classFolder(),
                     resources ? *resources + QStringLiteral("/lessons") : QString(), problems);
    for (const ClassLesson& lesson : lessons) {
        QString title =
            QString::fromStdString(textIn(lesson.title, QLocale().name().toStdString()));
        title.replace('&', QStringLiteral("&&"));
        QAction* action = menu->addAction(tr("%1 (%2 min)").arg(title).arg(lesson.minutes), this,
                                          [this, path = lesson.path] { begin(path); });
        action->setCheckable(true);
        action->setChecked(wasFinished(lesson.id, lesson.steps));
    }
    menu->addSeparator();
    menu->addAction(tr("&Open a lesson…"), this, &LessonActions::choose);
    practice_.fill(menu);
    menu->addSeparator();
    classes_.fill(menu);
}

bool LessonActions::wasFinished(const std::string& lesson, std::size_t steps) const {
    if (session_.joined()) {
        const LessonProgress* progress = session_.progress(lesson);
        return progress != nullptr && progress->finished();
    }
    const std::vector<int> stars = rememberedStars(lesson);
    return stars.size() == steps &&
           std::all_of(stars.begin(), stars.end(), [](int s) { return s > 0; });
}

void LessonActions::choose() {
    const QString path = QFileDialog::getOpenFileName(
        window_, tr("Open a lesson"), {},
        tr("Lessons (%1)").arg(QStringLiteral("*.edgewright-lesson lesson.json")));
    if (!path.isEmpty()) begin(path);
}

bool LessonActions::begin(const QString& path) {
    if (!mayDiscard_()) return false;
    const auto begun =
        guide_.start(path, [this](const Lesson& lesson) { return session_.stepOf(lesson); });
    if (!begun) context_.messages.showError(begun.error());
    return begun.has_value();
}

}  // namespace ew
