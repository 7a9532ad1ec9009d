// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string_view>

#include "core/store/database.h"

namespace ew {

/// Check sum of the fields of a row (FNV-1a, 64 bits, over the table's name and each field with its
/// kind and length): another one for every change of a single byte.
std::int64_t rowSum(std::string_view table, const Row& row);

}  // namespace ew
