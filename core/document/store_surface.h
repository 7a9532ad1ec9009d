// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "core/document/surface_settings.h"

namespace ew {

/// Surface settings as JSON text; lists of edges are sparse: [edge, number] for what is set.
std::string surfaceText(const SurfaceSettings& settings);

/// Reads surfaceText's JSON for these bodies. Throws ReadError.
SurfaceSettings surfaceFromJson(const nlohmann::json& value, const std::string& place,
                                const std::vector<Body>& bodies);

}  // namespace ew
