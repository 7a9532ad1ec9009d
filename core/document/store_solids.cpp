// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/store_solids.h"

#include <algorithm>
#include <atomic>
#include <memory>
#include <thread>

namespace ew {
namespace {

Result<Solid> solidFromBlob(const PackedBlob& blob, bool whole) {
    const auto text = unpackBlob(blob);
    if (!text) return fail(text.error());
    if (whole) return Solid::deserialize(*text);
    return Solid::deferred(
        [kept = std::make_shared<const PackedBlob>(blob)] { return unpackBlob(*kept); });
}

}  // namespace

std::vector<Result<Solid>> solidsFromBlobs(std::span<const PackedBlob* const> blobs, bool whole,
                                           const ReadProgress& progress) {
    std::vector<Result<Solid>> read(blobs.size(), fail(Errc::Cancelled, "Opening was given up."));
    std::atomic<std::size_t> next = 0;
    std::atomic<bool> stop = false;
    const auto readOne = [&] {
        const std::size_t i = next++;
        if (i >= blobs.size() || stop) return false;
        read[i] = solidFromBlob(*blobs[i], whole);
        return true;
    };
    constexpr std::size_t kWorthAThread = 8;
    constexpr std::size_t kMostThreads = 8;
    const std::size_t processors =
        std::min<std::size_t>(kMostThreads, std::max(1U, std::thread::hardware_concurrency()));
    std::vector<std::jthread> helpers;
    while (helpers.size() + 1 < std::min(processors, blobs.size() / kWorthAThread)) {
        helpers.emplace_back([&] {
            while (readOne()) {
            }
        });
    }
    const auto goesOn = [&] {
        if (!progress || blobs.empty()) return true;
        const std::size_t begun = std::min<std::size_t>(next, blobs.size());
        return progress(static_cast<double>(begun) / static_cast<double>(blobs.size()));
    };
    do {
        stop = !goesOn();
    } while (readOne());
    return read;
}

}  // namespace ew
