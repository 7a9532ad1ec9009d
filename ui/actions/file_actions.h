// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <functional>

#include "ui/window_context.h"

class QAction;
class QMenu;
class QWidget;

namespace ew {

/// New, open, save, export, scripts and pictures.
class FileActions : public QObject {
    Q_OBJECT

  public:
    enum class Answer { Save, Discard, Cancel };

    FileActions(const WindowContext& context, QWidget* window);

    /// Fills the File menu. Examples are looked for when their menu opens.
    void fill(QMenu* menu);

    /// A document, or a sketch script (.json) that is replayed into an empty document. Says why in
    /// the message bar where it fails.
    bool openPath(const QString& path);
    bool saveTo(const QString& path);
    bool saveScriptTo(const QString& path);
    bool exportTo(const QString& path);
    bool screenshotTo(const QString& path);

    /// Asks about unsaved changes where there are any; false: do not go on.
    bool mayDiscard();
    /// How mayDiscard() asks; a message box unless set.
    void setQuestion(std::function<Answer()> question) { question_ = std::move(question); }

    QAction* newAction;
    QAction* openAction;
    QAction* saveAction;
    QAction* exportAction;

  private:
    void newDocument();
    void open();
    bool save();
    bool saveAs();
    void saveScript();
    void exportSolid();
    void screenshot();
    void fillExamples(QMenu* menu);
    bool openScript(const QString& path);
    void refresh();
    QString startFolder() const;
    bool report(const Result<void>& result, const QString& done);

    WindowContext context_;
    QWidget* window_;
    std::function<Answer()> question_;
    QString folder_;
};

}  // namespace ew
