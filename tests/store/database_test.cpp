// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/store/database.h"

#include <gtest/gtest.h>
#include <sqlite3.h>

#include <filesystem>
#include <random>

namespace ew {
namespace {

constexpr Table kThing{"thing",
                       "CREATE TABLE thing(id INTEGER PRIMARY KEY, name TEXT, weight REAL, data "
                       "BLOB, sum INTEGER NOT NULL) STRICT",
                       4};
constexpr Table kPair{"pair",
                      "CREATE TABLE pair(a INTEGER NOT NULL, b INTEGER NOT NULL, sum INTEGER NOT "
                      "NULL, PRIMARY KEY(a, b)) STRICT, WITHOUT ROWID",
                      2, 2};
constexpr Table kTables[] = {kThing, kPair};
constexpr DatabaseKind kKind{0x1234, 7, kTables};

Row thing(std::int64_t id) {
    return {id, "thing " + std::to_string(id), 0.1 * static_cast<double>(id),
            Bytes{std::string(static_cast<std::size_t>(id % 50), '\0')}};
}

Database filled(int rows) {
    auto db = Database::inMemory(kKind);
    EXPECT_TRUE(db && db->begin());
    for (int i = 0; i < rows; ++i) EXPECT_TRUE(db->put(kThing, thing(i)));
    EXPECT_TRUE(db->put(kPair, {std::int64_t{1}, std::int64_t{2}}));
    EXPECT_TRUE(db->commit());
    return *std::move(db);
}

std::vector<Row> rowsOf(Database& db, const Table& table) {
    std::vector<Row> rows;
    const auto ok = db.each(table, [&](const Row& row) -> Result<void> {
        rows.push_back(row);
        return {};
    });
    EXPECT_TRUE(ok) << ok.error().message;
    return rows;
}

/// What SQLite makes of these statements, as the bytes of a file.
std::string made(const std::string& sql, const std::string& start = {}) {
    sqlite3* db = nullptr;
    EXPECT_EQ(sqlite3_open(":memory:", &db), SQLITE_OK);
    if (!start.empty()) {
        auto* copy = static_cast<unsigned char*>(sqlite3_malloc64(start.size()));
        std::copy(start.begin(), start.end(), copy);
        const auto size = static_cast<sqlite3_int64>(start.size());
        sqlite3_deserialize(db, "main", copy, size, size,
                            SQLITE_DESERIALIZE_FREEONCLOSE | SQLITE_DESERIALIZE_RESIZEABLE);
    }
    char* problem = nullptr;
    EXPECT_EQ(sqlite3_exec(db, sql.c_str(), nullptr, nullptr, &problem), SQLITE_OK) << problem;
    sqlite3_free(problem);
    sqlite3_int64 size = 0;
    unsigned char* data = sqlite3_serialize(db, "main", &size, 0);
    std::string bytes(reinterpret_cast<char*>(data), static_cast<std::size_t>(size));
    sqlite3_free(data);
    sqlite3_close(db);
    return bytes;
}

Errc errorOf(const std::string& bytes) {
    auto db = Database::overBytes(bytes, kKind);
    return db ? Errc::Internal : db.error().code;
}

TEST(Database, GivesBackWhatWasPutIn) {
    Database db = filled(200);
    const auto bytes = db.bytes();
    ASSERT_TRUE(bytes);
    auto again = Database::overBytes(*bytes, kKind);
    ASSERT_TRUE(again) << again.error().message;
    const std::vector<Row> rows = rowsOf(*again, kThing);
    ASSERT_EQ(rows.size(), 200U);
    for (int i = 0; i < 200; ++i) EXPECT_EQ(rows[static_cast<std::size_t>(i)], thing(i));
    EXPECT_EQ(rowsOf(*again, kPair).size(), 1U);
    EXPECT_FALSE(again->put(kThing, thing(999))) << "what is over bytes is read only";
}

TEST(Database, RemovesAndReplacesByKey) {
    Database db = filled(3);
    ASSERT_TRUE(db.put(kThing, {std::int64_t{1}, "other", Field(), Field()}));
    ASSERT_TRUE(db.remove(kThing, {std::int64_t{2}}));
    ASSERT_TRUE(db.put(kPair, {std::int64_t{1}, std::int64_t{1}}));
    ASSERT_TRUE(db.remove(kPair, {std::int64_t{1}, std::int64_t{2}}));
    const std::vector<Row> rows = rowsOf(db, kThing);
    ASSERT_EQ(rows.size(), 2U);
    EXPECT_EQ(rows[1][1], Field(std::string("other")));
    EXPECT_EQ(rowsOf(db, kPair), (std::vector<Row>{{std::int64_t{1}, std::int64_t{1}}}));
}

TEST(Database, WhatIsNotCommittedIsTakenBack) {
    Database db = filled(3);
    ASSERT_TRUE(db.begin());
    ASSERT_TRUE(db.put(kThing, thing(7)));
    db.rollback();
    EXPECT_EQ(rowsOf(db, kThing).size(), 3U);
}

TEST(Database, NoChangedByteIsTakenForWhatWasStored) {
    Database db = filled(120);
    const std::string whole = *db.bytes();
    const std::vector<Row> things = rowsOf(db, kThing);
    const std::vector<Row> pairs = rowsOf(db, kPair);
    std::mt19937 random(1);
    int refused = 0;
    for (int i = 0; i < 3000; ++i) {
        std::string bytes = whole;
        bytes[random() % bytes.size()] ^= static_cast<char>(1U << (random() % 8U));
        auto read = Database::overBytes(bytes, kKind);
        std::vector<Row> rows;
        const auto take = [&](const Row& row) -> Result<void> {
            rows.push_back(row);
            return {};
        };
        const bool ok = read && read->each(kThing, take);
        if (!ok) {
            ++refused;
            continue;
        }
        // Whoever reads knows how many rows there were.
        if (rows.size() == things.size()) {
            EXPECT_EQ(rows, things);
        }
    }
    EXPECT_GT(refused, 1000);
}

TEST(Database, RefusesWhatIsCut) {
    Database db = filled(300);
    const std::string whole = *db.bytes();
    for (std::size_t n = 0; n < whole.size(); n += 97) {
        EXPECT_NE(errorOf(whole.substr(0, n)), Errc::Internal) << n;
    }
}

TEST(Database, TrustsNothingThatAFileBrings) {
    Database db = filled(3);
    const std::string whole = *db.bytes();
    const auto with = [&](const std::string& sql) { return errorOf(made(sql, whole)); };
    EXPECT_EQ(with("CREATE TRIGGER t AFTER INSERT ON thing BEGIN DELETE FROM pair; END"),
              Errc::Damaged);
    EXPECT_EQ(with("CREATE VIEW v AS SELECT * FROM thing"), Errc::Damaged);
    EXPECT_EQ(with("CREATE TABLE more(x)"), Errc::Damaged);
    EXPECT_EQ(with("CREATE INDEX i ON thing(name)"), Errc::Damaged);
    EXPECT_EQ(with("DROP TABLE pair"), Errc::Damaged);
    EXPECT_EQ(with("DROP TABLE pair; CREATE VIEW pair AS SELECT id AS a, id AS b, 0 FROM thing"),
              Errc::Damaged);
    EXPECT_EQ(with("PRAGMA user_version=8"), Errc::WrongVersion);
    EXPECT_EQ(with("PRAGMA application_id=1"), Errc::WrongFormat);
    EXPECT_EQ(errorOf(made("CREATE TABLE x(y)")), Errc::WrongFormat);
    EXPECT_EQ(errorOf("no database at all"), Errc::WrongFormat);
    std::string log = whole;
    log[18] = log[19] = 2;  // as if there were a log beside the file
    EXPECT_EQ(errorOf(log), Errc::Damaged);
    EXPECT_EQ(errorOf(whole), Errc::Internal) << "the file itself is whole";
}

TEST(Database, AFileHoldsWhatWasCommittedAndNobodyElseHasIt) {
    const auto folder = std::filesystem::temp_directory_path() /
                        ("edgewright-database-" + std::to_string(::getpid()));
    std::filesystem::create_directories(folder);
    const std::string path = folder / "work";
    {
        auto db = Database::openFile(path, kKind);
        ASSERT_TRUE(db) << db.error().message;
        ASSERT_TRUE(db->begin());
        ASSERT_TRUE(db->put(kThing, thing(1)));
        ASSERT_TRUE(db->commit());
        ASSERT_TRUE(db->begin());
        ASSERT_TRUE(db->put(kThing, thing(2)));
        const auto second = Database::openFile(path, kKind);
        ASSERT_FALSE(second);
        EXPECT_EQ(second.error().code, Errc::InUse);
    }
    auto db = Database::openFile(path, kKind);
    ASSERT_TRUE(db) << db.error().message;
    EXPECT_EQ(rowsOf(*db, kThing), std::vector<Row>{thing(1)});
    db = Database::inMemory(kKind);
    // A link is not followed.
    std::filesystem::create_symlink(path, folder / "link");
    EXPECT_FALSE(Database::openFile(folder / "link", kKind));
    std::filesystem::remove_all(folder);
}

}  // namespace
}  // namespace ew
