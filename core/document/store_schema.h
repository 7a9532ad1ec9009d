// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/store/database.h"

// Schema 2 of the native document, as docs/document-format.md lays it down. A statement here is
// what stands in files: it never changes; another one is another schema.
namespace ew::schema {

inline constexpr std::int32_t kApplicationId = 0x45644757;  // "EdGW"
inline constexpr std::int32_t kVersion = 2;

inline constexpr Table kSetting{
    "setting",
    "CREATE TABLE setting(key TEXT NOT NULL PRIMARY KEY, value TEXT NOT NULL, "
    "sum INTEGER NOT NULL) STRICT, WITHOUT ROWID",
    2};
inline constexpr Table kBlob{
    "blob",
    "CREATE TABLE blob(id INTEGER PRIMARY KEY, sha256 BLOB NOT NULL, size INTEGER NOT NULL, "
    "packed INTEGER NOT NULL, data BLOB NOT NULL, sum INTEGER NOT NULL) STRICT",
    5};
inline constexpr Table kCamera{
    "camera",
    "CREATE TABLE camera(id INTEGER PRIMARY KEY, camera TEXT NOT NULL, sum INTEGER NOT NULL) "
    "STRICT",
    2};
inline constexpr Table kTemplate{
    "template",
    "CREATE TABLE template(id INTEGER PRIMARY KEY, json TEXT NOT NULL, sum INTEGER NOT NULL) "
    "STRICT",
    2};
inline constexpr Table kStroke{
    "stroke",
    "CREATE TABLE stroke(id INTEGER PRIMARY KEY, camera INTEGER NOT NULL, samples INTEGER NOT "
    "NULL, sum INTEGER NOT NULL) STRICT",
    3};
inline constexpr Table kMapped{
    "mapped",
    "CREATE TABLE mapped(id INTEGER PRIMARY KEY, base INTEGER, kept INTEGER NOT NULL, more TEXT "
    "NOT NULL, sum INTEGER NOT NULL) STRICT",
    4};
inline constexpr Table kState{
    "state",
    "CREATE TABLE state(id INTEGER PRIMARY KEY, bodies TEXT NOT NULL, templates TEXT NOT NULL, "
    "surface INTEGER, mapped INTEGER, sum INTEGER NOT NULL) STRICT",
    5};
inline constexpr Table kStep{
    "step",
    "CREATE TABLE step(place INTEGER PRIMARY KEY, name TEXT NOT NULL, state INTEGER NOT NULL, "
    "strokes TEXT NOT NULL, template INTEGER, setting TEXT NOT NULL, sum INTEGER NOT NULL) STRICT",
    6};
inline constexpr Table kInk{
    "ink",
    "CREATE TABLE ink(list INTEGER NOT NULL, place INTEGER NOT NULL, serial INTEGER NOT NULL, "
    "added TEXT NOT NULL, removed TEXT NOT NULL, withdrawn TEXT NOT NULL, sum INTEGER NOT NULL, "
    "PRIMARY KEY(list, place)) STRICT, WITHOUT ROWID",
    6, 2};
inline constexpr Table kPending{
    "pending", "CREATE TABLE pending(stroke INTEGER PRIMARY KEY, sum INTEGER NOT NULL) STRICT", 1};
inline constexpr Table kScript{
    "script",
    "CREATE TABLE script(list INTEGER NOT NULL, place INTEGER NOT NULL, step TEXT, samples "
    "INTEGER, pressure INTEGER NOT NULL, camera INTEGER NOT NULL, distance REAL NOT NULL, angle "
    "REAL NOT NULL, ink INTEGER NOT NULL, sum INTEGER NOT NULL, PRIMARY KEY(list, place)) STRICT, "
    "WITHOUT ROWID",
    9, 2};

inline constexpr Table kTables[] = {kSetting, kBlob, kCamera, kTemplate, kStroke, kMapped,
                                    kState,   kStep, kInk,    kPending,  kScript};
inline constexpr DatabaseKind kKind{kApplicationId, kVersion, kTables};

// Lists of the table ink.
inline constexpr std::int64_t kInkDone = 0;
inline constexpr std::int64_t kInkUndone = 1;
/// Of a step: the changes before it, and those that could be done again after it.
inline constexpr std::int64_t inkBefore(std::size_t step) {
    return 2 * static_cast<std::int64_t>(step) + 2;
}
inline constexpr std::int64_t inkAfter(std::size_t step) { return inkBefore(step) + 1; }

// Lists of the table script: all that was done, and what was taken back of an ink change.
inline constexpr std::int64_t kScriptDone = 0;
inline constexpr std::int64_t takenBack(int serial) { return serial >= 0 ? serial + 1 : serial; }
inline constexpr std::int64_t serialTakenBack(std::int64_t list) {
    return list > 0 ? list - 1 : list;
}

}  // namespace ew::schema
