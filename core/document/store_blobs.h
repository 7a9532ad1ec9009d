// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <utility>

#include "core/base/result.h"
#include "core/stroke/stroke.h"

namespace ew {

/// SHA-256, 32 bytes.
std::string contentHash(const std::string& content);

/// The content packed by zlib (with its size before it, as qCompress does) and true, or as it is
/// and false where that is no larger.
std::pair<std::string, bool> packBlob(const std::string& content);

/// A blob as it stands in a file.
struct PackedBlob {
    std::string sha;  ///< of the content
    std::string data;
    std::size_t size = 0;  ///< of the content, as the file tells it [bytes]
    bool packed = false;
};

/// Undoes packBlob. Errc::Damaged where it is no blob of this size or hash; no more memory is taken
/// than the size that was told, and that is checked against the bytes before.
Result<std::string> unpackBlob(const PackedBlob& blob);

/// The samples of a stroke: x, y, pressure, time of each as doubles, least byte first.
std::string samplesBlob(const Stroke& stroke);
/// Errc::Damaged where the number of bytes fits no samples; values are not checked.
Result<Stroke> strokeFromBlob(const std::string& blob);

}  // namespace ew
