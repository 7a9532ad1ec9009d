// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>
#include <QStringList>
#include <optional>
#include <vector>

#include "core/document/export_options.h"

class QComboBox;
class QLabel;
class QListWidget;
class QPushButton;

namespace ew {

/// A unit as a person calls it, e.g. "millimetres (mm)".
QString exportUnitText(ExportUnit unit);

/// Asks what an export leaves open: the unit of a format that has none, and which bodies.
class ExportDialog : public QDialog {
    Q_OBJECT

  public:
    struct Questions {
        std::optional<ExportUnit> unit;  ///< proposed; not set: it is not asked for
        QStringList bodies = {};  ///< names of those that there are; asked for where several are
        bool exports = true;      ///< an export follows, not only a unit from now on
    };
    explicit ExportDialog(const Questions& questions, QWidget* parent = nullptr);

    ExportUnit unit() const;
    /// By index; empty: all.
    std::vector<int> bodies() const;

  private:
    QComboBox* unit_ = nullptr;
    QListWidget* bodies_ = nullptr;
    QPushButton* accept_ = nullptr;
};

}  // namespace ew
