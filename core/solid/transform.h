// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/base/vec.h"
#include "core/solid/solid.h"

namespace ew {

/// The solid with every point p at linear * p + shift, exactly: faces stay planar, and what was
/// parallel stays so. A mirror image is turned the right side out. Vertices and faces keep their
/// order.
/// \param linear  no plane may become a line: its determinant is not 0.
/// Errors: BadValue (numbers that are not usable, a determinant of 0), and those of
/// Solid::fromSpec for a solid that gets too large, too small or too thin.
/// Cost: O(faces).
Result<Solid> transformed(const Solid& solid, const Mat3& linear, const Vec3& shift);

}  // namespace ew
