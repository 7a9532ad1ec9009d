// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "core/base/camera.h"
#include "core/reading/evidence/sighting.h"
#include "core/reading/solve/rectilinear_fit.h"
#include "core/solid/polyhedron_spec.h"

namespace ew {

/// A solid in its own frame, with where that frame is in the world.
struct PlacedBody {
    PolyhedronSpec spec;  ///< [mm]
    Pose pose;
};

/// Enclosed volume [cubic units], negative where faces are the wrong side out.
double signedVolume(const PolyhedronSpec& spec);

/// A rectilinear template: axis-aligned in its frame, planes shared to the bit.
/// \param axes  camera-space vectors of the three axes [px], mutually perpendicular; vertex v is at
///              picture.origin + sum of positions times axes.
PlacedBody placeRectilinear(const Template& tmpl, const RectilinearStructure& r,
                            const AffinePicture& picture, const std::array<Vec3, 3>& axes,
                            const Sighting& sighting, const OrthographicCamera& camera);

/// Any other template: z along the normal of its first face, x along that face's first edge;
/// coordinates that differ by rounding only are made equal.
PlacedBody placeGeneral(const Template& tmpl, const CameraPoints& points, const Sighting& sighting,
                        const OrthographicCamera& camera);

}  // namespace ew
