// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/classroom/class_overview.h"

#include <QCollator>
#include <QDir>
#include <QFileInfo>
#include <algorithm>
#include <numeric>
#include <set>
#include <tuple>

#include "core/document/classroom/pupil_files.h"
#include "core/document/file_bytes.h"

namespace ew {
namespace {

/// What systems leave in any folder is no matter.
bool isLitter(const QString& name) {
    static const QStringList kLitter{QStringLiteral("thumbs.db"), QStringLiteral("desktop.ini"),
                                     QStringLiteral("system volume information"),
                                     QStringLiteral("$recycle.bin")};
    return name.startsWith('.') || kLitter.contains(name.toLower());
}

QStringList entriesOf(const QString& folder) {
    QStringList names = QDir(folder).entryList(QDir::AllEntries | QDir::NoDotAndDotDot, QDir::Name);
    names.removeIf([](const QString& name) { return isLitter(name); });
    return names;
}

Result<void> checkFolder(const QString& folder) {
    const QFileInfo info(folder);
    const std::string name = info.absoluteFilePath().toStdString();
    if (!info.isDir()) return fail(Errc::FileNotFound, "There is no class folder at " + name + ".");
    if (!info.isReadable() || !info.isExecutable()) {
        return fail(Errc::FileNotFound, "The class folder " + name + " may not be read.");
    }
    return {};
}

/// A pupil's folder, or what is wrong with it.
Result<ClassPupil> readPupil(const QString& folder) {
    if (!QFileInfo(folder).isDir()) {
        return fail(Errc::WrongFormat, "This is no pupil's folder; it was left as it is.");
    }
    const auto text = readFileBytes(folder + '/' + kProgressFile, kMaxProgressBytes);
    if (!text) return fail(text.error());
    auto progress = readProgress(*text);
    if (!progress) return fail(progress.error());
    ClassPupil pupil;
    pupil.folder = folder;
    pupil.progress = *std::move(progress);
    pupil.stuck = stuckPlace(pupil.progress);
    return pupil;
}

void addLesson(const QString& path, std::vector<ClassLesson>& out,
               std::vector<FileFault>& problems) {
    const auto lesson = readLesson(path);
    if (!lesson) {
        problems.push_back(fileFault(path.toStdString(), lesson.error()));
        return;
    }
    const bool known = std::any_of(out.begin(), out.end(),
                                   [&](const ClassLesson& l) { return l.id == lesson->id; });
    if (known) {
        problems.push_back(
            {path.toStdString(), "/id", "another lesson has this id, too", Errc::DuplicateId});
        return;
    }
    out.push_back({lesson->id, lesson->title, lesson->minutes, lesson->steps.size(), path});
}

/// Lessons that pupils worked at and that are not there any more.
void addMissingLessons(ClassOverview& overview) {
    std::set<std::string> known;
    for (const ClassLesson& lesson : overview.lessons) known.insert(lesson.id);
    for (const ClassPupil& pupil : overview.pupils) {
        for (const auto& [id, progress] : pupil.progress.lessons) {
            if (!known.insert(id).second) continue;
            overview.lessons.push_back({id, {{"en", id}}, 0, progress.steps.size(), {}});
        }
    }
}

void sortByName(std::vector<ClassPupil>& pupils) {
    QCollator collator;
    collator.setNumericMode(true);
    std::stable_sort(pupils.begin(), pupils.end(), [&](const ClassPupil& a, const ClassPupil& b) {
        return collator.compare(QString::fromStdString(a.progress.name),
                                QString::fromStdString(b.progress.name)) < 0;
    });
}

template <class Count>
auto overLessons(const ClassPupil& pupil, const Count& count) {
    using Sum = decltype(count(LessonProgress{}));
    return std::accumulate(pupil.progress.lessons.begin(), pupil.progress.lessons.end(), Sum{},
                           [&](Sum sum, const auto& lesson) { return sum + count(lesson.second); });
}

}  // namespace

std::vector<ClassLesson> classLessons(const QString& classFolder, const QString& shippedLessons,
                                      std::vector<FileFault>& problems) {
    std::vector<ClassLesson> out;
    const QString own = classFolder + '/' + kClassLessons;
    const QStringList names = classFolder.isEmpty() ? QStringList() : entriesOf(own);
    for (const QString& name : names) addLesson(own + '/' + name, out, problems);
    if (names.isEmpty() && !shippedLessons.isEmpty()) {
        for (const QString& name : entriesOf(shippedLessons)) {
            addLesson(shippedLessons + '/' + name, out, problems);
        }
    }
    std::stable_sort(out.begin(), out.end(), [](const ClassLesson& a, const ClassLesson& b) {
        return std::tie(a.minutes, a.steps) < std::tie(b.minutes, b.steps);
    });
    return out;
}

int ClassPupil::done() const {
    return overLessons(*this, [](const LessonProgress& l) { return l.done(); });
}
int ClassPupil::stars() const {
    return overLessons(*this, [](const LessonProgress& l) { return l.stars(); });
}
double ClassPupil::seconds() const {
    return overLessons(*this, [](const LessonProgress& l) { return l.seconds(); });
}
ClassTime ClassPupil::last() const {
    ClassTime out = 0;
    for (const auto& [id, lesson] : progress.lessons) out = std::max(out, lesson.last);
    return out;
}

QString ClassPupil::document(const std::string& lesson) const {
    const QString path = folder + '/' + lessonDocument(lesson);
    return QFileInfo(path).isFile() ? path : QString();
}

int ClassOverview::steps() const {
    return std::accumulate(lessons.begin(), lessons.end(), 0, [](int sum, const ClassLesson& l) {
        return sum + static_cast<int>(l.steps);
    });
}

Result<ClassOverview> readClass(const QString& folder, const QString& shippedLessons) {
    if (auto ok = checkFolder(folder); !ok) return fail(ok.error());
    ClassOverview out;
    out.folder = QDir(folder).absolutePath();
    out.name = QDir(out.folder).dirName().toStdString();
    out.lessons = classLessons(out.folder, shippedLessons, out.problems);
    const QString work = out.folder + '/' + kClassWork;
    if (QFileInfo::exists(work)) {
        if (auto ok = checkFolder(work); !ok) return fail(ok.error());
    }
    for (const QString& name : entriesOf(work)) {
        const QString path = work + '/' + name;
        auto pupil = readPupil(path);
        if (pupil) {
            out.pupils.push_back(*std::move(pupil));
            continue;
        }
        const QString file = QFileInfo(path).isDir() ? path + '/' + kProgressFile : path;
        out.problems.push_back(fileFault(file.toStdString(), pupil.error()));
    }
    sortByName(out.pupils);
    addMissingLessons(out);
    return out;
}

Result<std::vector<QString>> pupilNames(const QString& folder) {
    if (auto ok = checkFolder(folder); !ok) return fail(ok.error());
    const QString work = QDir(folder).absolutePath() + '/' + kClassWork;
    std::vector<ClassPupil> pupils;
    for (const QString& name : entriesOf(work)) {
        auto pupil = readPupil(work + '/' + name);
        if (pupil) pupils.push_back(*std::move(pupil));
    }
    sortByName(pupils);
    std::vector<QString> out;
    for (const ClassPupil& pupil : pupils) {
        const QString name = QString::fromStdString(pupil.progress.name);
        if (out.empty() || out.back() != name) out.push_back(name);
    }
    return out;
}

}  // namespace ew
