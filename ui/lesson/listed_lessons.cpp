// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lesson/listed_lessons.h"

#include <QDir>
#include <QLocale>
#include <algorithm>
#include <numeric>
#include <tuple>

#include "core/document/classroom/pupil_progress.h"
#include "core/document/lesson/lesson.h"
#include "core/document/resources.h"
#include "ui/lesson/lesson_guide.h"

namespace ew {

std::vector<ListedLesson> listedLessons() {
    std::vector<ListedLesson> out;
    const auto resources = resourcesFolder();
    if (!resources) return out;
    const std::string language = QLocale().name().toStdString();
    const QDir folder(*resources + QStringLiteral("/lessons"));
    for (const QString& name : folder.entryList(QDir::Dirs | QDir::NoDotAndDotDot, QDir::Name)) {
        auto lesson = readLesson(folder.filePath(name));
        if (!lesson) continue;
        const std::vector<int> stars = rememberedStars(lesson->id);
        ListedLesson listed;
        listed.path = folder.filePath(name);
        listed.title = QString::fromStdString(textIn(lesson->title, language));
        listed.summary = QString::fromStdString(textIn(lesson->summary, language));
        listed.minutes = lesson->minutes;
        listed.stars = std::accumulate(stars.begin(), stars.end(), 0);
        listed.mostStars = kMostStars * static_cast<int>(lesson->steps.size());
        listed.picture = std::move(lesson->picture);
        out.push_back(std::move(listed));
    }
    std::stable_sort(out.begin(), out.end(), [](const ListedLesson& a, const ListedLesson& b) {
        return std::tie(a.minutes, a.mostStars) < std::tie(b.minutes, b.mostStars);
    });
    return out;
}

}  // namespace ew
