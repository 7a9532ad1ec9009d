// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/base/camera.h"
#include "core/stroke/stroke.h"

class QPainter;

namespace ew {

struct ThemeColours;

/// Strokes to trace.
struct Ghost {
    std::vector<Stroke> strokes;  ///< [Sketch Plane px of `camera`]
    OrthographicCamera camera;    ///< that they are to be drawn through
    double opacity = 0.5;         ///< 0..1
    double drawn = 0.0;           ///< 0..1: how far a pen that shows them has come
};

/// Paints the strokes as broad, faint lines, and over them what the pen has drawn.
void paintGhost(QPainter& painter, const Ghost& ghost, const OrthographicCamera& view,
                const ThemeColours& colours);

}  // namespace ew
