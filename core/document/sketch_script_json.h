// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>

#include "core/document/sketch_script.h"

namespace ew {

/// readSketchScript on a parsed tree, for scripts inside native documents. Throws ReadError.
SketchScript scriptFromJson(const nlohmann::json& value);

/// One step as a JSON object on one line, and back. Reading throws ReadError; messages begin with
/// the step's number.
std::string stepJson(const ScriptStep& step);
ScriptStep stepFromJson(const nlohmann::json& value, std::size_t index);

/// Direction, up, center and world_per_pixel in plausible ranges. Throws ReadError (BadValue).
CameraStep cameraFromJson(const nlohmann::json& value, const std::string& place);

/// Both keys optional, each in its range. Throws ReadError (BadValue).
ThresholdsStep thresholdsFromJson(const nlohmann::json& value, const std::string& place);

/// Throws ReadError (WrongType).
bool boolFromJson(const nlohmann::json& value, const std::string& place);

/// Range of ApplyStep::obliqueFactor. Throws ReadError (BadValue).
double obliqueFactorFromJson(const nlohmann::json& value, const std::string& place);

/// The members that are set, as `"direction": [...], ...` without braces.
std::string cameraJson(const CameraStep& camera);

}  // namespace ew
