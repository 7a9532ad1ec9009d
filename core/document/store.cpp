// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/store.h"

#include <QFile>
#include <QFileInfo>

#include "core/document/file_names.h"
#include "core/document/json_text.h"
#include "core/document/store_reader.h"
#include "core/document/store_schema.h"
#include "core/document/store_schema1.h"

namespace ew {

namespace {

/// What a file of a later schema says of itself. Every schema has the table of settings.
struct LaterSchema {
    std::int32_t version = 0;
    std::string needs;            ///< the oldest version of the program that reads it whole
    std::int64_t readableAs = 0;  ///< the oldest schema as which it can be read
};

LaterSchema laterSchema(const std::string& bytes, std::int32_t version) {
    LaterSchema out;
    out.version = version;
    const DatabaseKind kind{schema::kApplicationId, version, {&schema::kSetting, 1}, true};
    auto database = Database::overBytes(bytes, kind);
    if (!database) return out;
    constexpr std::size_t kLongest = 20;
    static_cast<void>(database->each(schema::kSetting, [&](const Row& row) -> Result<void> {
        const auto* value = std::get_if<std::string>(&row[1]);
        if (value == nullptr) return {};
        const auto tree = parseJson(*value, {});
        if (!tree) return {};
        if (row[0] == Field(std::string("needs")) && tree->is_string()) {
            out.needs = tree->get<std::string>().substr(0, kLongest);
        }
        if (row[0] == Field(std::string("readable_as")) && tree->is_number_integer()) {
            out.readableAs = tree->get<std::int64_t>();
        }
        return {};
    }));
    return out;
}

std::string laterVersionText(const LaterSchema& later) {
    const std::string wanted =
        later.needs.empty() ? "a later version of Edgewright is needed"
                            : "Edgewright " + nameQuoted(later.needs) + " or later is needed";
    return "The document was written by a later version (its schema is " +
           std::to_string(later.version) + ", this program reads up to " +
           std::to_string(schema::kVersion) + "); " + wanted + ".";
}

bool isOfLaterSchema(std::string_view bytes) {
    if (!isDatabase(bytes)) return false;
    const DatabaseHead head = databaseHead(bytes);
    return head.applicationId == schema::kApplicationId && head.version > schema::kVersion;
}

/// Reads what this program knows of a file whose schema says that it may be read so.
Result<DocumentFile> readLater(const std::string& bytes, const TemplateLibrary& shipped,
                               const ReadOptions& options) {
    const LaterSchema later = laterSchema(bytes, databaseHead(bytes).version);
    if (later.readableAs < 1 || later.readableAs > schema::kVersion) {
        return fail(Errc::WrongVersion, laterVersionText(later));
    }
    const DatabaseKind kind{schema::kApplicationId, later.version, schema::kTables, true};
    auto database = Database::overBytes(bytes, kind);
    if (!database) return fail(database.error());
    return readDatabase(*database, shipped, options);
}

}  // namespace

Result<DocumentFile> readDocument(const std::string& bytes, const TemplateLibrary& shipped,
                                  const ReadOptions& options) {
    if (!isDatabase(bytes)) return readSchema1(bytes, shipped);
    if (isOfLaterSchema(bytes)) return readLater(bytes, shipped, options);
    auto database = Database::overBytes(bytes, schema::kKind);
    if (!database) return fail(database.error());
    return readDatabase(*database, shipped, options);
}

Result<void> loadState(const DocumentState& state) {
    for (const Body& body : state.bodies) {
        if (auto ok = body.solid.load(); !ok) {
            return fail(Errc::Damaged, "A solid in the file is damaged: " + ok.error().message);
        }
    }
    return {};
}

bool isFileOfLaterSchema(const QString& path) {
    QFile file(path);
    if (!QFileInfo(path).isFile() || !file.open(QIODevice::ReadOnly)) return false;
    constexpr qint64 kHead = 100;  // bytes of SQLite's header
    return isOfLaterSchema(file.read(kHead).toStdString());
}

Result<void> saveDocument(const DocumentFile& file, const QString& path) {
    const auto bytes = writeDocument(file);
    if (!bytes) return fail(bytes.error());
    if (bytes->size() > kMaxDocumentBytes) {
        return fail(Errc::TooLarge, "The document is larger than " +
                                        std::to_string(kMaxDocumentBytes >> 20U) +
                                        " MiB and could not be opened again.");
    }
    if (isFileOfLaterSchema(path)) {
        return fail(Errc::WrongVersion,
                    "The file " + path.toStdString() +
                        " was written by a later version of Edgewright, and what this one does "
                        "not know of it would be lost; save under another name.");
    }
    return writeFileBytes(path, *bytes);
}

Result<DocumentFile> loadDocument(const QString& path, const TemplateLibrary& shipped,
                                  const ReadOptions& options) {
    auto bytes = readFileBytes(path, kMaxDocumentBytes);
    if (!bytes) return fail(bytes.error());
    const std::string name = QFileInfo(path).fileName().toStdString();
    if (auto ok = refuseOtherKinds(name, *bytes); !ok) return fail(ok.error());
    auto file = readDocument(*bytes, shipped, options);
    if (file) return file;
    const Error& error = file.error();
    if (error.code == Errc::Cancelled) return file;
    if (error.code == Errc::Damaged) {
        return fail(error.code,
                    name + " is damaged and cannot be opened whole: " + error.message + ".");
    }
    return fail(error.code, name + ": " + error.message);
}

}  // namespace ew
