// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>
#include <QSize>
#include <vector>

#include "core/base/camera.h"
#include "core/document/derived_shape.h"
#include "ui/theme/colours.h"

namespace ew {

/// A small shaded picture of all bodies as they are outermost (surface, cage or solid), fitted into
/// the picture; edges are where the shading breaks off. Transparent where nothing is. Any thread.
/// Cost: one pass over the triangles; about a millisecond for 1,000 of them.
/// \param shape  of these bodies.
/// \param camera  gives the direction of view only.
QImage shapePicture(const std::vector<Body>& bodies, const DerivedShape& shape,
                    const OrthographicCamera& camera, QSize logicalSize, double devicePixelRatio,
                    const ThemeColours& colours);

}  // namespace ew
