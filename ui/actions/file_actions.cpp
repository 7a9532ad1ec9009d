// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/actions/file_actions.h"

#include <QAction>
#include <QApplication>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QMenu>
#include <QMessageBox>
#include <QPushButton>
#include <QStandardPaths>

#include "core/document/file_bytes.h"
#include "core/document/file_names.h"
#include "core/document/resources.h"
#include "core/document/sketch_script.h"
#include "core/document/store.h"
#include "ui/actions/recent_actions.h"
#include "ui/core_text.h"
#include "ui/dialogs/export_dialog.h"
#include "ui/long_job.h"
#include "ui/panels/body_panel.h"
#include "ui/panels/message_bar.h"
#include "ui/start/examples.h"
#include "ui/theme/themed_icon.h"
#include "ui/viewport/picture_file.h"
#include "ui/viewport/viewport_widget.h"
#include "ui/work_keeper.h"

namespace ew {

namespace {

/// ".ply" of "PLY (*.ply)".
QString endingOf(const QString& filter) {
    const auto dot = filter.indexOf(QStringLiteral("(*.")) + 2;
    return filter.mid(dot, filter.indexOf(QLatin1Char(')')) - dot);
}

/// A file of the program's own, such as an example.
bool isShipped(const QString& path) {
    const auto resources = resourcesFolder();
    const QString folder = resources ? QDir(*resources).canonicalPath() : QString();
    return !folder.isEmpty() && QFileInfo(path).canonicalFilePath().startsWith(folder + '/');
}

QStringList endingsOf(const QString& filters) {
    QStringList endings;
    for (const QString& filter : filters.split(QStringLiteral(";;"))) endings << endingOf(filter);
    return endings;
}

}  // namespace

FileActions::FileActions(const WindowContext& context, WorkKeeper* work, QWidget* window)
    : QObject(window),
      newAction(new QAction(themedIcon("document-new"), tr("&New"), this)),
      newWindowAction(new QAction(tr("New &window"), this)),
      startPageAction(new QAction(tr("Start pa&ge"), this)),
      openAction(new QAction(themedIcon("document-open"), tr("&Open\u2026"), this)),
      saveAction(new QAction(themedIcon("document-save"), tr("&Save"), this)),
      exportAction(new QAction(themedIcon("export"), tr("&Export\u2026"), this)),
      revertAction(new QAction(tr("Re&vert to the saved file"), this)),
      context_(context),
      work_(work),
      window_(window),
      folder_(QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation)) {
    newAction->setShortcut(QKeySequence::New);
    newWindowAction->setShortcut(QKeySequence(QStringLiteral("Ctrl+Shift+N")));
    openAction->setShortcut(QKeySequence::Open);
    saveAction->setShortcut(QKeySequence::Save);
    exportAction->setShortcut(QKeySequence(QStringLiteral("Ctrl+E")));
    newAction->setToolTip(tr("New document"));
    openAction->setToolTip(tr("Open a document or a sketch script"));
    saveAction->setToolTip(tr("Save the document"));
    exportAction->setToolTip(tr("Export the surface, cage or solid as OBJ, STL, PLY, glTF or 3MF"));
    connect(newAction, &QAction::triggered, this, &FileActions::newDocument);
    connect(newWindowAction, &QAction::triggered, this, &FileActions::windowWanted);
    connect(startPageAction, &QAction::triggered, this, &FileActions::startPageWanted);
    connect(openAction, &QAction::triggered, this, &FileActions::open);
    connect(saveAction, &QAction::triggered, this, &FileActions::save);
    connect(exportAction, &QAction::triggered, this, &FileActions::exportSolid);
    connect(revertAction, &QAction::triggered, this, &FileActions::revert);
    connect(&context_.document, &Document::changed, this, [this](DocumentChange what) {
        if (what == DocumentChange::Bodies || what == DocumentChange::File) refresh();
    });
    question_ = [this] { return askAboutChanges(); };
    refresh();
}

FileActions::Answer FileActions::askAboutChanges() {
    QMessageBox box(QMessageBox::Question, tr("Unsaved changes"),
                    tr("Save the changes to this document?"),
                    QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, window_);
    const bool kept = work_ != nullptr && work_->copy().flush();
    box.setInformativeText(kept ? tr("Without saving they are in no file, but File, Recover\u2026 "
                                     "offers them for a while.")
                                : tr("They are lost otherwise."));
    box.setDefaultButton(QMessageBox::Save);
    switch (box.exec()) {
        case QMessageBox::Save:
            return Answer::Save;
        case QMessageBox::Discard:
            return Answer::Discard;
        default:
            return Answer::Cancel;
    }
}

bool FileActions::mayDo(const Warning& warning) {
    QMessageBox box(QMessageBox::Warning, warning.title, warning.sentence, QMessageBox::Cancel,
                    window_);
    const auto* deed = box.addButton(warning.deed, QMessageBox::AcceptRole);
    box.setDefaultButton(QMessageBox::Cancel);
    box.exec();
    return box.clickedButton() == deed;
}

bool FileActions::mayReplace(const QString& sentence) {
    return mayDo({tr("Replace the file?"), sentence, tr("&Replace")});
}

void FileActions::fill(QMenu* menu, RecentActions* recent) {
    menu->addAction(newAction);
    menu->addAction(newWindowAction);
    menu->addAction(openAction);
    if (recent != nullptr) recent->addMenuTo(menu);
    QMenu* examples = menu->addMenu(tr("Open e&xample"));
    connect(examples, &QMenu::aboutToShow, this, [this, examples] { fillExamples(examples); });
    if (work_ != nullptr) {
        menu->addAction(tr("&Recover\u2026"), work_, &WorkKeeper::offerAll);
    }
    if (recent != nullptr) menu->addAction(startPageAction);
    menu->addSeparator();
    menu->addAction(saveAction);
    QAction* as = menu->addAction(tr("Save &as\u2026"), this, &FileActions::saveAs);
    // Spelled out: not every desktop has a standard for it.
    as->setShortcut(QKeySequence(QStringLiteral("Ctrl+Shift+S")));
    menu->addAction(tr("Save a cop&y\u2026"), this, &FileActions::saveCopy);
    menu->addAction(revertAction);
    menu->addAction(tr("Save what was done as a s&cript\u2026"), this, &FileActions::saveScript);
    menu->addSeparator();
    menu->addAction(exportAction);
    menu->addAction(tr("Export &unit\u2026"), this, &FileActions::askUnit);
    menu->addAction(tr("Screensho&t\u2026"), this, &FileActions::screenshot);
    menu->addSeparator();
    QAction* quit = menu->addAction(tr("&Quit"), qApp, &QApplication::closeAllWindows);
    quit->setShortcut(QKeySequence(QStringLiteral("Ctrl+Q")));
}

void FileActions::fillExamples(QMenu* menu) {
    menu->clear();
    for (const Example& example : examples()) {
        menu->addAction(example.title, this, [this, path = example.path] { openExample(path); });
    }
    if (menu->isEmpty()) menu->addAction(tr("There are no examples"))->setEnabled(false);
}

void FileActions::refresh() {
    const Document& document = context_.document;
    exportAction->setEnabled(!document.state().bodies.empty());
    revertAction->setEnabled(!document.filePath().isEmpty() && document.isModified());
}

bool FileActions::report(const Result<void>& result, const QString& done) {
    if (!result) {
        context_.messages.showError(result.error());
        return false;
    }
    if (!done.isEmpty()) context_.messages.showNotice(done);
    return true;
}

QString FileActions::startFolder() const {
    const QString path = context_.document.filePath();
    return path.isEmpty() ? folder_ : QFileInfo(path).absolutePath();
}

QString FileActions::proposedName() const {
    const QString path = context_.document.filePath();
    if (!path.isEmpty()) return QFileInfo(path).completeBaseName();
    return scriptName_.isEmpty() ? tr("Untitled") : scriptName_;
}

QString FileActions::askWhereTo(const SaveDialog& what, QString* filter) {
    context_.messages.clearNotice();
    const QStringList endings = endingsOf(what.filters);
    QString proposed = QDir(startFolder()).filePath(proposedName() + endings.front());
    while (true) {
        QFileDialog dialog(window_, what.title, QFileInfo(proposed).absolutePath(), what.filters);
        dialog.setAcceptMode(QFileDialog::AcceptSave);
        dialog.setFileMode(QFileDialog::AnyFile);
        // It knows only the name as it is typed, which is not always the file's.
        dialog.setOption(QFileDialog::DontConfirmOverwrite);
        dialog.selectFile(QFileInfo(proposed).fileName());
        if (dialog.exec() != QDialog::Accepted || dialog.selectedFiles().isEmpty()) return {};
        const QString picked = dialog.selectedFiles().front();
        const QString chosen = dialog.selectedNameFilter();
        if (filter != nullptr) *filter = chosen;
        const QString path = withEnding(picked, endings + what.kept, endingOf(chosen));
        if (!QFileInfo::exists(path) ||
            mayReplace(tr("%1 is there already.").arg(QFileInfo(path).fileName()))) {
            return path;
        }
        proposed = path;
    }
}

bool FileActions::mayDiscard() {
    if (!context_.document.isModified()) return true;
    switch (question_()) {
        case Answer::Save:
            return save();
        case Answer::Discard:
            return true;
        case Answer::Cancel:
            break;
    }
    return false;
}

void FileActions::newDocument() {
    context_.messages.clearNotice();
    if (!mayDiscard()) return;
    scriptName_.clear();
    context_.document.reset();
    emit fileUsed({});
}

void FileActions::openAsked(const QString& path) {
    if (mayDiscard()) openPath(path);
}

void FileActions::openExample(const QString& path) {
    if (!mayDiscard()) return;
    const QString own = folder_;
    const QSignalBlocker quiet(this);  // an example is none of the person's files
    openPath(path);
    folder_ = own;
}

void FileActions::open() {
    context_.messages.clearNotice();
    if (!mayDiscard()) return;
    const QString path = QFileDialog::getOpenFileName(
        window_, tr("Open"), startFolder(),
        tr("Documents and sketch scripts (*.edgewright *.json);;All files (*)"));
    if (!path.isEmpty()) openPath(path);
}

bool FileActions::openPath(const QString& path) {
    const QFileInfo info(path);
    // The person's own files are not kept where the program's are.
    if (!isShipped(path)) folder_ = info.absolutePath();
    const auto text = readFileBytes(path, kMaxDocumentBytes);
    if (!text) return report(fail(text.error()), {});
    const std::string name = info.fileName().toStdString();
    if (auto ok = refuseOtherKinds(name, *text); !ok) return report(ok, {});
    const FileKind kind = fileKind(*text);
    const bool script =
        kind == FileKind::Script || (kind == FileKind::Json && endsWith(path, kScriptEnding));
    const bool opened = script ? openScript(path, *text) : openDocument(path);
    if (opened) emit fileUsed(info.absoluteFilePath());
    return opened;
}

bool FileActions::openDocument(const QString& path) {
    // Asked before this window is one of those that have it open.
    const auto elsewhere =
        work_ == nullptr || QFileInfo(path) == QFileInfo(context_.document.filePath())
            ? std::nullopt
            : work_->folder().openElsewhere(path);
    const QString name = QFileInfo(path).fileName();
    Document& document = context_.document;
    auto opened = readWithProgress(document, path, window_);
    if (!opened && opened.error().code == Errc::Cancelled) {
        context_.messages.showNotice(tr("%1 was not opened.").arg(name));
        return false;
    }
    if (!opened) return report(fail(opened.error()), {});
    document.open(*std::move(opened));
    if (document.isReadOnly()) {
        return report({}, tr("%1 was written by a later version and may hold more than is shown "
                             "here; changes are saved under another name.")
                              .arg(name));
    }
    return report({}, elsewhere
                          ? tr("%1 is open in another window, too: %2.").arg(name, elsewhere->owner)
                          : QString());
}

void FileActions::lookAt(const QString& path, const QString& name) {
    context_.messages.clearNotice();
    if (!mayDiscard()) return;
    Document& document = context_.document;
    auto opened = readWithProgress(document, path, window_);
    if (!opened) {
        if (opened.error().code != Errc::Cancelled) report(fail(opened.error()), {});
        return;
    }
    opened->path.clear();
    opened->stamp.reset();
    // The title is asked for while it is opened.
    looked_ = {name, document.life() + 1};
    document.open(*std::move(opened));
    emit fileUsed({});
    report({}, tr("This is a pupil\u2019s work to look at. What is changed here can be saved under "
                  "another name; the pupil\u2019s file stays as it is."));
}

QString FileActions::untitledName() const {
    return looked_.life == context_.document.life() ? tr("%1 (read-only)").arg(looked_.name)
                                                    : tr("Untitled");
}

bool FileActions::openScript(const QString& path, const std::string& text) {
    const auto script = readSketchScript(text);
    const QFileInfo info(path);
    if (!script) {
        const std::string name = info.fileName().toStdString();
        return report(fail(script.error().code, name + ": " + script.error().message), {});
    }
    ReplayOptions options;
    options.leaveOutFiles = true;
    const ReplayReport result = replay(context_.document, *script, options);
    scriptName_ = info.completeBaseName();
    return tellReplay(result, *script);
}

bool FileActions::tellReplay(const ReplayReport& result, const SketchScript& script) {
    QStringList leftOut;
    for (const StepReport& step : result.steps) {
        if (!step.leftOut) continue;
        const auto file = fileOfStep(script.steps[static_cast<std::size_t>(step.index)]);
        leftOut << QStringLiteral("%1 (%2 %3)")
                       .arg(step.index)
                       .arg(stepText(step.name), QString::fromStdString(*file));
    }
    QString told;
    if (!leftOut.isEmpty()) {
        told = tr("Opening writes no file and opens no other; steps left out: %1.")
                   .arg(leftOut.join(QStringLiteral(", ")));
    }
    const StepReport* failed = result.firstFailure();
    if (failed == nullptr) return report({}, told);
    QString text = tr("Step %1 of the script (%2): %3")
                       .arg(failed->index)
                       .arg(stepText(failed->name), coreText(failed->error->message));
    if (!told.isEmpty()) text += ' ' + told;
    return report(fail(failed->error->code, text.toStdString()), {});
}

bool FileActions::save() {
    const QString path = context_.document.filePath();
    return path.isEmpty() || context_.document.isReadOnly() ? saveAs() : saveTo(path);
}

bool FileActions::saveAs() {
    const QString path =
        askWhereTo({tr("Save as"), tr("Edgewright document (*.edgewright)"), {kScriptEnding}});
    return !path.isEmpty() && saveTo(path);
}

void FileActions::saveCopy() {
    const QString path =
        askWhereTo({tr("Save a copy"), tr("Edgewright document (*.edgewright)"), {kScriptEnding}});
    if (path.isEmpty()) return;
    report(context_.document.saveCopy(path), tr("A copy was saved to %1.").arg(path));
}

void FileActions::revert() {
    context_.messages.clearNotice();
    const QString path = context_.document.filePath();
    const QString name = QFileInfo(path).fileName();
    if (!mayDo({tr("Revert to the saved file?"),
                tr("Everything that was done since %1 was saved is taken back.").arg(name),
                tr("Re&vert")})) {
        return;
    }
    if (openDocument(path)) context_.messages.showNotice(tr("Reverted to %1.").arg(name));
}

bool FileActions::saveTo(const QString& path) {
    Document& document = context_.document;
    if (QFileInfo(path) == QFileInfo(document.filePath()) && document.fileChangedByOthers() &&
        !mayReplace(tr("%1 was changed by another window or program since it was opened or "
                       "saved here. Replacing it loses these changes.")
                        .arg(QFileInfo(path).fileName()))) {
        context_.messages.showNotice(tr("Not saved; \u201cSave as\u201d keeps both."));
        return false;
    }
    if (work_ != nullptr) work_->takePicture();
    if (!report(document.save(path), {})) return false;
    emit fileUsed(document.filePath());
    return report({}, tr("Saved to %1.").arg(document.filePath()));
}

void FileActions::saveScript() {
    const QString path =
        askWhereTo({tr("Save what was done as a script"), tr("Sketch script (*.json)"), {}});
    if (!path.isEmpty()) saveScriptTo(path);
}

bool FileActions::saveScriptTo(const QString& path) {
    const std::string text = writeSketchScript(context_.document.recordedScript());
    return report(writeFileBytes(path, text), tr("Script saved to %1.").arg(path));
}

void FileActions::exportSolid() {
    const QString triangles = tr("Wavefront OBJ, triangles only (*.obj)");
    const QString polygons = tr("Wavefront OBJ, whole faces (*.obj)");
    const QString filters =
        tr("Wavefront OBJ (*.obj);;STL, binary (*.stl);;PLY (*.ply);;glTF, "
           "binary (*.glb);;3MF (*.3mf)");
    QString chosen;
    const QString path = askWhereTo(
        {tr("Export"), QStringList{filters, triangles, polygons}.join(QStringLiteral(";;")), {}},
        &chosen);
    if (path.isEmpty()) return;
    ExportOptions options(chosen == triangles  ? ExportFaces::Triangles
                          : chosen == polygons ? ExportFaces::Polygons
                                               : ExportFaces::Simple);
    if (askExport(path, options)) exportTo(path, options);
}

bool FileActions::askExport(const QString& path, ExportOptions& options) {
    const bool lacksUnit = formatLacksUnit(path.toStdString());
    ExportDialog::Questions questions;
    const std::vector<Body>& bodies = context_.document.state().bodies;
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        if (!bodies[b].hidden) questions.bodies << shownBodyName(bodies, b);
    }
    if (lacksUnit && !exportUnit_) questions.unit = ExportUnit::Millimetre;
    if (questions.unit || questions.bodies.size() > 1) {
        ExportDialog dialog(questions, window_);
        if (dialog.exec() != QDialog::Accepted) return false;
        if (questions.unit) exportUnit_ = dialog.unit();
        const std::vector<int> places = visibleBodies(bodies).second;
        for (const int chosen : dialog.bodies()) {
            options.bodies.push_back(places[static_cast<std::size_t>(chosen)]);
        }
    }
    if (lacksUnit) options.unit = *exportUnit_;
    return true;
}

void FileActions::askUnit() {
    ExportDialog::Questions questions;
    questions.exports = false;
    questions.unit = exportUnit_.value_or(ExportUnit::Millimetre);
    ExportDialog dialog(questions, window_);
    if (dialog.exec() == QDialog::Accepted) exportUnit_ = dialog.unit();
}

bool FileActions::exportTo(const QString& path, const ExportOptions& options) {
    const auto note = exportWithProgress(context_.document, path, options, window_);
    if (!note && note.error().code == Errc::Cancelled) {
        context_.messages.showNotice(tr("The export was given up; no file was written."));
        return false;
    }
    if (!note) return report(fail(note.error()), {});
    const QString done =
        formatLacksUnit(path.toStdString())
            ? tr("Exported to %1, lengths in %2.").arg(path, exportUnitText(options.unit))
            : tr("Exported to %1.").arg(path);
    return report({}, (done + ' ' + coreText(*note)).trimmed());
}

void FileActions::screenshot() {
    const QString path = askWhereTo({tr("Screenshot"), tr("PNG (*.png)"), {}});
    if (!path.isEmpty()) screenshotTo(path);
}

bool FileActions::screenshotTo(const QString& path) {
    const QImage image = context_.viewport.grabFramebuffer().convertToFormat(QImage::Format_RGB32);
    return report(writePicture(image, path), tr("Picture saved to %1.").arg(path));
}

}  // namespace ew
