// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <memory>
#include <optional>
#include <set>
#include <string>
#include <unordered_map>
#include <vector>

#include "core/document/store.h"
#include "core/store/database.h"

namespace ew {

/// Brings a database of schema 2 up to date, update by update; it remembers what is in it. Rows
/// that nothing refers to any more stay until the document is written anew.
class DocumentWriter {
  public:
    /// \param database  must outlive the writer.
    explicit DocumentWriter(Database& database) : db_(database) {}

    /// One transaction: all of the update or, on error, nothing of it; what a whole update finds
    /// there it replaces. Errors of Database::put and commit; Internal for one that is not whole
    /// where needsWhole().
    Result<void> write(const DocumentUpdate& update);
    /// Must the next update be whole? So it is for the first one, and after an error.
    bool needsWhole() const { return lost_; }

  private:
    struct StateRow {
        std::shared_ptr<const DocumentState> state;  ///< held, so that its address stays its own
        std::int64_t id = 0;
        std::vector<std::int64_t> solids;  ///< blobs, by body
        std::optional<std::int64_t> surface, mapped;
    };

    void writeAll(const DocumentUpdate& update);
    void writeHistory(const DocumentUpdate& update);
    void writeInk(const DocumentFile& file);
    void writeScript(const DocumentUpdate& update);
    void writeSettings(const DocumentUpdate& update);

    // Each returns the id of a row, which is written where it is not there yet.
    std::int64_t blob(const std::string& content);
    std::int64_t camera(const OrthographicCamera& camera);
    std::int64_t tmpl(const Template& t);
    std::int64_t samples(const Stroke& stroke);
    std::int64_t state(const std::shared_ptr<const DocumentState>& s, const StateRow* before);
    std::optional<std::int64_t> mapped(const DocumentState& s, const StateRow* before);
    void stroke(const PendingStroke& s);
    Row scriptRow(std::int64_t list, std::size_t place, const Recorder::Entry& entry);
    void inkList(std::int64_t list, const StoredInk& changes, std::size_t keep);
    void setting(const std::string& key, const std::string& value);

    void put(const Table& table, const Row& row);
    void remove(const Table& table, const Row& key);

    Database& db_;
    /// What the database holds.
    struct Known {
        std::map<std::string, std::int64_t> blobs;  // by SHA-256
        std::map<std::string, std::int64_t> cameras, templates;
        std::int64_t mappedRows = 0, stateRows = 0;
        std::set<int> strokes;
        std::unordered_map<const DocumentState*, StateRow> states;
        std::vector<std::shared_ptr<const DocumentState>> chain;  // first, then after each command
        std::map<std::int64_t, std::size_t> inkRows;              // by list
        StoredInk inkDone, inkUndone;
        std::vector<int> pending;
        std::map<std::int64_t, std::size_t> scriptRows;  // by list
        std::map<std::string, std::string> settings;
    };
    Known known_;
    bool lost_ = true;
};

}  // namespace ew
