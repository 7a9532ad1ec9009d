// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/work_folder.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QRandomGenerator>
#include <QStandardPaths>
#include <algorithm>

#include "core/document/file_names.h"
#include "core/document/json_text.h"
#include "core/document/store_reader.h"
#include "core/document/store_schema.h"

namespace ew {

// The lock ---------------------------------------------------------------------------------------

std::unique_ptr<WorkLock> WorkLock::take(const QString& path) {
    return locked(path, LOCK_EX | LOCK_NB);
}

std::unique_ptr<WorkLock> WorkLock::wait(const QString& path) { return locked(path, LOCK_EX); }

std::unique_ptr<WorkLock> WorkLock::locked(const QString& path, int how) {
    constexpr mode_t kPrivate = 0600;
    const int descriptor =
        ::open(QFile::encodeName(path).constData(), O_RDWR | O_CREAT | O_CLOEXEC, kPrivate);
    if (descriptor < 0) return nullptr;
    if (::flock(descriptor, how) != 0) {
        ::close(descriptor);
        return nullptr;
    }
    return std::unique_ptr<WorkLock>(new WorkLock(descriptor));
}

WorkLock::~WorkLock() { ::close(descriptor_); }

// Notes ------------------------------------------------------------------------------------------

namespace {

constexpr std::size_t kMaxNoteBytes = 1U << 20U;

QDateTime timeOf(const nlohmann::json& value, const std::string& place) {
    return QDateTime::fromString(QString::fromStdString(readString(value, place)),
                                 Qt::ISODateWithMs);
}

std::string quoted(const QString& text) { return jsonQuoted(text.toStdString()); }

}  // namespace

Result<void> WorkFolder::writeNote(const QString& path, const WorkNote& note) {
    std::string text = "{\"document\": " + quoted(note.documentPath) +
                       ", \"owner\": " + quoted(note.owner) +
                       ", \"process\": " + std::to_string(note.process) +
                       ", \"closed\": " + (note.closed ? "true" : "false");
    if (note.declined.isValid()) {
        text += ", \"declined\": " + quoted(note.declined.toUTC().toString(Qt::ISODateWithMs));
    }
    return writeFileBytes(notePath(path), text + "}\n");
}

WorkNote WorkFolder::readNote(const QString& path) {
    WorkNote note;
    const auto text = readFileBytes(notePath(path), kMaxNoteBytes);
    if (!text) return note;
    const auto tree = parseJson(*text, {.maxBytes = kMaxNoteBytes});
    if (!tree) return note;
    try {
        const ObjectReader in(*tree, "note");
        const auto textOf = [&](const char* key) {
            return QString::fromStdString(readString(in.require(key), in.at(key)));
        };
        note.documentPath = textOf("document");
        note.owner = textOf("owner");
        const auto& process = in.require("process");
        if (process.is_number_integer()) note.process = process.get<qint64>();
        note.closed = in.require("closed") == true;
        if (const auto* v = in.find("declined")) note.declined = timeOf(*v, in.at("declined"));
    } catch (const ReadError&) {
        // A note that cannot be read says nothing; the copy itself still does.
    }
    return note;
}

// The folder -------------------------------------------------------------------------------------

QString WorkFolder::standardPath() {
    QString state = qEnvironmentVariable("XDG_STATE_HOME");
    if (!QDir::isAbsolutePath(state)) state = QDir::homePath() + QStringLiteral("/.local/state");
    return state + QStringLiteral("/edgewright/work");
}

QString WorkFolder::newPath() const {
    const QString time = QDateTime::currentDateTimeUtc().toString(QStringLiteral("yyyyMMddHHmmss"));
    const QString tail = QString::number(QRandomGenerator::global()->generate(), 36);
    return QDir(path_).absoluteFilePath(time + '-' + tail + kDocumentEnding);
}

void WorkFolder::removeFiles(const QString& path) {
    // The lock goes last: as long as it is there, nobody else takes the copy for theirs.
    for (const char* tail : {"-wal", "-shm", "-journal", "", ".note", ".lock"}) {
        QFile::remove(path + QLatin1String(tail));
    }
}

namespace {

/// When something was last written into a copy, its log included.
QDateTime lastWritten(const QString& path) {
    const QDateTime file = QFileInfo(path).lastModified();
    const QFileInfo log(path + QStringLiteral("-wal"));
    return log.exists() && log.size() > 0 ? std::max(file, log.lastModified()) : file;
}

std::size_t bytesOf(const QString& path) {
    return static_cast<std::size_t>(QFileInfo(path).size() +
                                    QFileInfo(path + QStringLiteral("-wal")).size());
}

/// Looks into a copy.
/// \return false where there is nothing in it.
bool lookInto(WorkCopyEntry& entry) {
    entry.time = lastWritten(entry.path);
    auto database = Database::openFile(QFile::encodeName(entry.path).toStdString(), schema::kKind,
                                       Database::Missing::Refuse);
    if (!database) {
        entry.problem = database.error();
        return true;
    }
    bool any = false;
    const auto counted = database->each(schema::kSetting, [&](const Row& row) -> Result<void> {
        any = true;
        if (row[0] == Field(std::string("saved")))
            entry.saved = row[1] == Field(std::string("true"));
        return {};
    });
    if (counted && !any) return false;
    auto summary = summarizeDatabase(*database);
    if (summary)
        entry.summary = *std::move(summary);
    else
        entry.problem = summary.error();
    return true;
}

}  // namespace

std::vector<WorkCopyEntry> WorkFolder::list() const {
    std::vector<WorkCopyEntry> entries;
    const QDir folder(path_);
    for (const QFileInfo& file : folder.entryInfoList({'*' + kDocumentEnding}, QDir::Files)) {
        WorkCopyEntry entry;
        entry.path = file.absoluteFilePath();
        entry.note = readNote(entry.path);
        const auto lock = WorkLock::take(lockPath(entry.path));
        entry.open = lock == nullptr;
        if (entry.open)
            entry.time = lastWritten(entry.path);
        else if (!lookInto(entry)) {
            removeFiles(entry.path);
            continue;
        }
        entries.push_back(std::move(entry));
    }
    std::sort(entries.begin(), entries.end(), [](const WorkCopyEntry& a, const WorkCopyEntry& b) {
        return std::tie(b.time, b.path) < std::tie(a.time, a.path);
    });
    return entries;
}

std::optional<WorkNote> WorkFolder::openElsewhere(const QString& documentPath) const {
    const QString wanted = QFileInfo(documentPath).canonicalFilePath();
    const QDir folder(path_);
    for (const QFileInfo& file : folder.entryInfoList({"*.note"}, QDir::Files)) {
        const QString path = file.absolutePath() + '/' + file.completeBaseName();
        const WorkNote note = readNote(path);
        if (wanted.isEmpty() || QFileInfo(note.documentPath).canonicalFilePath() != wanted) {
            continue;
        }
        if (WorkLock::take(lockPath(path)) == nullptr) return note;
    }
    return std::nullopt;
}

Result<DocumentFile> WorkFolder::read(const WorkCopyEntry& entry,
                                      const TemplateLibrary& shipped) const {
    const auto lock = WorkLock::take(lockPath(entry.path));
    if (lock == nullptr) return fail(Errc::InUse, "Another window has this document open.");
    auto database = Database::openFile(QFile::encodeName(entry.path).toStdString(), schema::kKind,
                                       Database::Missing::Refuse);
    if (!database) return fail(database.error());
    return readDatabase(*database, shipped, {.whole = false});
}

Result<void> WorkFolder::decline(const WorkCopyEntry& entry) const {
    WorkNote note = readNote(entry.path);
    note.closed = true;
    note.declined = QDateTime::currentDateTimeUtc();
    return writeNote(entry.path, note);
}

void WorkFolder::remove(const WorkCopyEntry& entry) const {
    const auto lock = WorkLock::take(lockPath(entry.path));
    if (lock != nullptr) removeFiles(entry.path);
}

void WorkFolder::tidy(const WorkLimits& limits) const {
    int copies = 0;
    std::size_t bytes = 0;
    const QDateTime longAgo = QDateTime::currentDateTimeUtc().addDays(-limits.daysDeclined);
    for (const WorkCopyEntry& entry : list()) {
        if (entry.open || entry.lost() || entry.problem) continue;
        if (entry.note.declined.isValid()) {
            if (entry.note.declined < longAgo) remove(entry);
            continue;
        }
        bytes += bytesOf(entry.path);
        if (++copies > limits.copies || bytes > limits.bytes) remove(entry);
    }
}

}  // namespace ew
