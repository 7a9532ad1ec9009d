// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTimer>
#include <QWidget>
#include <vector>

class QCheckBox;
class QLabel;
class QPushButton;
class QSlider;
class QVBoxLayout;

namespace ew {

class Appearance;
class ApplyController;
class CandidateCard;
class Document;
class LiveReading;

/// The candidates as small 3D pictures to choose from, the depth of the oblique reading, the switch
/// for applying by itself, and the button that applies.
class CandidatePanel : public QWidget {
    Q_OBJECT

  public:
    CandidatePanel(Document& document, LiveReading& reading, ApplyController& apply,
                   Appearance& appearance, QWidget* parent = nullptr);

  private:
    void buildDepthRow();
    void refresh();
    void refreshCards();
    void refreshDepth();

    Document& document_;
    LiveReading& reading_;
    ApplyController& apply_;
    Appearance& appearance_;
    QLabel* heading_;
    QWidget* list_;
    QVBoxLayout* cardsLayout_;
    std::vector<CandidateCard*> cards_;
    QWidget* depthRow_;
    QSlider* depth_;
    QLabel* depthNumber_;
    QCheckBox* automatic_;
    QPushButton* applyButton_;
    QTimer throttle_;
};

}  // namespace ew
