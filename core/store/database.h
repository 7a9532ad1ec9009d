// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "core/base/result.h"

namespace ew {

/// Bytes that are no text.
struct Bytes {
    std::string data;
    bool operator==(const Bytes&) const = default;
};

/// One value of a row: nothing, a whole number, a finite number, a text (UTF-8) or bytes.
using Field = std::variant<std::monostate, std::int64_t, double, std::string, Bytes>;
using Row = std::vector<Field>;

/// A table whose last column, `sum`, is a check sum over the others, which put() writes and each()
/// compares, so that a byte that changed on the disk is never taken for what was stored.
struct Table {
    std::string_view name;
    std::string_view sql;  ///< the CREATE TABLE statement, as it stands in the file
    int columns = 0;       ///< without `sum`
    int keys = 1;  ///< the first so many columns are the primary key; rows come in its order
};

/// What a database file of this program says about itself.
struct DatabaseKind {
    std::int32_t applicationId = 0;  ///< SQLite's application_id
    std::int32_t version = 0;        ///< SQLite's user_version
    std::span<const Table> tables;   ///< all that there is in it, no more and no less
    bool others = false;             ///< other tables, which are not looked at, may be there too
};

/// A SQLite database that trusts no file: nothing that a file brings is run (no trigger, view,
/// virtual table, function or other file), what it may cost is limited, its pages are checked as a
/// whole before a row is read, and every row has a check sum. One thread at a time.
class Database {
  public:
    /// A new one in memory. Errc::TooMuchMemory.
    static Result<Database> inMemory(const DatabaseKind& kind);
    /// What stands in these bytes, read only and without touching the disk. Errors: WrongFormat
    /// (another kind of file), WrongVersion, Damaged, TooMuchMemory.
    static Result<Database> overBytes(std::string bytes, const DatabaseKind& kind);
    /// A file that is kept up to date: each transaction is on the
    /// disk when commit() comes back, or is not in the file at all, however the program or the
    /// machine ends. Errors: those of overBytes(), InUse (another process has it open),
    /// CannotWrite (also where it is not there and not to be made).
    enum class Missing { Make, Refuse };
    static Result<Database> openFile(const std::string& path, const DatabaseKind& kind,
                                     Missing missing = Missing::Make);

    Database(Database&&) noexcept;
    Database& operator=(Database&&) noexcept;
    ~Database();

    // A transaction; what is not committed is taken back. CannotWrite, Damaged.
    Result<void> begin();
    Result<void> commit();
    void rollback();

    /// Writes a row, in place of the one with the same key.
    /// \pre one field a column, without `sum`.
    Result<void> put(const Table& table, const Row& row);
    /// Removes the row with this key, if there is one.
    /// \param key  the first Table::keys fields.
    Result<void> remove(const Table& table, const Row& key);
    /// Removes everything from all tables.
    Result<void> clear();
    /// Every row in the order of its key. Stops at the first error of `visit` and returns it.
    /// Errc::Damaged.
    Result<void> each(const Table& table, const std::function<Result<void>(const Row&)>& visit);

    /// The whole database as the bytes of a file. Errc::TooMuchMemory.
    Result<std::string> bytes();
    /// Brings what commits have written beside a file into the file itself.
    Result<void> checkpoint();

  private:
    struct Impl;
    explicit Database(std::unique_ptr<Impl> impl);
    std::unique_ptr<Impl> impl_;
};

/// application_id and user_version of a database file, told by its first bytes alone.
struct DatabaseHead {
    std::int32_t applicationId = 0;
    std::int32_t version = 0;
};
/// Is this the beginning of a SQLite database?
bool isDatabase(std::string_view bytes);
/// \pre isDatabase(bytes)
DatabaseHead databaseHead(std::string_view bytes);

}  // namespace ew
