// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/actions/file_actions.h"

#include <QAction>
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QMenu>
#include <QMessageBox>
#include <QPushButton>
#include <QSaveFile>
#include <QStandardPaths>

#include "core/document/replay.h"
#include "core/document/resources.h"
#include "core/document/sketch_script.h"
#include "ui/core_text.h"
#include "ui/panels/message_bar.h"
#include "ui/theme/themed_icon.h"
#include "ui/viewport/viewport_widget.h"

namespace ew {

namespace {

constexpr qint64 kMostScriptBytes = qint64{64} << 20;

Result<QByteArray> readAll(const QString& path) {
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly)) {
        return fail(Errc::FileNotFound, "The file " + path.toStdString() + " cannot be read: " +
                                            file.errorString().toStdString() + ".");
    }
    if (file.size() > kMostScriptBytes) {
        return fail(Errc::TooLarge, "The script " + path.toStdString() + " is larger than 64 MiB.");
    }
    return file.readAll();
}

Result<void> writeAll(const QString& path, const QByteArray& bytes) {
    QSaveFile file(path);
    if (!file.open(QIODevice::WriteOnly) || file.write(bytes) != bytes.size() || !file.commit()) {
        return fail(Errc::CannotWrite, "The file " + path.toStdString() + " cannot be written: " +
                                           file.errorString().toStdString() + ".");
    }
    return {};
}

QString withExtension(QString path, const QString& extension) {
    if (!path.isEmpty() && QFileInfo(path).suffix().isEmpty()) path += extension;
    return path;
}

}  // namespace

FileActions::FileActions(const WindowContext& context, QWidget* window)
    : QObject(window),
      newAction(new QAction(themedIcon("document-new"), tr("&New"), this)),
      openAction(new QAction(themedIcon("document-open"), tr("&Open\u2026"), this)),
      saveAction(new QAction(themedIcon("document-save"), tr("&Save"), this)),
      exportAction(new QAction(themedIcon("export"), tr("&Export\u2026"), this)),
      context_(context),
      window_(window),
      folder_(QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation)) {
    newAction->setShortcut(QKeySequence::New);
    openAction->setShortcut(QKeySequence::Open);
    saveAction->setShortcut(QKeySequence::Save);
    exportAction->setShortcut(QKeySequence(QStringLiteral("Ctrl+E")));
    newAction->setToolTip(tr("New document"));
    openAction->setToolTip(tr("Open a document or a sketch script"));
    saveAction->setToolTip(tr("Save the document"));
    exportAction->setToolTip(tr("Export the surface, cage or solid as OBJ, STL, PLY, glTF or 3MF"));
    connect(newAction, &QAction::triggered, this, &FileActions::newDocument);
    connect(openAction, &QAction::triggered, this, &FileActions::open);
    connect(saveAction, &QAction::triggered, this, &FileActions::save);
    connect(exportAction, &QAction::triggered, this, &FileActions::exportSolid);
    connect(&context_.document, &Document::changed, this, [this](DocumentChange what) {
        if (what == DocumentChange::Bodies) refresh();
    });
    question_ = [this] {
        QMessageBox box(QMessageBox::Question, tr("Unsaved changes"),
                        tr("Save the changes to this document?"),
                        QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, window_);
        box.setInformativeText(tr("They are lost otherwise."));
        box.setDefaultButton(QMessageBox::Save);
        switch (box.exec()) {
            case QMessageBox::Save:
                return Answer::Save;
            case QMessageBox::Discard:
                return Answer::Discard;
            default:
                return Answer::Cancel;
        }
    };
    refresh();
}

void FileActions::fill(QMenu* menu) {
    menu->addAction(newAction);
    menu->addAction(openAction);
    QMenu* examples = menu->addMenu(tr("Open e&xample"));
    connect(examples, &QMenu::aboutToShow, this, [this, examples] { fillExamples(examples); });
    menu->addSeparator();
    menu->addAction(saveAction);
    QAction* as = menu->addAction(tr("Save &as\u2026"), this, &FileActions::saveAs);
    as->setShortcut(QKeySequence::SaveAs);
    menu->addAction(tr("Save what was done as a s&cript\u2026"), this, &FileActions::saveScript);
    menu->addSeparator();
    menu->addAction(exportAction);
    menu->addAction(tr("S&creenshot\u2026"), this, &FileActions::screenshot);
    menu->addSeparator();
    QAction* quit = menu->addAction(tr("&Quit"), window_, &QWidget::close);
    quit->setShortcut(QKeySequence::Quit);
}

void FileActions::fillExamples(QMenu* menu) {
    menu->clear();
    const auto resources = resourcesFolder();
    const QDir folder((resources ? *resources : QString()) + QStringLiteral("/examples"));
    for (const QFileInfo& file : folder.entryInfoList({"*.json"}, QDir::Files, QDir::Name)) {
        QString title = file.completeBaseName();
        if (const auto bytes = readAll(file.filePath())) {
            const auto script = readSketchScript(bytes->toStdString());
            if (script && !script->title.empty()) title = coreText(script->title);
        }
        menu->addAction(title, this, [this, path = file.filePath()] {
            if (mayDiscard()) openPath(path);
        });
    }
    if (menu->isEmpty()) menu->addAction(tr("There are no examples"))->setEnabled(false);
}

void FileActions::refresh() { exportAction->setEnabled(!context_.document.state().bodies.empty()); }

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
    if (!mayDiscard()) return;
    context_.document.reset();
}

void FileActions::open() {
    if (!mayDiscard()) return;
    const QString path = QFileDialog::getOpenFileName(
        window_, tr("Open"), startFolder(),
        tr("Documents and sketch scripts (*.edgewright *.json);;All files (*)"));
    if (!path.isEmpty()) openPath(path);
}

bool FileActions::openPath(const QString& path) {
    folder_ = QFileInfo(path).absolutePath();
    if (QFileInfo(path).suffix().compare(QLatin1String("json"), Qt::CaseInsensitive) == 0) {
        return openScript(path);
    }
    return report(context_.document.open(path), {});
}

bool FileActions::openScript(const QString& path) {
    const auto bytes = readAll(path);
    if (!bytes) return report(fail(bytes.error()), {});
    const auto script = readSketchScript(bytes->toStdString());
    if (!script) return report(fail(script.error()), {});
    ReplayOptions options;
    options.scriptFolder = QFileInfo(path).absolutePath();
    options.outFolder = options.scriptFolder;
    const ReplayReport result = replay(context_.document, *script, options);
    if (const StepReport* failed = result.firstFailure()) {
        const QString text =
            tr("Step %1 of the script (%2): %3")
                .arg(failed->index)
                .arg(QString::fromStdString(failed->name), coreText(failed->error->message));
        context_.messages.showError({failed->error->code, text.toStdString(), {}});
        return false;
    }
    return true;
}

bool FileActions::save() {
    const QString path = context_.document.filePath();
    return path.isEmpty() ? saveAs() : saveTo(path);
}

bool FileActions::saveAs() {
    const QString path =
        withExtension(QFileDialog::getSaveFileName(window_, tr("Save as"), startFolder(),
                                                   tr("Edgewright document (*.edgewright)")),
                      QStringLiteral(".edgewright"));
    return !path.isEmpty() && saveTo(path);
}

bool FileActions::saveTo(const QString& path) {
    return report(context_.document.save(path), tr("Saved to %1.").arg(path));
}

void FileActions::saveScript() {
    const QString path =
        withExtension(QFileDialog::getSaveFileName(window_, tr("Save what was done as a script"),
                                                   startFolder(), tr("Sketch script (*.json)")),
                      QStringLiteral(".json"));
    if (!path.isEmpty()) saveScriptTo(path);
}

bool FileActions::saveScriptTo(const QString& path) {
    const std::string text = writeSketchScript(context_.document.recordedScript());
    return report(writeAll(path, QByteArray::fromStdString(text)),
                  tr("Script saved to %1.").arg(path));
}

void FileActions::exportSolid() {
    QString filter;
    QString path = QFileDialog::getSaveFileName(
        window_, tr("Export"), startFolder(),
        tr("Wavefront OBJ (*.obj);;STL, binary (*.stl);;PLY (*.ply);;glTF, binary (*.glb);;"
           "3MF (*.3mf)"),
        &filter);
    if (path.isEmpty()) return;
    // "STL, binary (*.stl)" names its extension.
    const auto dot = filter.indexOf(QStringLiteral("(*.")) + 2;
    exportTo(withExtension(path, filter.mid(dot, filter.indexOf(QLatin1Char(')')) - dot)));
}

bool FileActions::exportTo(const QString& path) {
    return report(context_.document.exportTo(path), tr("Exported to %1.").arg(path));
}

void FileActions::screenshot() {
    const QString path = withExtension(
        QFileDialog::getSaveFileName(window_, tr("Screenshot"), startFolder(), tr("PNG (*.png)")),
        QStringLiteral(".png"));
    if (!path.isEmpty()) screenshotTo(path);
}

bool FileActions::screenshotTo(const QString& path) {
    const QImage image = context_.viewport.grabFramebuffer().convertToFormat(QImage::Format_RGB32);
    QSaveFile file(path);
    if (!file.open(QIODevice::WriteOnly) || !image.save(&file, "PNG") || !file.commit()) {
        return report(fail(Errc::CannotWrite,
                           "The picture " + path.toStdString() +
                               " cannot be written: " + file.errorString().toStdString() + "."),
                      {});
    }
    return report({}, tr("Picture saved to %1.").arg(path));
}

}  // namespace ew
