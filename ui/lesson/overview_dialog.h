// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>
#include <functional>

#include "core/document/classroom/class_overview.h"

class QCheckBox;
class QLabel;
class QLineEdit;
class QPushButton;
class QSortFilterProxyModel;
class QTableView;

namespace ew {

class Appearance;
class OverviewModel;

/// What a teacher wants to know of a class, on one page: a row for each pupil, those who are stuck
/// first. It reads the class folder when it is opened and when it is asked to, and writes only what
/// is exported.
class OverviewDialog : public QDialog {
    Q_OBJECT

  public:
    OverviewDialog(Appearance& appearance, const QString& shippedLessons,
                   QWidget* parent = nullptr);

    /// Shows a class. Errors: those of readClass(); what is shown stays then.
    Result<void> show(const QString& folder);
    QString folder() const { return folder_; }
    /// Writes the page as CSV or HTML, by the name's ending (HTML where it has none of these).
    Result<void> exportTo(const QString& path);

  signals:
    /// A pupil's work is to be shown; it is hers, so nothing is to be written to it.
    void workWanted(const QString& path, const QString& name);

  private:
    void build();
    QWidget* buildHead();
    QWidget* buildFoot();
    void choose();
    void refresh();
    void exportPage();
    void showSummary();
    void showProblems();
    void fitColumns();
    void filter();
    void currentChanged();
    void openCurrent();
    void say(const QString& text, bool isProblem);

    Appearance& appearance_;
    QString shipped_;
    QString folder_;
    OverviewModel* model_;
    QSortFilterProxyModel* shown_;
    QLabel* title_ = nullptr;
    QLabel* summary_ = nullptr;
    QLineEdit* search_ = nullptr;
    QCheckBox* stuckOnly_ = nullptr;
    QTableView* table_ = nullptr;
    QLabel* problems_ = nullptr;
    QLabel* said_ = nullptr;
    QPushButton* open_ = nullptr;
    QPushButton* export_ = nullptr;
};

}  // namespace ew
