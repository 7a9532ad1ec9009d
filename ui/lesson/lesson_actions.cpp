// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lesson/lesson_actions.h"

#include <QDir>
#include <QFileDialog>
#include <QLocale>
#include <QMenu>
#include <algorithm>
#include <vector>

#include "core/document/resources.h"
#include "ui/lesson/lesson_guide.h"
#include "ui/panels/message_bar.h"

namespace ew {

namespace {

struct Listed {
    QString path;
    Lesson lesson;
};

/// The shipped lessons, the shorter ones first.
std::vector<Listed> shippedLessons() {
    std::vector<Listed> out;
    const auto resources = resourcesFolder();
    if (!resources) return out;
    const QDir folder(*resources + QStringLiteral("/lessons"));
    for (const QString& name : folder.entryList(QDir::Dirs | QDir::NoDotAndDotDot, QDir::Name)) {
        auto lesson = readLesson(folder.filePath(name));
        if (lesson) out.push_back({folder.filePath(name), *std::move(lesson)});
    }
    std::stable_sort(out.begin(), out.end(), [](const Listed& a, const Listed& b) {
        return a.lesson.minutes < b.lesson.minutes;
    });
    return out;
}

bool wasFinished(const Lesson& lesson) {
    const std::vector<int> stars = rememberedStars(lesson.id);
    return stars.size() == lesson.steps.size() &&
           std::all_of(stars.begin(), stars.end(), [](int s) { return s > 0; });
}

}  // namespace

LessonActions::LessonActions(const WindowContext& context, LessonGuide& guide,
                             std::function<bool()> mayDiscard, QWidget* window)
    : QObject(window),
      context_(context),
      guide_(guide),
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
    for (const Listed& listed : shippedLessons()) {
        const QString title =
            QString::fromStdString(textIn(listed.lesson.title, QLocale().name().toStdString()));
        QAction* action = menu->addAction(tr("%1 (%2 min)").arg(title).arg(listed.lesson.minutes),
                                          this, [this, path = listed.path] { begin(path); });
        action->setCheckable(true);
        action->setChecked(wasFinished(listed.lesson));
    }
    menu->addSeparator();
    menu->addAction(tr("&Open a lesson…"), this, &LessonActions::choose);
}

void LessonActions::choose() {
    const QString path = QFileDialog::getOpenFileName(
        window_, tr("Open a lesson"), {},
        tr("Lessons (%1)").arg(QStringLiteral("*.edgewright-lesson lesson.json")));
    if (!path.isEmpty()) begin(path);
}

bool LessonActions::begin(const QString& path) {
    if (!mayDiscard_()) return false;
    const auto begun = guide_.start(path);
    if (!begun) context_.messages.showError(begun.error());
    return begun.has_value();
}

}  // namespace ew
