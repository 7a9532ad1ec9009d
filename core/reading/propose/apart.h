// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <optional>

#include "core/edge_graph/build.h"
#include "core/reading/types/interpretation.h"

namespace ew {

/// Several drawings beside each other, none inside another one, each read as it would be alone:
/// bodies of one candidate. Where they have an axis in common that is upright in the picture they
/// stand on one ground; else each has its nearest corner in the Sketch Plane.
/// \param read  reads the ink of one drawing.
/// \return nothing where there is one drawing only, or where one of them is not taken by itself.
std::optional<Interpretation> readApart(
    const InkReading& ink, const InterpretOptions& options,
    const std::function<Interpretation(const InkReading&)>& read);

}  // namespace ew
