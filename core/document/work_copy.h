// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <memory>

#include "core/document/document.h"
#include "core/document/work_folder.h"

namespace ew {

/// Keeps a working copy of a document while one works: after every command and every finished
/// stroke, what changed goes into a database in the work folder as one transaction, on a thread of
/// its own. What is in it outlives whatever ends the program. The copy is begun when something is
/// changed; opening another document ends it, and closing the window closes it.
class WorkCopy : public QObject {
    Q_OBJECT

  public:
    WorkCopy(Document& document, const WorkFolder& folder, QObject* parent = nullptr);
    /// Closes the copy; it stays for a while (WorkLimits).
    ~WorkCopy() override;

    /// Waits until all that was done so far is on the disk. Errors of what could not be written,
    /// which is tried again, whole, with the next change.
    Result<void> flush();
    /// Keeps a document, too, that only its view was changed of; without this an empty one that
    /// nothing was done to has no copy.
    void keepIdle() { keepsIdle_ = true; }
    /// The database, empty where nothing was changed yet.
    QString path() const;
    /// The document is from this copy, which is removed once the new one holds it all.
    void replaces(const WorkCopyEntry& entry);

  signals:
    /// Something could not be written; told once until it works again.
    void failed(const ew::Error& error);

  private:
    class Writer;
    void documentChanged(DocumentChange what);
    Result<void> capture();
    void claim();  ///< lock and note, with the document's path of now
    void end();
    void wrote(const Result<void>& result);

    Document& document_;
    WorkFolder folder_;
    bool captureSoon_ = false;
    std::unique_ptr<Writer> writer_;
    std::unique_ptr<WorkLock> lock_;
    QString path_;  ///< of the copy, with the lock and the note beside it; empty: none yet
    WorkNote note_;
    long life_ = 0;  ///< Document::life() that the copy is of
    QString replaced_;
    bool toldFailure_ = false;
    bool keepsIdle_ = false;
};

}  // namespace ew
