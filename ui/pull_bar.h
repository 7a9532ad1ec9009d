// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

class QCheckBox;
class QLabel;

namespace ew {

class NumberBox;
class PullController;

/// A line under the drawing while faces are pulled: by how much, and how the faces beside go on.
class PullBar : public QWidget {
    Q_OBJECT

  public:
    PullBar(PullController& pull, QWidget* parent = nullptr);

  private:
    void refresh();

    PullController& pull_;
    QLabel* hint_;
    NumberBox* distance_;
    QCheckBox* straight_;
    bool refreshing_ = false;
};

}  // namespace ew
