// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDateTime>
#include <QString>
#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/document/store_reader.h"

namespace ew {

/// The lock of a working copy: held as long as this lives, and let go by the system when the
/// process ends in whatever way.
class WorkLock {
  public:
    /// Nothing where another process (or this one) holds it. The lock file is made where it is not
    /// there.
    static std::unique_ptr<WorkLock> take(const QString& path);
    /// The same, but waits until it is free. Nothing where the file cannot be made.
    static std::unique_ptr<WorkLock> wait(const QString& path);
    ~WorkLock();
    WorkLock(const WorkLock&) = delete;
    WorkLock& operator=(const WorkLock&) = delete;

  private:
    explicit WorkLock(int descriptor) : descriptor_(descriptor) {}
    static std::unique_ptr<WorkLock> locked(const QString& path, int how);
    int descriptor_;
};

/// What the file beside a working copy says of it.
struct WorkNote {
    QString documentPath;  ///< absolute; empty: the document has no file yet
    QString owner;         ///< who has it open: program, process and machine
    qint64 process = 0;
    bool closed = false;  ///< its document was closed as one closes a document
    QDateTime declined;   ///< when somebody did not want it back
};

/// A working copy that is there.
struct WorkCopyEntry {
    QString path;  ///< of its database
    WorkNote note;
    bool open = false;  ///< a program works in it; then the members below are not known
    QDateTime time;     ///< of the last thing that was done
    DocumentSummary summary;
    bool saved = false;            ///< all of it is in the document's file, too
    std::optional<Error> problem;  ///< why it cannot be read

    /// Is there something to get back that its document was not closed with?
    bool lost() const { return !open && !saved && !note.closed && !problem; }
};

/// How long and how many of them are kept.
struct WorkLimits {
    int copies = 20;                              ///< of documents that were closed
    std::size_t bytes = std::size_t{512} << 20U;  ///< all of those together
    int daysDeclined = 30;                        ///< of those that nobody wanted
};

/// The folder in which documents under work are kept, each in a file of its own.
class WorkFolder {
  public:
    explicit WorkFolder(QString path) : path_(std::move(path)) {}
    /// `edgewright/work` in the user's state folder ($XDG_STATE_HOME, ~/.local/state).
    static QString standardPath();

    const QString& path() const { return path_; }
    /// All copies, the newest first. Empty ones are removed on the way.
    std::vector<WorkCopyEntry> list() const;
    /// Only what the notes say, without looking into the copies: who has which document open now.
    std::optional<WorkNote> openElsewhere(const QString& documentPath) const;
    /// The document in a copy. Errors as readDocument(), InUse.
    Result<DocumentFile> read(const WorkCopyEntry& entry, const TemplateLibrary& shipped) const;
    /// Nobody wants it back; it goes after WorkLimits::daysDeclined.
    Result<void> decline(const WorkCopyEntry& entry) const;
    void remove(const WorkCopyEntry& entry) const;
    /// Removes what the limits do not let stay; never one that is open or lost.
    void tidy(const WorkLimits& limits) const;

    // Names of the files of one copy.
    static QString lockPath(const QString& path) { return path + QStringLiteral(".lock"); }
    static QString notePath(const QString& path) { return path + QStringLiteral(".note"); }
    QString newPath() const;
    static Result<void> writeNote(const QString& path, const WorkNote& note);
    static WorkNote readNote(const QString& path);
    static void removeFiles(const QString& path);

  private:
    QString path_;
};

}  // namespace ew
