// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <cstddef>
#include <functional>
#include <string>

#include "core/document/store_schema.h"

namespace ew::test {

/// The document with other fields in one of its rows, check sum and all.
inline std::string withRow(const std::string& bytes, const Table& table, std::size_t number,
                           const std::function<void(Row&)>& change) {
    auto from = Database::overBytes(bytes, schema::kKind);
    auto to = Database::inMemory(schema::kKind);
    EXPECT_TRUE(from && to);
    for (const Table& t : schema::kTables) {
        std::size_t i = 0;
        EXPECT_TRUE(from->each(t, [&](const Row& row) -> Result<void> {
            Row copy = row;
            if (t.name == table.name && i++ == number) change(copy);
            return to->put(t, copy);
        }));
    }
    return *to->bytes();
}

}  // namespace ew::test
