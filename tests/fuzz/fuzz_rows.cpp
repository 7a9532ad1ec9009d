// SPDX-License-Identifier: GPL-3.0-or-later
// A document whose rows are changed, with check sums and hashes that fit: what a file says that was
// made to deceive. Bytes alone (fuzz_document) hardly ever get past the sums.
#include <fuzzer/FuzzedDataProvider.h>

#include <cstdint>
#include <cstdlib>
#include <map>
#include <string>

#include "core/document/store.h"
#include "core/document/store_blobs.h"
#include "core/document/store_reader.h"
#include "core/document/store_schema.h"

namespace {

using Rows = std::vector<std::pair<const ew::Table*, ew::Row>>;

const ew::TemplateLibrary& shipped() {
    static const ew::TemplateLibrary library = [] {
        const auto load = ew::loadLibrary(EDGEWRIGHT_SOURCE_DIR "/resources/templates");
        if (!load) std::abort();
        return load->library;
    }();
    return library;
}

/// The rows of a document that has a bit of everything (tests/data), converted to schema 2.
const Rows& seedRows() {
    static const Rows rows = [] {
        const auto file =
            ew::loadDocument(EDGEWRIGHT_SOURCE_DIR "/tests/data/small.edgewright", shipped());
        if (!file) std::abort();
        auto bytes = ew::writeDocument(*file);
        auto database = ew::Database::overBytes(*std::move(bytes), ew::schema::kKind);
        if (!database) std::abort();
        Rows out;
        for (const ew::Table& table : ew::schema::kTables) {
            const auto ok = database->each(table, [&](const ew::Row& row) -> ew::Result<void> {
                out.emplace_back(&table, row);
                return {};
            });
            if (!ok) std::abort();
        }
        return out;
    }();
    return rows;
}

std::string mutated(std::string text, FuzzedDataProvider& data) {
    const auto at = data.ConsumeIntegralInRange<std::size_t>(0, text.size());
    const auto drop = data.ConsumeIntegralInRange<std::size_t>(0, 16);
    return text.replace(at, drop, data.ConsumeRandomLengthString(64));
}

void change(ew::Field& field, FuzzedDataProvider& data) {
    if (auto* n = std::get_if<std::int64_t>(&field)) {
        *n = data.ConsumeBool() ? data.ConsumeIntegralInRange<std::int64_t>(-2, 40)
                                : data.ConsumeIntegral<std::int64_t>();
    } else if (auto* x = std::get_if<double>(&field)) {
        const double value = data.ConsumeFloatingPoint<double>();
        if (value == value) *x = value;
    } else if (auto* text = std::get_if<std::string>(&field)) {
        *text = mutated(std::move(*text), data);
    } else if (auto* bytes = std::get_if<ew::Bytes>(&field)) {
        bytes->data = mutated(std::move(bytes->data), data);
    } else {
        field = data.ConsumeIntegralInRange<std::int64_t>(-2, 40);
    }
}

/// A blob with other content, packed and hashed as it should be.
void changeBlob(ew::Row& row, FuzzedDataProvider& data) {
    constexpr std::size_t kSha = 1, kSize = 2, kPacked = 3, kData = 4;
    const auto content =
        ew::unpackBlob({std::get<ew::Bytes>(row[kSha]).data, std::get<ew::Bytes>(row[kData]).data,
                        static_cast<std::size_t>(std::get<std::int64_t>(row[kSize])),
                        row[kPacked] == ew::Field(std::int64_t{1})});
    if (!content) return;
    const std::string other = mutated(*content, data);
    const auto [packed, isPacked] = ew::packBlob(other);
    row[kSha] = ew::Bytes{ew::contentHash(other)};
    row[kSize] = static_cast<std::int64_t>(other.size());
    row[kPacked] = std::int64_t{isPacked ? 1 : 0};
    row[kData] = ew::Bytes{packed};
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    FuzzedDataProvider data(bytes, size);
    Rows rows = seedRows();
    constexpr int kMostChanges = 4;
    for (int i = data.ConsumeIntegralInRange(1, kMostChanges); i > 0; --i) {
        auto& [table, row] = rows[data.ConsumeIntegralInRange<std::size_t>(0, rows.size() - 1)];
        if (table->name == ew::schema::kBlob.name && data.ConsumeBool())
            changeBlob(row, data);
        else
            change(row[data.ConsumeIntegralInRange<std::size_t>(0, row.size() - 1)], data);
    }
    auto database = ew::Database::inMemory(ew::schema::kKind);
    if (!database) std::abort();
    for (const auto& [table, row] : rows) {
        if (!database->put(*table, row)) return 0;  // a key twice, or of a wrong kind
    }
    const auto file = ew::readDatabase(*database, shipped());
    if (!file) return 0;
    const auto written = ew::writeDocument(*file);
    if (!written) std::abort();
    const auto again = ew::readDocument(*written, shipped());
    if (!again || *ew::writeDocument(*again) != *written) std::abort();
    return 0;
}
