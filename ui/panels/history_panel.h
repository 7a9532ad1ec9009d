// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "core/document/history_change.h"

class QListView;
class QPushButton;

namespace ew {

class Appearance;
class Document;
class HistoryModel;

/// The history with a picture of each state: a click goes there. States can be given a name, the
/// step that made one can be changed, and the history be compacted.
class HistoryPanel : public QWidget {
    Q_OBJECT

  public:
    HistoryPanel(Document& document, Appearance& appearance, QWidget* parent = nullptr);

    /// Asks for the name of a state and gives it to it.
    void nameState(int row);
    /// Asks how the step that made a state shall be, and does again what follows.
    void changeStep(int row);
    /// Does it without asking. Tells what no longer fits.
    void carryOut(const StepChange& change);
    /// Asks, and compacts.
    void compact();
    /// Can the step that made the state of a row be changed?
    bool canChange(int row) const;

  signals:
    void failed(const ew::Error& error);
    void noticed(const QString& text);

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    void refresh();
    void refreshButtons();
    void goTo(int row);
    void menuAt(const QPoint& place);
    void tell(const HistoryChange& change, int place);
    int currentRow() const;

    Document& document_;
    Appearance& appearance_;
    HistoryModel* model_;
    QListView* list_;
    QPushButton* name_;
    QPushButton* change_;
    QPushButton* takeBack_;
    bool refreshing_ = false;
};

}  // namespace ew
