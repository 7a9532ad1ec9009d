// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/classroom/pupil_files.h"

#include <QCryptographicHash>
#include <QDir>
#include <QFileInfo>
#include <QRandomGenerator>
#include <QSysInfo>
#include <QThread>
#include <memory>
#include <utility>

#include "core/document/classroom/pupil_name.h"
#include "core/document/file_bytes.h"
#include "core/document/file_names.h"
#include "core/document/store.h"
#include "core/document/work_folder.h"

namespace ew {
namespace {

constexpr int kMostCopies = 99;
const QString kLock = QStringLiteral(".lock");

/// Held while a folder is looked at and written to. Not every share knows locks; that two write in
/// the same millisecond is then noticed with the next writing.
std::unique_ptr<WorkLock> lockOf(const QString& folder) {
    constexpr int kTries = 20;
    constexpr unsigned long kWaitMs = 10;
    const QString path = folder + '/' + kLock;
    auto lock = WorkLock::take(path);
    for (int i = 0; i < kTries && lock == nullptr && QFileInfo::exists(path); ++i) {
        QThread::msleep(kWaitMs);
        lock = WorkLock::take(path);
    }
    return lock;
}

Result<void> makeFolder(const QString& path) {
    if (QFileInfo(path).isDir() || QDir().mkpath(path)) return {};
    return fail(Errc::CannotWrite, "The folder " + path.toStdString() + " cannot be made.");
}

}  // namespace

ClassWriter ClassWriter::here() {
    return {QSysInfo::machineHostName().toStdString(),
            QString::number(QRandomGenerator::system()->generate64(), 36).toStdString()};
}

QString lessonDocument(const std::string& lesson) {
    return QString::fromStdString(lesson) + kDocumentEnding;
}

Result<PupilFiles> PupilFiles::join(const QString& classFolder, const QString& name,
                                    const ClassWriter& writer) {
    const auto clean = pupilName(name);
    if (!clean) return fail(clean.error());
    PupilFiles out(QDir(classFolder).absolutePath(), writer);
    if (!QFileInfo(out.class_).isDir()) {
        return fail(Errc::FileNotFound,
                    "There is no class folder at " + out.class_.toStdString() + ".");
    }
    if (auto ok = makeFolder(out.class_ + '/' + kClassWork); !ok) return fail(ok.error());
    if (auto ok = out.take(*clean, 1); !ok) return fail(ok.error());
    return out;
}

std::optional<Error> PupilFiles::takeNotice() { return std::exchange(notice_, std::nullopt); }

PupilFiles::Found PupilFiles::look(const QString& folder, const QString& name) {
    const QString file = folder + '/' + kProgressFile;
    if (!QFileInfo::exists(file)) {
        // The lock, and a file that another program is writing this moment, are hidden.
        const auto seen = QDir::AllEntries | QDir::System | QDir::NoDotAndDotDot;
        return {QDir(folder).isEmpty(seen) ? Holds::Nothing : Holds::Unreadable, {}, {}};
    }
    auto text = readFileBytes(file, kMaxProgressBytes);
    if (!text) return {Holds::Unreadable, {}, {}};
    auto read = readProgress(*text);
    if (!read) return {Holds::Unreadable, {}, {}};
    const Holds holds = read->name == name.toStdString() ? Holds::Hers : Holds::Another;
    return {holds, *std::move(read), *std::move(text)};
}

/// The folder to take: the first that is hers, rather one that this machine wrote to, else a new
/// one.
/// \param firstCopy  over 1: only a new one.
PupilFiles::Choice PupilFiles::choose(const QString& name, int firstCopy) const {
    Choice out;
    for (int copy = firstCopy; copy <= kMostCopies; ++copy) {
        const QString folder = class_ + '/' + kClassWork + '/' + pupilFolderName(name, copy);
        const Found found = QFileInfo::exists(folder) ? look(folder, name) : Found{};
        if (found.holds == Holds::Nothing) {
            if (out.folder.isEmpty()) out.folder = folder;
            return out;
        }
        if (found.holds == Holds::Unreadable) out.unreadable = folder + '/' + kProgressFile;
        if (found.holds != Holds::Hers || firstCopy > 1) continue;
        const bool own = found.progress.machine == writer_.machine;
        if (out.folder.isEmpty() || own) out.folder = folder;
        if (own) return out;
    }
    return out;
}

Result<void> PupilFiles::take(const QString& name, int firstCopy) {
    const Choice choice = choose(name, firstCopy);
    if (choice.folder.isEmpty()) {
        return fail(Errc::CannotWrite, "There are too many folders for one name in " +
                                           (class_ + '/' + kClassWork).toStdString() + ".");
    }
    if (auto ok = makeFolder(choice.folder); !ok) return ok;
    const auto lock = lockOf(choice.folder);
    Found found = look(choice.folder, name);
    const bool isNew = found.holds == Holds::Nothing;
    if (!isNew && (found.holds != Holds::Hers || firstCopy > 1)) return take(name, firstCopy + 1);
    PupilProgress next = progress_;
    if (!isNew) next = std::move(found.progress);
    next.name = name.toStdString();
    const QString before = std::exchange(folder_, choice.folder);
    text_ = isNew ? std::string() : std::move(found.text);
    if (auto ok = put(std::move(next)); !ok) {
        folder_ = before;
        return ok;
    }
    if (!choice.unreadable.isEmpty() && isNew) {
        notice_ = Error{Errc::Damaged,
                        choice.unreadable.toStdString() +
                            " cannot be read; it was left as it is, and the work goes on in " +
                            folder_.toStdString() + ".",
                        {}};
    }
    return {};
}

/// Is the folder as it was left? If another program wrote to it, a further one is taken.
Result<void> PupilFiles::makeSure() {
    // An empty folder stays where a stick was.
    if (!QFileInfo(class_ + '/' + kClassWork).isDir()) {
        return fail(Errc::FileNotFound,
                    "The class folder " + class_.toStdString() +
                        " is gone. Put the stick back in, or connect the share again.");
    }
    if (auto ok = makeFolder(folder_); !ok) return ok;
    const QString file = folder_ + '/' + kProgressFile;
    if (!QFileInfo::exists(file)) return {};
    const auto text = readFileBytes(file, kMaxProgressBytes);
    if (text && *text == text_) return {};
    const auto read = text ? readProgress(*text) : fail(text.error());
    // It was written whole although that was told otherwise.
    if (read && read->session == writer_.session) {
        text_ = *text;
        return {};
    }
    const std::string other = read ? read->machine : "?";
    const QString left = folder_;
    const std::string apart =
        std::exchange(progress_.apart, QFileInfo(left).fileName().toStdString());
    const std::string expected = text_;
    if (auto ok = take(QString::fromStdString(progress_.name), 2); !ok) {
        progress_.apart = apart;
        text_ = expected;
        return ok;
    }
    notice_ = Error{Errc::InUse,
                    "Another machine (" + other + ") writes to " + left.toStdString() +
                        ", too. That was left as it is, and the work goes on in " +
                        folder_.toStdString() + ".",
                    {}};
    return {};
}

/// \pre the folder is as it must be.
Result<void> PupilFiles::put(PupilProgress progress) {
    progress.machine = writer_.machine;
    progress.session = writer_.session;
    std::string text = progressText(progress);
    if (auto ok = writeFileBytes(folder_ + '/' + kProgressFile, text); !ok) return ok;
    text_ = std::move(text);
    progress_ = std::move(progress);
    return {};
}

Result<void> PupilFiles::write(const PupilProgress& progress) {
    const auto lock = lockOf(folder_);
    if (auto ok = makeSure(); !ok) return ok;
    PupilProgress next = progress;
    next.name = progress_.name;
    next.apart = progress_.apart;
    return put(std::move(next));
}

Result<void> PupilFiles::writeDocument(const std::string& lesson, const std::string& bytes) {
    const auto lock = lockOf(folder_);
    if (auto ok = makeSure(); !ok) return ok;
    const QString path = folder_ + '/' + lessonDocument(lesson);
    if (isFileOfLaterSchema(path)) {
        return fail(Errc::WrongVersion, path.toStdString() +
                                            " was written by a later version of the program and "
                                            "is left as it is.");
    }
    return writeFileBytes(path, bytes);
}

QString PupilFiles::shelfOf(const QString& shelf) const {
    constexpr qsizetype kDigits = 12;
    const QByteArray sum =
        QCryptographicHash::hash(class_.toUtf8(), QCryptographicHash::Sha256).toHex();
    return shelf + '/' + QString::fromLatin1(sum.first(kDigits)) + '/' +
           pupilFolderName(QString::fromStdString(progress_.name));
}

Result<void> PupilFiles::shelve(const QString& shelf, const PupilProgress& progress,
                                const std::string& lesson, const std::string& bytes) const {
    const QString place = shelfOf(shelf);
    if (auto ok = makeFolder(place); !ok) return ok;
    if (!bytes.empty()) {
        if (auto ok = writeFileBytes(place + '/' + lessonDocument(lesson), bytes); !ok) return ok;
    }
    return writeFileBytes(place + '/' + kProgressFile, progressText(progress));
}

void PupilFiles::clearShelf(const QString& shelf) const {
    QDir(shelfOf(shelf)).removeRecursively();
}

Result<void> PupilFiles::unshelve(const QString& shelf) {
    const QDir place(shelfOf(shelf));
    const auto text = readFileBytes(place.filePath(kProgressFile), kMaxProgressBytes);
    if (!text) return {};
    const auto kept = readProgress(*text);
    if (!kept) return {};
    PupilProgress merged = progress_;
    mergeProgress(merged, *kept);
    if (auto ok = write(merged); !ok) return ok;
    for (const QString& name :
         place.entryList({'*' + kDocumentEnding}, QDir::Files | QDir::NoSymLinks, QDir::Name)) {
        const auto bytes = readFileBytes(place.filePath(name), kMaxDocumentBytes);
        if (!bytes) continue;
        const QString base = QFileInfo(name).completeBaseName();
        QString target = folder_ + '/' + name;
        for (int i = 2; QFileInfo::exists(target); ++i) {
            const auto there = readFileBytes(target, kMaxDocumentBytes);
            if (there && *there == *bytes) break;
            target = QStringLiteral("%1/%2 (%3)%4").arg(folder_, base).arg(i).arg(kDocumentEnding);
        }
        if (QFileInfo::exists(target)) continue;
        if (auto ok = writeFileBytes(target, *bytes); !ok) return ok;
    }
    clearShelf(shelf);
    notice_ = Error{Errc::CannotWrite,
                    "What could not be written to the class folder last time was brought there "
                    "now.",
                    {}};
    return {};
}

}  // namespace ew
