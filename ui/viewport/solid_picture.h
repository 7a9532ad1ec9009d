// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>
#include <QSize>

#include "core/base/camera.h"
#include "core/solid/polyhedron_spec.h"
#include "ui/theme/colours.h"

namespace ew {

/// A small picture of a polyhedron: flat-shaded faces, visible edges solid, hidden ones dashed,
/// fitted into the picture with a margin. Transparent where nothing is. Costs about a
/// millisecond at 120 x 90.
/// \param camera  gives the direction of view only.
QImage solidPicture(const PolyhedronSpec& spec, const Pose& pose, const OrthographicCamera& camera,
                    QSize logicalSize, double devicePixelRatio, const ThemeColours& colours);

/// The same through a camera as it is, whose viewport is the picture.
QImage solidView(const PolyhedronSpec& spec, const Pose& pose, const OrthographicCamera& camera,
                 double devicePixelRatio, const ThemeColours& colours);

}  // namespace ew
