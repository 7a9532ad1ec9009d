// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QThreadPool>
#include <QTimer>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "core/document/classroom/pupil_files.h"
#include "core/document/lesson/lesson.h"
#include "ui/window_context.h"

namespace ew {

class LessonGuide;

/// A pupil at work in a class: what she does in lessons is kept in the class folder, soon after she
/// did it, by a thread of its own. Where it cannot be written (a stick is pulled out, a disk is
/// full) that is told once, it is kept on this computer meanwhile, and tried again until it works.
class ClassSession : public QObject {
    Q_OBJECT

  public:
    /// \param shelf  folder of this computer for what a class folder does not take.
    ClassSession(const WindowContext& context, LessonGuide& guide, QString shelf,
                 QObject* parent = nullptr);
    ~ClassSession() override;

    /// `edgewright/class` in the user's state folder.
    static QString standardShelf();

    /// Ends the lesson of the pupil who was at work here. Errors: those of PupilFiles::join(); that
    /// pupil stays then.
    Result<void> join(const QString& classFolder, const QString& name);
    /// Ends the lesson, keeps what is not kept yet, and goes.
    void leave();
    bool joined() const { return files_ != nullptr; }
    // The following are empty where nobody has joined.
    QString pupil() const;
    QString classFolder() const { return folder_; }
    /// Of the pupil, or null.
    const LessonProgress* progress(const std::string& lesson) const;
    /// The step to begin a lesson at: where she was, or the first where she was through.
    std::size_t stepOf(const Lesson& lesson) const;
    const std::vector<PracticeResult>& practice() const { return progress_.practice; }
    /// \pre joined()
    void keepPractice(const PracticeResult& result);
    /// Writes what is not written yet, and waits for it; false where that fails.
    bool settle();
    /// Is everything in the class folder, as far as is known?
    bool isKept() const { return !failing_; }

  signals:
    void changed();
    void failed(const ew::Error& error);
    void noticed(const QString& text);

  private:
    using Documents = std::map<std::string, std::shared_ptr<const DocumentFile>>;
    struct Outcome {
        std::optional<Error> error;
        std::optional<Error> notice;
    };
    static Outcome write(PupilFiles& files, const PupilProgress& progress,
                         const Documents& documents, const QString& shelf);
    void lessonChanged(const std::function<void(const std::string&, ClassTime)>& change,
                       bool withDocument);
    void tick();
    void takeDocument();
    void writeSoon();
    void begin();
    void finished(const Outcome& outcome, Documents documents);
    void tell(const Outcome& outcome);
    void forget();

    WindowContext context_;
    LessonGuide& guide_;
    QString shelf_;
    QString folder_;
    std::shared_ptr<PupilFiles> files_;  ///< the writing thread's while writing_
    PupilProgress progress_;
    Documents documents_;  ///< that are to be written
    bool dirty_ = false;
    bool writing_ = false;
    bool failing_ = false;
    QThreadPool pool_;
    QTimer soon_;
    QTimer tick_;
    QElapsedTimer sinceInput_;
};

}  // namespace ew
