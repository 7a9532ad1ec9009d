// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <optional>
#include <string>

#include "core/document/classroom/pupil_progress.h"

namespace ew {

/// Who writes into a class folder.
struct ClassWriter {
    std::string machine;
    std::string session;
    /// This computer, and a session that no other has.
    static ClassWriter here();
};

/// What is in a class folder.
inline const QString kClassWork = QStringLiteral("work");        ///< a folder for each pupil
inline const QString kClassLessons = QStringLiteral("lessons");  ///< none: the shipped ones
inline const QString kProgressFile = QStringLiteral("progress.json");

/// A pupil's own folder inside a class folder: what she did (progress.json) and a document for each
/// lesson. Each file is written whole or not at all, and only over what this program wrote or read
/// last: where another machine wrote meanwhile, the folder stays as that left it, and a further one
/// is begun beside it. For one thread at a time.
class PupilFiles {
  public:
    /// Takes the pupil's folder, made where there is none, and says so in it. A folder that holds
    /// another pupil's work, or progress that cannot be read, is left as it is; a further one is
    /// taken then. Errors: BadValue for the name; FileNotFound where the class folder is not there;
    /// CannotWrite.
    static Result<PupilFiles> join(const QString& classFolder, const QString& name,
                                   const ClassWriter& writer);

    /// As it was read, or written last.
    const PupilProgress& progress() const { return progress_; }
    const QString& classFolder() const { return class_; }
    /// Of the pupil, absolute.
    const QString& folder() const { return folder_; }
    /// What a person should know since the last call: that there are two folders, and why; else
    /// nothing.
    std::optional<Error> takeNotice();

    /// Errors: CannotWrite, FileNotFound where the class folder is gone. Nothing that was there is
    /// lost then.
    Result<void> write(const PupilProgress& progress);
    /// The bytes of a document, for a lesson. Errors: as write().
    Result<void> writeDocument(const std::string& lesson, const std::string& bytes);

    /// Keeps both on this computer where the class folder cannot be written: Errors: CannotWrite.
    /// \param shelf  a folder of this computer, for all classes.
    /// \param bytes  of the document; none where empty.
    Result<void> shelve(const QString& shelf, const PupilProgress& progress,
                        const std::string& lesson, const std::string& bytes) const;
    /// Nothing on the shelf is needed any more.
    void clearShelf(const QString& shelf) const;
    /// Brings what is on the shelf for this pupil into the class folder: progress is merged, a
    /// document takes a name of its own where there is one. A notice tells it. Errors: as write();
    /// the shelf stays as it is then.
    Result<void> unshelve(const QString& shelf);

  private:
    explicit PupilFiles(QString classFolder, ClassWriter writer)
        : class_(std::move(classFolder)), writer_(std::move(writer)) {}
    enum class Holds { Nothing, Hers, Another, Unreadable };
    struct Found {
        Holds holds = Holds::Nothing;
        PupilProgress progress;
        std::string text;
    };
    struct Choice {
        QString folder;
        QString unreadable;  ///< a file that was passed over
    };
    static Found look(const QString& folder, const QString& name);
    Choice choose(const QString& name, int firstCopy) const;
    Result<void> take(const QString& name, int firstCopy);
    Result<void> makeSure();
    Result<void> put(PupilProgress progress);
    QString shelfOf(const QString& shelf) const;

    QString class_;
    QString folder_;
    ClassWriter writer_;
    PupilProgress progress_;
    std::string text_;  ///< of progress.json as it must still be there
    std::optional<Error> notice_;
};

/// File name of the document of a lesson.
QString lessonDocument(const std::string& lesson);

}  // namespace ew
