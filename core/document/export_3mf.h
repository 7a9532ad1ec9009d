// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <string>

#include "core/document/export_gltf.h"

namespace ew {

/// The bytes of a 3MF file (core specification 1.3): a ZIP package with one model part in mm, an
/// object and a build item for each body. Points are shared and in double precision, so a closed
/// surface stays closed; the format has no normals. The same meshes give the same bytes.
/// \param origin  of these coordinates in the world [mm]: the build items put it back, and for a
/// body
///                that lies far from there by its own size, more.
/// Errors: those of checkMeshes; Internal where the package cannot be made.
Result<std::string> threeMfBytes(std::span<const TriangleMeshView> bodies,
                                 const Vec3& origin = Vec3::Zero());

}  // namespace ew
