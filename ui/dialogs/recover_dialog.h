// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>
#include <optional>
#include <set>
#include <vector>

#include "core/document/work_folder.h"

class QListWidget;
class QPushButton;

namespace ew {

/// Shows working copies, each with its picture, name, time and size, to open one of them or to put
/// some away.
class RecoverDialog : public QDialog {
    Q_OBJECT

  public:
    explicit RecoverDialog(const std::vector<WorkCopyEntry>& entries, QWidget* parent = nullptr);

    /// Index of the one to open, if any.
    std::optional<std::size_t> chosen() const { return chosen_; }
    /// Indices of those that nobody wants.
    const std::set<std::size_t>& declined() const { return declined_; }

  private:
    void open();
    void putAway();
    void refresh();

    QListWidget* list_;
    QPushButton* open_;
    QPushButton* putAway_;
    std::optional<std::size_t> chosen_;
    std::set<std::size_t> declined_;
};

}  // namespace ew
