// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

class QCheckBox;
class QDoubleSpinBox;
class QPushButton;
class QSlider;

namespace ew {

class Document;

/// The two thresholds of the paper. Pending strokes are read anew at once.
class ThresholdPanel : public QWidget {
    Q_OBJECT

  public:
    explicit ThresholdPanel(Document& document, QWidget* parent = nullptr);

  private:
    struct Row {
        QSlider* slider = nullptr;
        QDoubleSpinBox* number = nullptr;
    };
    Row addRow(int row, const QString& name, const QString& unit, const QString& explanation);
    void write();
    void refresh();

    Document& document_;
    Row distance_;
    Row angle_;
    QCheckBox* automatic_;  ///< the distance threshold follows the drawing
    QPushButton* reset_;
    bool refreshing_ = false;
};

}  // namespace ew
