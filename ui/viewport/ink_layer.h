// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QColor>
#include <QImage>
#include <QRect>
#include <QTransform>
#include <vector>

#include "core/document/document.h"
#include "ui/theme/colours.h"

class QPainter;

namespace ew {

/// How a stroke is drawn.
struct InkStyle {
    QColor colour;
    bool dropped = false;  ///< thin, faded and dashed
};

/// Draws a stroke: pressure is line weight and nothing else.
/// \param map         Sketch Plane px to px of the painter.
/// \param firstSample starts there (a stroke that grows is drawn piece by piece).
void paintStroke(QPainter& painter, const Stroke& stroke, const QTransform& map,
                 const InkStyle& style, std::size_t firstSample = 0);

/// Which pending strokes the reading does not use and says so: dots, scribbles, curves, and stray
/// lines once there is something to be stray from.
std::vector<bool> droppedStrokes(const Interpretation& reading, std::size_t strokeCount);

/// A picture with transparency that knows which part of it is used, so that only that part is
/// copied to the screen.
class Layer {
  public:
    void resize(const QSize& devicePixels, double devicePixelRatio);
    void clear();
    /// To draw on; touch() or touchContent() afterwards.
    QImage& image() { return image_; }
    /// \param area  logical px that were drawn on.
    void touch(const QRectF& area);
    /// The same for a cleared layer where it is not known what was drawn on: looks at the pixels.
    void touchContent();
    void paintOn(QPainter& painter) const;

  private:
    QImage image_;
    QRect used_;           // device px
    mutable QImage part_;  // the used part; null where it must be copied anew
};

/// The pending ink, kept as a picture that is only drawn anew when it must be: a new stroke is
/// added to what is there.
class InkLayer {
  public:
    void resize(const QSize& devicePixels, double devicePixelRatio);
    /// True where it looks different now.
    bool update(const std::vector<PendingStroke>& strokes, const std::vector<bool>& dropped,
                const OrthographicCamera& view, const ThemeColours& colours);
    void paintOn(QPainter& painter) const { layer_.paintOn(painter); }

  private:
    Layer layer_;
    std::vector<int> ids_;
    std::vector<bool> dropped_;
    OrthographicCamera view_;
    const ThemeColours* colours_ = nullptr;
    bool valid_ = false;
};

/// The stroke under way; grows by its new samples only.
class WetInkLayer {
  public:
    void resize(const QSize& devicePixels, double devicePixelRatio);
    /// \param stroke  null where there is none; view px.
    void update(const Stroke* stroke, const ThemeColours& colours);
    void paintOn(QPainter& painter) const { layer_.paintOn(painter); }

  private:
    Layer layer_;
    std::size_t painted_ = 0;
};

}  // namespace ew
