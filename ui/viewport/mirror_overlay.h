// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "core/base/camera.h"
#include "core/solid/mirror.h"
#include "ui/theme/colours.h"

class QPainter;

namespace ew {

/// The four corners of the part of a mirror plane that is shown [world mm]: round the bodies that
/// are not hidden, else round the middle of the view.
std::array<Vec3, 4> mirrorOutline(const MirrorPlane& plane, const std::vector<Body>& bodies,
                                  const OrthographicCamera& view);

/// Paints the plane as a quiet outline.
void paintMirror(QPainter& painter, const MirrorPlane& plane, const std::vector<Body>& bodies,
                 const OrthographicCamera& view, const ThemeColours& colours);

}  // namespace ew
