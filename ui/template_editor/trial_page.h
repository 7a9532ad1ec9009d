// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <memory>
#include <vector>

#include "core/stroke/stroke.h"
#include "ui/input/pen_event.h"

class QLabel;
class QPushButton;

namespace ew {

class Appearance;
class CandidateCard;
class InputArbiter;
class TemplateModel;
class TrialReading;

/// Where one draws to try a template, with pen or mouse.
class TrialCanvas : public QWidget {
    Q_OBJECT

  public:
    TrialCanvas(TemplateModel& model, TrialReading& reading, Appearance& appearance,
                QWidget* parent = nullptr);
    ~TrialCanvas() override;

    QSize sizeHint() const override { return {420, 320}; }
    QSize minimumSizeHint() const override { return {240, 180}; }

  protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

  private:
    void point(const PenEvent& event);
    void endStroke();

    TemplateModel& model_;
    TrialReading& reading_;
    Appearance& appearance_;
    std::unique_ptr<InputArbiter> input_;
    Stroke wet_;  ///< under way
    double startMs_ = 0.0;
};

/// The canvas, what the drawing is read as, and the other readings.
class TrialPage : public QWidget {
    Q_OBJECT

  public:
    TrialPage(TemplateModel& model, TrialReading& reading, Appearance& appearance,
              QWidget* parent = nullptr);

    TrialCanvas& canvas() { return *canvas_; }
    QString verdict() const;

  private:
    void refresh();

    TemplateModel& model_;
    TrialReading& reading_;
    Appearance& appearance_;
    TrialCanvas* canvas_;
    QLabel* verdict_;
    QLabel* evidence_;
    QPushButton* clear_;
    std::vector<CandidateCard*> cards_;
};

}  // namespace ew
