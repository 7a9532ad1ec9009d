// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "core/base/camera.h"
#include "core/hand/hand_model.h"
#include "core/tlib/library_index.h"

namespace ew {

/// A random body of a template, seen from a random side.
struct TemplateDrawing {
    PolyhedronSpec spec;  ///< world [mm], centred on the origin
    OrthographicCamera camera;
    std::vector<Line2> lines;  ///< its visible edges, whole [px]; ends that are one place are equal
};

/// The shape of the template with random proportions that obey its relations: planes of a
/// rectilinear one apart by random amounts, any other stretched along its axes as far as its
/// relations allow that. The view is one that a person could tell the shape by: tilt 15 to 65
/// degrees, two faces or more, lines and the distances of corners over the usual distance
/// threshold, 150 to 500 px across.
/// \return nothing where no such view is found in a bounded number of tries.
/// Deterministic in `random`. Cost: a few hidden-line views, each O(edges^2).
std::optional<TemplateDrawing> randomDrawing(const LibraryEntry& entry, Random& random);

}  // namespace ew
