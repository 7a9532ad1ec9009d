// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <functional>

#include "core/document/replay.h"
#include "ui/window_context.h"

class QAction;
class QMenu;
class QWidget;

namespace ew {

class WorkKeeper;

/// New, open, save, export, scripts and pictures.
class FileActions : public QObject {
    Q_OBJECT

  public:
    enum class Answer { Save, Discard, Cancel };

    /// \param work  null where no working copies are kept.
    FileActions(const WindowContext& context, WorkKeeper* work, QWidget* window);

    /// Fills the File menu. Examples are looked for when their menu opens.
    void fill(QMenu* menu);

    /// A document, or a sketch script that is replayed into an empty document; the content tells
    /// which. Nothing is written: steps that write or open files are left out, and told. Says why
    /// in the message bar where it fails.
    bool openPath(const QString& path);
    /// Asks first where someone else changed the document's file meanwhile.
    bool saveTo(const QString& path);
    bool saveScriptTo(const QString& path);
    bool exportTo(const QString& path, ExportFaces faces = ExportFaces::Simple);
    bool screenshotTo(const QString& path);

    /// Asks about unsaved changes where there are any; false: do not go on.
    bool mayDiscard();
    /// How mayDiscard() asks; a message box unless set.
    void setQuestion(std::function<Answer()> question) { question_ = std::move(question); }

    QAction* newAction;
    QAction* openAction;
    QAction* saveAction;
    QAction* exportAction;
    QAction* revertAction;

  private:
    void newDocument();
    void open();
    bool save();
    bool saveAs();
    void saveCopy();
    void revert();
    void saveScript();
    void exportSolid();
    void screenshot();
    void fillExamples(QMenu* menu);
    struct SaveDialog {
        QString title;
        QString filters;   ///< each with its ending, as in "PLY (*.ply)"
        QStringList kept;  ///< endings that are left as they are, beside those of the filters
    };
    /// Asks for a file to write. A name without one of the endings gets that of the filter; where
    /// the file that it is then called is there, that is asked about.
    /// \param filter  set to the filter that was chosen.
    QString askWhereTo(const SaveDialog& what, QString* filter = nullptr);
    /// What a question about something that cannot be taken back says.
    struct Warning {
        QString title;
        QString sentence;
        QString deed;  ///< the button that does it
    };
    bool mayDo(const Warning& warning);
    bool mayReplace(const QString& sentence);
    Answer askAboutChanges();
    bool openDocument(const QString& path);
    bool openScript(const QString& path, const std::string& text);
    bool tellReplay(const ReplayReport& result, const SketchScript& script);
    void refresh();
    QString startFolder() const;
    /// A name for what is there, without an ending.
    QString proposedName() const;
    bool report(const Result<void>& result, const QString& done);

    WindowContext context_;
    WorkKeeper* work_;
    QWidget* window_;
    std::function<Answer()> question_;
    QString folder_;
    QString scriptName_;  ///< of the script that was opened last, without its ending
};

}  // namespace ew
