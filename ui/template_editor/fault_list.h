// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <vector>

#include "ui/template_editor/template_report.h"

class QVBoxLayout;

namespace ew {

/// What is wrong with a draft, one line each, with a button where it can be mended.
class FaultList : public QWidget {
    Q_OBJECT

  public:
    explicit FaultList(QWidget* parent = nullptr);

    void show(const std::vector<DraftFault>& faults);

  signals:
    void mendWanted(const ew::DraftFault& fault);

  private:
    void addLine(QVBoxLayout* lines, const DraftFault& fault);

    std::vector<DraftFault> faults_;
    QWidget* lines_ = nullptr;
};

}  // namespace ew
