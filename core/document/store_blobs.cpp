// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/store_blobs.h"

#include <QByteArray>
#include <QCryptographicHash>
#include <bit>
#include <cstdint>

namespace ew {

namespace {

constexpr int kPackLevel = 3;  // a solid packs to nearly as little as at 9, five times as fast
constexpr std::size_t kWorthPacking = 128;
// zlib never packs better than this.
constexpr std::size_t kMostPacked = 1100;
constexpr std::size_t kLargestBlob = std::size_t{256} << 20U;
constexpr std::size_t kDoubleBytes = 8;
constexpr std::size_t kSampleBytes = 4 * kDoubleBytes;

void append(std::string& out, double value) {
    auto bits = std::bit_cast<std::uint64_t>(value);
    for (std::size_t i = 0; i < kDoubleBytes; ++i, bits >>= 8U) {
        out += static_cast<char>(bits & 0xffU);
    }
}

double numberAt(const std::string& blob, std::size_t at) {
    std::uint64_t bits = 0;
    for (std::size_t i = kDoubleBytes; i-- > 0;) {
        bits = (bits << 8U) | static_cast<unsigned char>(blob[at + i]);
    }
    return std::bit_cast<double>(bits);
}

}  // namespace

std::string contentHash(const std::string& content) {
    QCryptographicHash hash(QCryptographicHash::Sha256);
    hash.addData(QByteArray::fromRawData(content.data(), static_cast<qsizetype>(content.size())));
    return hash.result().toStdString();
}

std::pair<std::string, bool> packBlob(const std::string& content) {
    if (content.size() < kWorthPacking || content.size() > kLargestBlob) return {content, false};
    const QByteArray packed = qCompress(reinterpret_cast<const uchar*>(content.data()),
                                        static_cast<qsizetype>(content.size()), kPackLevel);
    if (packed.isEmpty() || static_cast<std::size_t>(packed.size()) >= content.size()) {
        return {content, false};
    }
    return {packed.toStdString(), true};
}

Result<std::string> unpackBlob(const PackedBlob& blob) {
    const std::string& data = blob.data;
    const std::size_t size = blob.size;
    const auto damaged = [] { return fail(Errc::Damaged, "a blob does not fit its hash"); };
    std::string content;
    if (blob.packed) {
        constexpr std::size_t kHead = 4;
        if (data.size() < kHead || size > kLargestBlob || size / kMostPacked > data.size()) {
            return damaged();
        }
        std::size_t told = 0;
        for (std::size_t i = 0; i < kHead; ++i) {
            told = (told << 8U) | static_cast<unsigned char>(data[i]);
        }
        if (told != size) return damaged();
        content = qUncompress(reinterpret_cast<const uchar*>(data.data()),
                              static_cast<qsizetype>(data.size()))
                      .toStdString();
    } else {
        content = data;
    }
    if (content.size() != size || contentHash(content) != blob.sha) return damaged();
    return content;
}

std::string samplesBlob(const Stroke& stroke) {
    std::string out;
    out.reserve(stroke.samples.size() * kSampleBytes);
    for (const PenSample& s : stroke.samples) {
        for (const double x : {s.position.x(), s.position.y(), s.pressure, s.timeMs}) {
            append(out, x);
        }
    }
    return out;
}

Result<Stroke> strokeFromBlob(const std::string& blob) {
    if (blob.empty() || blob.size() % kSampleBytes != 0) {
        return fail(Errc::Damaged, "a stroke has no whole number of samples");
    }
    Stroke stroke;
    stroke.samples.reserve(blob.size() / kSampleBytes);
    for (std::size_t at = 0; at < blob.size(); at += kSampleBytes) {
        PenSample s;
        s.position = {numberAt(blob, at), numberAt(blob, at + kDoubleBytes)};
        s.pressure = numberAt(blob, at + 2 * kDoubleBytes);
        s.timeMs = numberAt(blob, at + 3 * kDoubleBytes);
        stroke.samples.push_back(s);
    }
    return stroke;
}

}  // namespace ew
