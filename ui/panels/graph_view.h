// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

namespace ew {

class Appearance;
class LiveReading;

/// The matched 2D Edge Graph as a live drawing: junctions with the template vertex that each
/// became, edges, dropped ink faded, culprits in the warning colour, missing edges dotted.
class GraphView : public QWidget {
    Q_OBJECT

  public:
    GraphView(LiveReading& reading, Appearance& appearance, QWidget* parent = nullptr);

    QSize sizeHint() const override { return {280, 200}; }
    QSize minimumSizeHint() const override { return {160, 120}; }

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    LiveReading& reading_;
    Appearance& appearance_;
};

}  // namespace ew
