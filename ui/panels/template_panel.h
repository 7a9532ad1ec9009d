// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

class QLabel;
class QListWidget;
class QPushButton;

namespace ew {

class Appearance;
class Document;

/// T-LIB: the templates in use with a picture of the shape and what defines it.
class TemplatePanel : public QWidget {
    Q_OBJECT

  public:
    TemplatePanel(Document& document, Appearance& appearance, QWidget* parent = nullptr);

  signals:
    void addSolidRequested();

  private:
    void refresh();
    void describe();

    Document& document_;
    Appearance& appearance_;
    QListWidget* list_;
    QLabel* text_;
    QPushButton* add_;
};

}  // namespace ew
