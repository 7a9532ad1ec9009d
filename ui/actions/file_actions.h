// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <functional>
#include <optional>

#include "core/document/replay.h"
#include "ui/window_context.h"

class QAction;
class QMenu;
class QWidget;

namespace ew {

class RecentActions;
class WorkKeeper;

/// New, open, save, export, scripts and pictures.
class FileActions : public QObject {
    Q_OBJECT

  public:
    enum class Answer { Save, Discard, Cancel };

    /// \param work  null where no working copies are kept.
    FileActions(const WindowContext& context, WorkKeeper* work, QWidget* window);

    /// Fills the File menu. Examples are looked for when their menu opens.
    /// \param recent  lists recent files; null: there is no such list.
    void fill(QMenu* menu, RecentActions* recent = nullptr);

    /// A document, or a sketch script that is replayed into an empty document; the content tells
    /// which. Nothing is written: steps that write or open files are left out, and told. Says why
    /// in the message bar where it fails.
    bool openPath(const QString& path);
    /// The same, after asking about unsaved changes.
    void openAsked(const QString& path);
    /// The same for an example: the folder of the person's own files stays the one to start from.
    void openExample(const QString& path);
    /// Asks first where someone else changed the document's file meanwhile.
    bool saveTo(const QString& path);
    /// Opens somebody else's work to look at it, after asking about unsaved changes: the document
    /// has no file here, so nothing is saved over hers.
    /// \param name  of the work, for the window's title.
    void lookAt(const QString& path, const QString& name);
    /// What a document without a file is called.
    QString untitledName() const;
    bool saveScriptTo(const QString& path);
    bool exportTo(const QString& path, const ExportOptions& options = {});
    /// The unit of formats that have none, once a person has said which.
    const std::optional<ExportUnit>& exportUnit() const { return exportUnit_; }
    void setExportUnit(std::optional<ExportUnit> unit) { exportUnit_ = unit; }
    bool screenshotTo(const QString& path);

    /// Asks about unsaved changes where there are any; false: do not go on.
    bool mayDiscard();
    /// How mayDiscard() asks; a message box unless set.
    void setQuestion(std::function<Answer()> question) { question_ = std::move(question); }

    void newDocument();
    void open();

  signals:
    /// A file was opened or saved; empty: what is shown has none any more.
    void fileUsed(const QString& path);
    /// A further window is wanted.
    void windowWanted();
    void startPageWanted();

  public:
    QAction* newAction;
    QAction* newWindowAction;
    QAction* startPageAction;
    QAction* openAction;
    QAction* saveAction;
    QAction* exportAction;
    QAction* revertAction;

  private:
    bool save();
    bool saveAs();
    void saveCopy();
    void revert();
    void saveScript();
    void exportSolid();
    /// Asks for what the export leaves open. False: it is given up.
    bool askExport(const QString& path, ExportOptions& options);
    void askUnit();
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
    std::optional<ExportUnit> exportUnit_;
    QString folder_;
    /// What is looked at, in that life of the document.
    struct Looked {
        QString name;
        long life = -1;
    };
    Looked looked_;
    QString scriptName_;  ///< of the script that was opened last, without its ending
};

}  // namespace ew
