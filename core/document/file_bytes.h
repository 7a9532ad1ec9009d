// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "core/base/result.h"

namespace ew {

/// The bytes of a file of at most `maxBytes`. Errc::FileNotFound (missing, no file, not readable),
/// Errc::TooLarge.
Result<std::string> readFileBytes(const QString& path, std::size_t maxBytes);

/// Writes a file whole or not at all; everything that the program writes goes through here. The
/// bytes are written beside the target, are on the disk, and only then take its place: where that
/// fails (a full disk, say), what was there is still there. What stands at the target is respected:
/// a symbolic link is followed, also one to a file that is not there yet; permissions, owner, group
/// and extended attributes stay; a file with several names (hard links), or one whose owner
/// cannot be kept, is written in place, after room was made sure of; into a pipe or a device the
/// bytes are just written. Errc::CannotWrite with a sentence that says why.
Result<void> writeFileBytes(const QString& path, std::string_view bytes);

/// Which file stands at a path and when it was last written: two stamps differ where another file
/// took its place or something was written into it.
struct FileStamp {
    std::array<std::uint64_t, 2> file{};    ///< device and number on it
    std::int64_t bytes = 0;                 ///< size
    std::array<std::int64_t, 2> changed{};  ///< last writing [s, ns]
    bool operator==(const FileStamp&) const = default;
};

/// Nothing where there is no file.
std::optional<FileStamp> fileStamp(const QString& path);

}  // namespace ew
