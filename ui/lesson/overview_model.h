// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractTableModel>
#include <QPixmap>
#include <map>
#include <optional>

#include "core/document/classroom/class_overview.h"
#include "core/document/classroom/overview_text.h"

namespace ew {

/// The words of the window's language for what is told of a class.
OverviewWords windowWords();

/// A class as a table: a row for each pupil, a column for each lesson after those of the whole.
class OverviewModel : public QAbstractTableModel {
    Q_OBJECT

  public:
    enum Column { Name, Stuck, Steps, Stars, Time, Last, FirstLesson };
    enum Role { SortRole = Qt::UserRole, StuckRole, FinishedRole, TimeRole };

    using QAbstractTableModel::QAbstractTableModel;

    void setOverview(ClassOverview overview);
    const ClassOverview& overview() const { return overview_; }
    const ClassPupil& pupil(int row) const { return overview_.pupils[std::size_t(row)]; }
    /// Null for a column of the whole.
    const ClassLesson* lesson(int column) const;
    /// Null where it is not begun.
    const LessonProgress* progress(int row, int column) const;

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

  private:
    QVariant text(int row, int column) const;
    QVariant sortKey(int row, int column) const;
    QVariant picture(int row, int column) const;

    ClassOverview overview_;
    mutable std::map<std::pair<int, int>, QPixmap> pictures_;  ///< those that were looked at
};

}  // namespace ew
