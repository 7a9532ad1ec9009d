// SPDX-License-Identifier: GPL-3.0-or-later
// Any bytes as what a document holds in blobs, past its check sums: packed bytes, the samples of a
// stroke, a solid. Refused or read; what was read is written and read back to the same bytes.
#include <cstdint>
#include <cstdlib>
#include <string>

#include "core/document/store_blobs.h"
#include "core/solid/solid.h"

namespace {

void unpack(const std::string& bytes) {
    constexpr std::size_t kMostBytes = 1 << 16;
    if (bytes.empty()) return;
    // What is told of the content may be untrue.
    const auto told = static_cast<unsigned char>(bytes.back()) * (kMostBytes / 255);
    if (ew::unpackBlob({ew::contentHash(bytes), bytes, told, true})) std::abort();  // a hash found
    const auto [data, packed] = ew::packBlob(bytes);
    const auto content = ew::unpackBlob({ew::contentHash(bytes), data, bytes.size(), packed});
    if (!content || *content != bytes) std::abort();
}

void readStroke(const std::string& bytes) {
    const auto stroke = ew::strokeFromBlob(bytes);
    if (stroke && ew::samplesBlob(*stroke) != bytes) std::abort();
}

void readSolid(const std::string& bytes) {
    const auto solid = ew::Solid::deserialize(bytes);
    if (!solid) return;
    const std::string written = solid->serialize();
    const auto again = ew::Solid::deserialize(written);
    if (!again || again->serialize() != written) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
    if (size == 0) return 0;
    const std::string bytes(reinterpret_cast<const char*>(data) + 1, size - 1);
    switch (data[0] % 3) {
        case 0:
            unpack(bytes);
            break;
        case 1:
            readStroke(bytes);
            break;
        default:
            readSolid(bytes);
    }
    return 0;
}
