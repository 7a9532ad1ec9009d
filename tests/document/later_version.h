// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "core/document/store_schema.h"

namespace ew::test {

/// The document as a version with a later schema might have written it: with a table of its own,
/// and the word that it can be read as schema 2.
inline std::string ofLaterVersion(const std::string& bytes, const std::string& readableAs) {
    const Table pulls{"pull",
                      "CREATE TABLE pull(id INTEGER PRIMARY KEY, depth REAL NOT NULL, sum INTEGER "
                      "NOT NULL) STRICT",
                      2};
    std::vector<Table> tables(std::begin(schema::kTables), std::end(schema::kTables));
    tables.push_back(pulls);
    auto from = Database::overBytes(bytes, schema::kKind);
    auto to = Database::inMemory({schema::kApplicationId, 9, tables});
    EXPECT_TRUE(from && to);
    for (const Table& t : schema::kTables) {
        EXPECT_TRUE(from->each(t, [&](const Row& row) { return to->put(t, row); }));
    }
    EXPECT_TRUE(to->put(schema::kSetting, {std::string("readable_as"), readableAs}));
    EXPECT_TRUE(to->put(pulls, {std::int64_t{1}, 2.5}));
    return *to->bytes();
}

}  // namespace ew::test
