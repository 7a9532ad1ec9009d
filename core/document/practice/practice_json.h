// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "core/document/practice/practice_log.h"

namespace ew {

/// What somebody practised as a list, and back.
nlohmann::ordered_json practiceJson(const std::vector<PracticeResult>& results);
/// Throws ReadError; messages begin with `place`.
std::vector<PracticeResult> practiceFromJson(const nlohmann::json& value, const std::string& place);

}  // namespace ew
