// SPDX-License-Identifier: GPL-3.0-or-later
// Private to core/document: brings no libzip with it.
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "core/base/result.h"

namespace ew {

struct ZipEntry {
    std::string name;  ///< with '/' between folders
    std::string content;
};

/// A zip archive of these files, in this order and all of one date, so that equal files make equal
/// archives. Errc::Internal.
Result<std::string> zipBytes(std::span<const ZipEntry> entries);

struct ZipLimits {
    std::size_t entries = 2'000;
    std::size_t bytesOfOne = std::size_t{1} << 20U;
    std::size_t bytesOfAll = std::size_t{64} << 20U;
};

/// The files of an archive; folders are left out. Nothing is written anywhere, and no more is
/// unpacked than the limits say, whatever the archive says of itself. Errors: Damaged (no archive,
/// cut off, changed), TooLarge, BadValue for a file with a name that could lead out of a folder,
/// for a link, for what is encrypted, and where a name comes twice.
Result<std::vector<ZipEntry>> readZip(const std::string& bytes, const ZipLimits& limits);

}  // namespace ew
