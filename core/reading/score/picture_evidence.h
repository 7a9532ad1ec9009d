// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/base/camera.h"
#include "core/edge_graph/build.h"
#include "core/reading/types/reading_params.h"
#include "core/solid/solid.h"

namespace ew {

/// What a solid's picture, hidden lines removed, and the ink have in common, as lengths [px].
struct PictureEvidence {
    double inkPx = 0.0;          ///< all ink that is lines
    double strayPx = 0.0;        ///< ink along no edge that is seen, and along none that is hidden
    double hiddenPx = 0.0;       ///< ink along edges that are hidden
    double hiddenEdgesPx = 0.0;  ///< length of what is hidden of edges
    double detailPx = 0.0;       ///< that part of it which lies inside faces: a window, a label
    double slipPx = 0.0;         ///< the most of barePx that is one edge's
    double barePx = 0.0;         ///< visible edges without ink
    int hiddenFronts = 0;        ///< faces that look at the eye of which no edge is seen
    std::vector<int> beside;     ///< strokes of which less than half runs along an edge, and those
                                 ///< that are no lines; ascending

    /// What the solid cannot be drawn as, as a share of the ink: details may lie on any solid, and
    /// one line forgotten is a slip.
    double contradiction() const {
        return inkPx > 0.0 ? (strayPx - detailPx + barePx - slipPx) / inkPx : 1.0;
    }
    /// Are hidden edges drawn? Who draws some draws them all.
    bool showsHidden() const {
        return hiddenPx > 0.0 && hiddenPx > params::kHiddenDrawn * hiddenEdgesPx;
    }
    /// What does not agree, as a share of the ink.
    double residue() const { return inkPx > 0.0 ? (strayPx + barePx) / inkPx : 1.0; }
};

/// \param nearPx  how far from an edge ink may run that was drawn for it [px].
/// \param thinPx  an edge this near to ink is not missed: nobody draws both sides of a face that is
///                seen nearly edge-on [px]; nearPx at least.
/// Cost: that of SolidView, and O(ink samples + picture / 4 px).
PictureEvidence pictureEvidence(const InkReading& ink, const Solid& solid, const Pose& pose,
                                const OrthographicCamera& camera, double nearPx,
                                double thinPx = 0.0);

}  // namespace ew
