// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

class QLabel;
class QListWidget;

namespace ew {

class Appearance;
class Document;

/// T-LIB: the templates in use with a picture of the shape and what defines it.
class TemplatePanel : public QWidget {
    Q_OBJECT

  public:
    TemplatePanel(Document& document, Appearance& appearance, QWidget* parent = nullptr);

  signals:
    /// The template editor, with a template to begin with or with none.
    /// \param copy  a new template is to be made of it.
    void editorWanted(const QString& id, bool copy);

  private:
    void refresh();
    void describe();
    void showMenu(const QPoint& at);
    /// Does the document own the template, so that it can be changed?
    bool isOwn(const QString& id) const;

    Document& document_;
    Appearance& appearance_;
    QListWidget* list_;
    QLabel* text_;
};

}  // namespace ew
