// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>
#include <cstdint>
#include <vector>

#include "core/document/practice/practice_log.h"

class QSpinBox;

namespace ew {

class Appearance;

/// Chooses an exercise, and shows how somebody gets on.
class PracticeDialog : public QDialog {
    Q_OBJECT

  public:
    struct Choice {
        int level = 1;
        std::uint32_t seed = 1;
    };

    PracticeDialog(Appearance& appearance, const std::vector<PracticeResult>& results,
                   const Choice& choice, QWidget* parent = nullptr);

    Choice choice() const;

  private:
    QSpinBox* level_;
    QSpinBox* seed_;
};

}  // namespace ew
