// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QAbstractButton>
#include <QImage>

#include "core/reading/types/interpretation.h"

namespace ew {

class Appearance;

/// One candidate: its number, a picture from where the sketch was drawn, name, reading, how likely
/// it is, what speaks for it and what was assumed.
class CandidateCard : public QAbstractButton {
    Q_OBJECT

  public:
    CandidateCard(int index, Appearance& appearance, QWidget* parent = nullptr);

    void show(const Candidate& candidate, const OrthographicCamera& camera, bool clear);
    QSize sizeHint() const override { return {260, 100}; }
    QSize minimumSizeHint() const override { return {200, 100}; }

  signals:
    void doubleClicked();

  protected:
    void paintEvent(QPaintEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void enterEvent(QEnterEvent* event) override;
    void leaveEvent(QEvent* event) override;

  private:
    void redraw();

    int index_;
    Appearance& appearance_;
    Candidate candidate_;
    OrthographicCamera camera_;
    bool clear_ = false;
    bool hovered_ = false;
    QImage picture_;
};

/// "add", "cut" for people; empty for creating.
QString operationText(Operation operation);

/// What speaks for a reading and against it, in a few words: "explains all ink; 1 edge not drawn".
QString evidenceText(const Candidate& candidate);

}  // namespace ew
