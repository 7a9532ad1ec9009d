// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

class QListWidget;

namespace ew {

class Document;

/// The named steps; a click goes back or forward to the state after that step.
class HistoryPanel : public QWidget {
    Q_OBJECT

  public:
    explicit HistoryPanel(Document& document, QWidget* parent = nullptr);

  private:
    void refresh();
    void goTo(int index);

    Document& document_;
    QListWidget* list_;
};

}  // namespace ew
