// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTimer>
#include <QWidget>

class QLabel;
class QProgressBar;
class QPushButton;
class QTableWidget;

namespace ew {

class ConfusionRun;
class TemplateChecker;

/// What random drawings by a model of a hand are read as: a table with a row for the template and
/// for each that shares a view with it. Computed when somebody asks for it.
class ConfusionPage : public QWidget {
    Q_OBJECT

  public:
    ConfusionPage(ConfusionRun& run, TemplateChecker& checker, QWidget* parent = nullptr);

  private:
    void refresh();
    void fillTable();
    QString nameOf(const std::string& id) const;

    ConfusionRun& run_;
    TemplateChecker& checker_;
    QLabel* text_;
    QTableWidget* table_;
    QProgressBar* progress_;
    QPushButton* start_;
    QTimer look_;  ///< at how far it is
};

}  // namespace ew
