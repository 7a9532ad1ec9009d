// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "core/document/document.h"

class QLabel;
class QListWidget;
class QListWidgetItem;
class QPushButton;

namespace ew {

class BodySelection;

/// The solids of the document: shown or hidden, named, chosen, moved, joined, deleted.
class BodyPanel : public QWidget {
    Q_OBJECT

  public:
    BodyPanel(Document& document, BodySelection& selection, QWidget* parent = nullptr);

    /// Adds the second chosen solid to the first, or cuts it out of it.
    void combine(BooleanKind kind);
    /// Asks how the chosen solid shall be moved, and does it.
    void move();
    void duplicate();
    void remove();

  signals:
    void failed(const ew::Error& error);

  private:
    void addButtons();
    void refresh();
    void refreshButtons();
    void refreshSize();
    void itemChanged(QListWidgetItem* item);
    void menuAt(const QPoint& place);
    void tell(const Result<void>& result);
    QPushButton* button(const QString& text, const QString& tip, void (BodyPanel::*deed)());

    Document& document_;
    BodySelection& selection_;
    QListWidget* list_;
    QLabel* size_;
    QPushButton* move_ = nullptr;
    QPushButton* duplicate_ = nullptr;
    QPushButton* join_ = nullptr;
    QPushButton* remove_ = nullptr;
    bool refreshing_ = false;
};

/// A body's name in the window's language.
QString shownBodyName(const std::vector<Body>& bodies, std::size_t body);

}  // namespace ew
