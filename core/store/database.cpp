// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/store/database.h"

#include <sqlite3.h>

#include <map>
#include <utility>

#include "core/store/row_sum.h"

namespace ew {

namespace {

// Where they stand in the first bytes of a file (SQLite's file format, section 1.3).
constexpr std::string_view kMagic{"SQLite format 3\0", 16};
constexpr std::size_t kHeadBytes = 100;
constexpr std::size_t kWriteVersion = 18;
constexpr std::size_t kReadVersion = 19;
constexpr std::size_t kUserVersion = 60;
constexpr std::size_t kApplicationId = 68;

constexpr int kLongestField = 512 << 20;  // bytes; far beyond any solid
constexpr int kLongestSql = 100'000;

std::int32_t bigEndian(std::string_view bytes, std::size_t at) {
    std::uint32_t value = 0;
    for (std::size_t i = 0; i < 4; ++i) {
        value = (value << 8U) | static_cast<unsigned char>(bytes[at + i]);
    }
    return static_cast<std::int32_t>(value);
}

/// What SQLite's result means to a person.
Unexpected<Error> failure(int code, sqlite3* db) {
    const std::string reason = db != nullptr ? sqlite3_errmsg(db) : sqlite3_errstr(code);
    switch (code & 0xff) {
        case SQLITE_CORRUPT:
        case SQLITE_NOTADB:
        case SQLITE_CONSTRAINT:
        case SQLITE_MISMATCH:
        case SQLITE_TOOBIG:
        case SQLITE_ERROR:
            return fail(Errc::Damaged, reason);
        case SQLITE_BUSY:
        case SQLITE_LOCKED:
            return fail(Errc::InUse, "another window or program has the file open");
        case SQLITE_NOMEM:
            return fail(Errc::TooMuchMemory, "there is not enough memory");
        case SQLITE_FULL:
            return fail(Errc::CannotWrite, "there is no room left on the disk");
        default:
            return fail(Errc::CannotWrite, "the file cannot be read or written (" + reason + ")");
    }
}

struct CloseDatabase {
    void operator()(sqlite3* db) const { sqlite3_close_v2(db); }
};
struct Finish {
    void operator()(sqlite3_stmt* statement) const { sqlite3_finalize(statement); }
};
using Handle = std::unique_ptr<sqlite3, CloseDatabase>;
using Statement = std::unique_ptr<sqlite3_stmt, Finish>;

int bind(sqlite3_stmt* statement, int at, const Field& field) {
    if (const auto* n = std::get_if<std::int64_t>(&field))
        return sqlite3_bind_int64(statement, at, *n);
    if (const auto* x = std::get_if<double>(&field)) return sqlite3_bind_double(statement, at, *x);
    if (const auto* text = std::get_if<std::string>(&field)) {
        return sqlite3_bind_text64(statement, at, text->data(), text->size(), SQLITE_STATIC,
                                   SQLITE_UTF8);
    }
    if (const auto* bytes = std::get_if<Bytes>(&field)) {
        // An empty blob needs an address, or it is bound as nothing.
        const char* data = bytes->data.empty() ? "" : bytes->data.data();
        return sqlite3_bind_blob64(statement, at, data, bytes->data.size(), SQLITE_STATIC);
    }
    return sqlite3_bind_null(statement, at);
}

Field column(sqlite3_stmt* statement, int at) {
    const auto sized = [&](const void* data) {
        const auto size = static_cast<std::size_t>(sqlite3_column_bytes(statement, at));
        return data == nullptr ? std::string() : std::string(static_cast<const char*>(data), size);
    };
    switch (sqlite3_column_type(statement, at)) {
        case SQLITE_INTEGER:
            return std::int64_t{sqlite3_column_int64(statement, at)};
        case SQLITE_FLOAT:
            return sqlite3_column_double(statement, at);
        case SQLITE_TEXT:
            return sized(sqlite3_column_text(statement, at));
        case SQLITE_BLOB:
            return Bytes{sized(sqlite3_column_blob(statement, at))};
        default:
            return {};
    }
}

Result<void> runSql(sqlite3* db, const std::string& sql) {
    const int code = sqlite3_exec(db, sql.c_str(), nullptr, nullptr, nullptr);
    if (code != SQLITE_OK) return failure(code, db);
    return {};
}

Result<Statement> prepared(sqlite3* db, const std::string& sql, bool persistent) {
    sqlite3_stmt* raw = nullptr;
    const int code = sqlite3_prepare_v3(db, sql.c_str(), -1,
                                        persistent ? SQLITE_PREPARE_PERSISTENT : 0U, &raw, nullptr);
    Statement statement(raw);
    if (code != SQLITE_OK) return failure(code, db);
    return statement;
}

/// Nothing that a file brings is run, and what it may cost has an end.
void beDefensive(sqlite3* db) {
    sqlite3_extended_result_codes(db, 1);
    sqlite3_db_config(db, SQLITE_DBCONFIG_DEFENSIVE, 1, nullptr);
    sqlite3_db_config(db, SQLITE_DBCONFIG_TRUSTED_SCHEMA, 0, nullptr);
    sqlite3_db_config(db, SQLITE_DBCONFIG_ENABLE_TRIGGER, 0, nullptr);
    sqlite3_db_config(db, SQLITE_DBCONFIG_ENABLE_VIEW, 0, nullptr);
    sqlite3_db_config(db, SQLITE_DBCONFIG_DQS_DDL, 0, nullptr);
    sqlite3_db_config(db, SQLITE_DBCONFIG_DQS_DML, 0, nullptr);
    constexpr std::pair<int, int> kLimits[] = {{SQLITE_LIMIT_LENGTH, kLongestField},
                                               {SQLITE_LIMIT_SQL_LENGTH, kLongestSql},
                                               {SQLITE_LIMIT_COLUMN, 32},
                                               {SQLITE_LIMIT_EXPR_DEPTH, 32},
                                               {SQLITE_LIMIT_COMPOUND_SELECT, 4},
                                               {SQLITE_LIMIT_FUNCTION_ARG, 8},
                                               {SQLITE_LIMIT_ATTACHED, 0},
                                               {SQLITE_LIMIT_LIKE_PATTERN_LENGTH, 64},
                                               {SQLITE_LIMIT_VARIABLE_NUMBER, 64},
                                               {SQLITE_LIMIT_TRIGGER_DEPTH, 1},
                                               {SQLITE_LIMIT_WORKER_THREADS, 0}};
    for (const auto& [limit, value] : kLimits) sqlite3_limit(db, limit, value);
}

Result<void> checkHead(std::string_view bytes, const DatabaseKind& kind) {
    if (!isDatabase(bytes)) return fail(Errc::WrongFormat, "the file is no document");
    const DatabaseHead head = databaseHead(bytes);
    if (head.applicationId != kind.applicationId) {
        return fail(Errc::WrongFormat, "the file is a database of another program");
    }
    if (head.version != kind.version) {
        return fail(Errc::WrongVersion, "its format has the version " +
                                            std::to_string(head.version) + ", not " +
                                            std::to_string(kind.version));
    }
    return {};
}

/// Everything in the file is a table that is known, as it was made.
Result<void> checkTables(sqlite3* db, const DatabaseKind& kind) {
    auto found = prepared(db, "SELECT type, name, sql FROM sqlite_schema", false);
    if (!found) return fail(found.error());
    std::size_t known = 0;
    int code = SQLITE_ROW;
    while ((code = sqlite3_step(found->get())) == SQLITE_ROW) {
        const Field type = column(found->get(), 0);
        const Field name = column(found->get(), 1);
        const Field sql = column(found->get(), 2);
        bool fits = false;
        for (const Table& table : kind.tables) {
            fits |= type == Field(std::string("table")) && name == Field(std::string(table.name)) &&
                    sql == Field(std::string(table.sql));
        }
        if (fits) ++known;
        if (!fits && !kind.others) {
            return fail(Errc::Damaged, "the file holds tables that no document has");
        }
    }
    if (code != SQLITE_DONE) return failure(code, db);
    if (known != kind.tables.size()) return fail(Errc::Damaged, "tables of the file are missing");
    return {};
}

Result<void> checkPages(sqlite3* db) {
    auto check = prepared(db, "PRAGMA quick_check(1)", false);
    if (!check) return fail(check.error());
    const int code = sqlite3_step(check->get());
    if (code != SQLITE_ROW) return failure(code, db);
    const Field said = column(check->get(), 0);
    if (said == Field(std::string("ok"))) return {};
    const auto* text = std::get_if<std::string>(&said);
    std::string line = text == nullptr ? std::string() : text->substr(0, text->rfind('\n'));
    return fail(Errc::Damaged, line);
}

Result<void> makeTables(sqlite3* db, const DatabaseKind& kind) {
    std::string sql =
        "BEGIN IMMEDIATE; PRAGMA application_id=" + std::to_string(kind.applicationId) +
        "; PRAGMA user_version=" + std::to_string(kind.version) + ";";
    for (const Table& table : kind.tables) sql.append(table.sql).append(";");
    return runSql(db, sql + "COMMIT");
}

Result<std::int64_t> number(sqlite3* db, const std::string& sql) {
    auto statement = prepared(db, sql, false);
    if (!statement) return fail(statement.error());
    const int code = sqlite3_step(statement->get());
    if (code != SQLITE_ROW) return failure(code, db);
    return std::int64_t{sqlite3_column_int64(statement->get(), 0)};
}

}  // namespace

bool isDatabase(std::string_view bytes) {
    return bytes.size() >= kHeadBytes && bytes.starts_with(kMagic);
}

DatabaseHead databaseHead(std::string_view bytes) {
    return {bigEndian(bytes, kApplicationId), bigEndian(bytes, kUserVersion)};
}

struct Database::Impl {
    std::string source;  ///< of overBytes(); must outlive the handle
    Handle db;
    DatabaseKind kind;
    std::map<std::string, Statement, std::less<>> statements;  // by SQL; gone before the handle

    Result<sqlite3_stmt*> statement(const std::string& sql) {
        const auto known = statements.find(sql);
        if (known != statements.end()) return known->second.get();
        auto made = prepared(db.get(), sql, true);
        if (!made) return fail(made.error());
        return statements.emplace(sql, *std::move(made)).first->second.get();
    }

    Result<void> execute(const std::string& sql, const Row& values) {
        const auto found = statement(sql);
        if (!found) return fail(found.error());
        int code = SQLITE_OK;
        for (std::size_t i = 0; i < values.size() && code == SQLITE_OK; ++i) {
            code = bind(*found, static_cast<int>(i) + 1, values[i]);
        }
        if (code == SQLITE_OK) code = sqlite3_step(*found);
        Result<void> result;
        if (code != SQLITE_DONE) result = failure(code, db.get());
        sqlite3_reset(*found);
        sqlite3_clear_bindings(*found);
        return result;
    }

    Result<void> open(const char* path, int flags) {
        sqlite3* raw = nullptr;
        const int code = sqlite3_open_v2(path, &raw, flags | SQLITE_OPEN_NOMUTEX, nullptr);
        db.reset(raw);
        if (code != SQLITE_OK) return failure(code, raw);
        beDefensive(raw);
        return runSql(raw, "PRAGMA cell_size_check=ON; PRAGMA mmap_size=0; PRAGMA temp_store=2");
    }

    Result<void> check() {
        if (auto ok = checkTables(db.get(), kind); !ok) return ok;
        return checkPages(db.get());
    }
};

Database::Database(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Database::Database(Database&&) noexcept = default;
Database& Database::operator=(Database&&) noexcept = default;
Database::~Database() = default;

Result<Database> Database::inMemory(const DatabaseKind& kind) {
    auto impl = std::make_unique<Impl>();
    impl->kind = kind;
    auto ok = impl->open(":memory:", SQLITE_OPEN_READWRITE | SQLITE_OPEN_CREATE);
    if (ok) ok = makeTables(impl->db.get(), kind);
    if (!ok) return fail(ok.error());
    return Database(std::move(impl));
}

Result<Database> Database::overBytes(std::string bytes, const DatabaseKind& kind) {
    if (auto ok = checkHead(bytes, kind); !ok) return fail(ok.error());
    // A database that is in the middle of being worked on has another file beside it.
    if (bytes[kReadVersion] != 1 || bytes[kWriteVersion] != 1) {
        return fail(Errc::Damaged, "its first bytes are changed");
    }
    auto impl = std::make_unique<Impl>();
    impl->kind = kind;
    impl->source = std::move(bytes);
    if (auto ok = impl->open(":memory:", SQLITE_OPEN_READWRITE); !ok) return fail(ok.error());
    auto* data = reinterpret_cast<unsigned char*>(impl->source.data());
    const auto size = static_cast<sqlite3_int64>(impl->source.size());
    const int code =
        sqlite3_deserialize(impl->db.get(), "main", data, size, size, SQLITE_DESERIALIZE_READONLY);
    if (code != SQLITE_OK) return failure(code, impl->db.get());
    if (auto ok = impl->check(); !ok) return fail(ok.error());
    return Database(std::move(impl));
}

Result<Database> Database::openFile(const std::string& path, const DatabaseKind& kind,
                                    Missing missing) {
    auto impl = std::make_unique<Impl>();
    impl->kind = kind;
    const int make = missing == Missing::Make ? SQLITE_OPEN_CREATE : 0;
    auto ok = impl->open(path.c_str(), SQLITE_OPEN_READWRITE | SQLITE_OPEN_NOFOLLOW | make);
    if (!ok) return fail(ok.error());
    sqlite3* db = impl->db.get();
    // Exclusive: nothing that is shared with another process can be cut off. FULL: a commit is on
    // the disk, not on its way there.
    ok = runSql(db,
                "PRAGMA locking_mode=EXCLUSIVE; PRAGMA journal_mode=WAL; PRAGMA synchronous=FULL; "
                "PRAGMA wal_autocheckpoint=2000");
    if (!ok) return fail(ok.error());
    const auto pages = number(db, "SELECT count(*) FROM sqlite_schema");
    const auto id = number(db, "PRAGMA application_id");
    const auto version = number(db, "PRAGMA user_version");
    if (!pages) return fail(pages.error());
    if (!id) return fail(id.error());
    if (!version) return fail(version.error());
    const bool isNew = *pages == 0 && *id == 0 && *version == 0;
    if (isNew) {
        ok = makeTables(db, kind);
    } else if (*id != kind.applicationId) {
        ok = fail(Errc::WrongFormat, "the file is a database of another program");
    } else if (*version != kind.version) {
        ok = fail(Errc::WrongVersion, "its format has the version " + std::to_string(*version));
    } else {
        ok = impl->check();
    }
    if (!ok) return fail(ok.error());
    return Database(std::move(impl));
}

Result<void> Database::begin() { return impl_->execute("BEGIN IMMEDIATE", {}); }
Result<void> Database::commit() { return impl_->execute("COMMIT", {}); }
void Database::rollback() {
    if (sqlite3_get_autocommit(impl_->db.get()) == 0) {
        static_cast<void>(impl_->execute("ROLLBACK", {}));
    }
}

Result<void> Database::put(const Table& table, const Row& row) {
    std::string sql = "INSERT OR REPLACE INTO ";
    sql.append(table.name).append(" VALUES(");
    for (int i = 0; i < table.columns; ++i) sql += "?,";
    Row all = row;
    all.emplace_back(rowSum(table.name, row));
    return impl_->execute(sql + "?)", all);
}

namespace {

/// The names of the first columns of a table, which stand in its statement.
std::vector<std::string> keyNames(const Table& table) {
    std::vector<std::string> names;
    std::size_t at = table.sql.find('(') + 1;
    for (int i = 0; i < table.keys; ++i) {
        names.emplace_back(table.sql.substr(at, table.sql.find(' ', at) - at));
        at = table.sql.find(',', at) + 2;
    }
    return names;
}

}  // namespace

Result<void> Database::remove(const Table& table, const Row& key) {
    std::string sql = "DELETE FROM ";
    sql.append(table.name);
    const char* word = " WHERE ";
    for (const std::string& name : keyNames(table)) {
        sql.append(word).append(name).append("=?");
        word = " AND ";
    }
    return impl_->execute(sql, key);
}

Result<void> Database::clear() {
    for (const Table& table : impl_->kind.tables) {
        if (auto ok = impl_->execute("DELETE FROM " + std::string(table.name), {}); !ok) return ok;
    }
    return {};
}

Result<void> Database::each(const Table& table,
                            const std::function<Result<void>(const Row&)>& visit) {
    std::string sql = "SELECT * FROM ";
    sql.append(table.name).append(" ORDER BY ");
    for (int i = 1; i <= table.keys; ++i) sql += (i > 1 ? "," : "") + std::to_string(i);
    const auto rows = prepared(impl_->db.get(), sql, false);
    if (!rows) return fail(rows.error());
    int code = SQLITE_ROW;
    Row row;
    while ((code = sqlite3_step(rows->get())) == SQLITE_ROW) {
        row.clear();
        for (int i = 0; i < table.columns; ++i) row.push_back(column(rows->get(), i));
        const Field sum = column(rows->get(), table.columns);
        if (sum != Field(rowSum(table.name, row))) {
            return fail(Errc::Damaged, "a row of the table " + std::string(table.name) +
                                           " does not fit its check sum");
        }
        if (auto ok = visit(row); !ok) return ok;
    }
    if (code != SQLITE_DONE) return failure(code, impl_->db.get());
    return {};
}

Result<std::string> Database::bytes() {
    sqlite3_int64 size = 0;
    const std::unique_ptr<unsigned char, void (*)(void*)> data(
        sqlite3_serialize(impl_->db.get(), "main", &size, 0), &sqlite3_free);
    if (data == nullptr) return fail(Errc::TooMuchMemory, "there is not enough memory");
    return std::string(reinterpret_cast<const char*>(data.get()), static_cast<std::size_t>(size));
}

Result<void> Database::checkpoint() {
    const int code = sqlite3_wal_checkpoint_v2(impl_->db.get(), nullptr, SQLITE_CHECKPOINT_TRUNCATE,
                                               nullptr, nullptr);
    if (code != SQLITE_OK) return failure(code, impl_->db.get());
    return {};
}

}  // namespace ew
