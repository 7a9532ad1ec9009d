// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>
#include <array>

#include "core/document/body_list.h"

class QCheckBox;
class QComboBox;

namespace ew {

class NumberBox;

/// Asks how a body shall be moved, turned, scaled or mirrored.
class MoveDialog : public QDialog {
    Q_OBJECT

  public:
    /// \param name  of the body.
    /// \param middle  of the body, in the world [mm]; what it is turned, scaled and mirrored about.
    MoveDialog(const QString& name, const Vec3& middle, QWidget* parent = nullptr);

    BodyMove move() const;

  private:
    NumberBox* number(double value, double least, double most, const QString& unit,
                      const QString& name);

    Vec3 middle_;
    std::array<NumberBox*, 3> by_{};
    QComboBox* axis_;
    NumberBox* degrees_;
    NumberBox* percent_;
    QComboBox* mirror_;
    QCheckBox* copy_;
};

}  // namespace ew
