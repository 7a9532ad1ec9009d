// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

#include "core/document/document.h"

class QCheckBox;
class QComboBox;
class QDoubleSpinBox;
class QFormLayout;
class QLabel;
class QListWidget;
class QPushButton;
class QSlider;
class QSpinBox;
class QToolButton;
class QVBoxLayout;

namespace ew {

class SurfaceActions;
class SurfaceController;
class ToolBox;

/// Fillet, smooth surface and strokes on it, with their numbers. Dragging the radius shows what it
/// would be; letting go makes it a step.
class SurfacePanel : public QWidget {
    Q_OBJECT

  public:
    SurfacePanel(Document& document, SurfaceController& controller, SurfaceActions& actions,
                 ToolBox& tools, QWidget* parent = nullptr);

  private:
    QFormLayout* addGroup(const QString& title);
    /// Lets rows be narrower than their longest text.
    void keepNarrow();
    void buildFillet();
    void buildRadius(QFormLayout* form);
    void buildSurface();
    void buildCreases(QFormLayout* form);
    void buildStrokes();
    void connectSurface();

    void refresh();
    void refreshEdges();
    void refreshClamped();
    void refreshSurface();
    void refreshColor();
    void setRadius(double radius);
    void commitFillet();
    /// The settings as the widgets show them.
    SubdivisionSettings subdivision() const;
    void chooseColor();
    double largestRadius() const;

    Document& document_;
    SurfaceController& controller_;
    SurfaceActions& actions_;
    ToolBox& tools_;
    QVBoxLayout* groups_;

    QComboBox* which_ = nullptr;
    QComboBox* mode_ = nullptr;
    QLabel* count_ = nullptr;
    QSlider* radiusSlider_ = nullptr;
    QDoubleSpinBox* radius_ = nullptr;
    QSpinBox* segments_ = nullptr;
    QPushButton* fillet_ = nullptr;
    QPushButton* sharpen_ = nullptr;
    QListWidget* clamped_ = nullptr;

    QCheckBox* smooth_ = nullptr;
    QComboBox* scheme_ = nullptr;
    QComboBox* detail_ = nullptr;
    QSpinBox* levels_ = nullptr;
    QDoubleSpinBox* tolerance_ = nullptr;
    QDoubleSpinBox* otherEdges_ = nullptr;
    QDoubleSpinBox* chosenEdges_ = nullptr;
    QToolButton* setCrease_ = nullptr;
    QCheckBox* corners_ = nullptr;
    QCheckBox* cage_ = nullptr;
    QSpinBox* memory_ = nullptr;

    QToolButton* draw_ = nullptr;
    QPushButton* color_ = nullptr;
    bool refreshing_ = false;
};

}  // namespace ew
