// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QRectF>
#include <QTransform>

#include "core/reading/types/interpretation.h"
#include "ui/theme/colours.h"

class QPainter;

namespace ew {

/// What the overlay shows of a reading.
struct ReadingOverlay {
    const Interpretation* reading = nullptr;
    OrthographicCamera sketchCamera;  ///< whose px the reading speaks in
    OrthographicCamera viewCamera;    ///< through which it is seen
    Thresholds thresholds;
    int ghost = -1;         ///< candidate that is shown as a wireframe, -1 none
    bool criticise = true;  ///< culprits and missing edges too
};

/// Paints recognised edges and junctions, dropped pieces, culprits with their labels and the ghost
/// of a candidate. Quiet: thin lines, no fills.
/// \param bounds  px to stay in with labels.
void paintReading(QPainter& painter, const ReadingOverlay& overlay, const ThemeColours& colours,
                  const QRectF& bounds);

}  // namespace ew
