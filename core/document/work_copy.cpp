// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/work_copy.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QSysInfo>
#include <atomic>
#include <condition_variable>
#include <deque>
#include <functional>
#include <mutex>
#include <optional>
#include <thread>

#include "core/document/store_schema.h"
#include "core/document/store_writer.h"

namespace ew {

/// The thread that has the database.
class WorkCopy::Writer {
  public:
    using Told = std::function<void(Result<void>)>;

    /// \param told  called on the writer's thread after every update.
    Writer(std::string path, Told told)
        : path_(std::move(path)), told_(std::move(told)), thread_([this] { run(); }) {}
    ~Writer() {
        {
            const std::lock_guard lock(mutex_);
            ending_ = true;
        }
        changed_.notify_all();
        thread_.join();
    }
    Writer(const Writer&) = delete;
    Writer& operator=(const Writer&) = delete;

    void push(DocumentUpdate update) {
        {
            const std::lock_guard lock(mutex_);
            waiting_.push_back(std::move(update));
            ++pushed_;
        }
        changed_.notify_all();
    }
    Result<void> flush() {
        std::unique_lock lock(mutex_);
        const long wanted = pushed_;
        changed_.wait(lock, [&] { return done_ >= wanted; });
        return last_;
    }
    /// After an error, and at first, only a whole update is of use.
    bool needsWhole() const { return needsWhole_; }

  private:
    void run() {
        std::unique_lock lock(mutex_);
        while (true) {
            changed_.wait(lock, [&] { return ending_ || !waiting_.empty(); });
            if (waiting_.empty()) return;
            const DocumentUpdate update = std::move(waiting_.front());
            waiting_.pop_front();
            lock.unlock();
            const Result<void> result = write(update);
            needsWhole_ = !result;
            told_(result);
            lock.lock();
            last_ = result;
            ++done_;
            changed_.notify_all();
        }
    }

    Result<void> write(const DocumentUpdate& update) {
        if (!database_) {
            auto opened = Database::openFile(path_, schema::kKind);
            if (!opened) return fail(opened.error());
            database_.emplace(*std::move(opened));
            writer_.emplace(*database_);
        }
        return writer_->write(update);
    }

    std::string path_;
    Told told_;
    std::optional<Database> database_;  // of the thread
    std::optional<DocumentWriter> writer_;
    std::mutex mutex_;
    std::condition_variable changed_;
    std::deque<DocumentUpdate> waiting_;
    long pushed_ = 0;
    long done_ = 0;
    Result<void> last_;
    bool ending_ = false;
    std::atomic<bool> needsWhole_ = true;
    std::thread thread_;  // last: it uses the others
};

namespace {

/// Who has a document open, for another window to tell.
QString ownerText() {
    return QStringLiteral("%1 (%2, %3)")
        .arg(QCoreApplication::applicationName())
        .arg(QCoreApplication::applicationPid())
        .arg(QSysInfo::machineHostName());
}

}  // namespace

WorkCopy::WorkCopy(Document& document, const WorkFolder& folder, QObject* parent)
    : QObject(parent), document_(document), folder_(folder), life_(document.life()) {
    connect(&document, &Document::changed, this, &WorkCopy::documentChanged);
    if (!document.filePath().isEmpty()) claim();
}

WorkCopy::~WorkCopy() {
    if (life_ == document_.life()) static_cast<void>(capture());
    end();
}

QString WorkCopy::path() const { return writer_ ? path_ : QString(); }

void WorkCopy::replaces(const WorkCopyEntry& entry) { replaced_ = entry.path; }

void WorkCopy::documentChanged(DocumentChange what) {
    if (life_ != document_.life()) {
        end();
        life_ = document_.life();
    }
    if (what == DocumentChange::File) claim();
    if (what == DocumentChange::Camera || captureSoon_) return;
    captureSoon_ = true;
    // As an event of its own: when it comes, what is being done is done, and nothing is painted
    // before it.
    QMetaObject::invokeMethod(this, &WorkCopy::capture, Qt::QueuedConnection);
}

void WorkCopy::claim() {
    WorkNote note = note_;
    note.documentPath = document_.filePath();
    if (!note.documentPath.isEmpty()) {
        note.documentPath = QFileInfo(note.documentPath).absoluteFilePath();
    }
    // An empty document that nothing is done to needs no copy.
    const bool idle = document_.untouched() && !keepsIdle_;
    if (lock_ == nullptr && note.documentPath.isEmpty() && idle) return;
    if (lock_ == nullptr) {
        if (!QDir().mkpath(folder_.path())) return;
        path_ = folder_.newPath();
        lock_ = WorkLock::take(WorkFolder::lockPath(path_));
        note.owner = ownerText();
        note.process = QCoreApplication::applicationPid();
    } else if (note.documentPath == note_.documentPath) {
        return;
    }
    note_ = note;
    static_cast<void>(WorkFolder::writeNote(path_, note_));
}

Result<void> WorkCopy::capture() {
    captureSoon_ = false;
    if (!writer_ && document_.untouched() && !keepsIdle_) return {};
    if (lock_ == nullptr) claim();
    if (lock_ == nullptr) {
        const Error error{
            Errc::CannotWrite,
            "The folder " + folder_.path().toStdString() + " cannot be made or written to.",
            {}};
        wrote(fail(error));
        return fail(error);
    }
    if (!writer_) {
        writer_ = std::make_unique<Writer>(
            QFile::encodeName(path_).toStdString(), [this](Result<void> result) {
                QMetaObject::invokeMethod(
                    this, [this, result] { wrote(result); }, Qt::QueuedConnection);
            });
    }
    DocumentUpdate update = document_.takeUpdate(writer_->needsWhole());
    update.saved = !document_.isModified();
    writer_->push(std::move(update));
    return {};
}

void WorkCopy::wrote(const Result<void>& result) {
    if (!result && !toldFailure_) emit failed(result.error());
    toldFailure_ = !result;
    if (result && !replaced_.isEmpty()) {
        const auto lock = WorkLock::take(WorkFolder::lockPath(replaced_));
        if (lock != nullptr) WorkFolder::removeFiles(replaced_);
        replaced_.clear();
    }
}

Result<void> WorkCopy::flush() {
    if (life_ == document_.life()) {
        if (auto ok = capture(); !ok) return ok;
    }
    return writer_ ? writer_->flush() : Result<void>();
}

void WorkCopy::end() {
    const bool any = writer_ != nullptr;
    writer_.reset();
    if (lock_ != nullptr && any) {
        note_.closed = true;
        static_cast<void>(WorkFolder::writeNote(path_, note_));
    } else if (lock_ != nullptr) {
        WorkFolder::removeFiles(path_);
    }
    lock_.reset();
    note_ = {};
    path_.clear();
}

}  // namespace ew
