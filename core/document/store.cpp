// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/store.h"

#include <QFileInfo>

#include "core/document/file_names.h"
#include "core/document/json_text.h"
#include "core/document/store_reader.h"
#include "core/document/store_schema.h"
#include "core/document/store_schema1.h"

namespace ew {

namespace {

/// Why a file of a later schema is not read. Every schema has the table of settings, in which
/// `needs` says which version of the program it needs.
std::string newerVersionText(const std::string& bytes, std::int32_t version) {
    const DatabaseKind kind{schema::kApplicationId, version, {&schema::kSetting, 1}, true};
    std::string needed;
    constexpr std::size_t kLongest = 20;
    if (auto database = Database::overBytes(bytes, kind)) {
        static_cast<void>(database->each(schema::kSetting, [&](const Row& row) -> Result<void> {
            const auto* value = std::get_if<std::string>(&row[1]);
            if (row[0] != Field(std::string("needs")) || value == nullptr) return {};
            const auto tree = parseJson(*value, {});
            if (tree && tree->is_string()) needed = tree->get<std::string>().substr(0, kLongest);
            return {};
        }));
    }
    const std::string wanted = needed.empty()
                                   ? "a later version of Edgewright is needed"
                                   : "Edgewright " + nameQuoted(needed) + " or later is needed";
    return "The document was written by a later version (its schema is " + std::to_string(version) +
           ", this program reads up to " + std::to_string(schema::kVersion) + "); " + wanted + ".";
}

}  // namespace

Result<DocumentFile> readDocument(const std::string& bytes, const TemplateLibrary& shipped) {
    if (!isDatabase(bytes)) return readSchema1(bytes, shipped);
    const DatabaseHead head = databaseHead(bytes);
    if (head.applicationId == schema::kApplicationId && head.version > schema::kVersion) {
        return fail(Errc::WrongVersion, newerVersionText(bytes, head.version));
    }
    auto database = Database::overBytes(bytes, schema::kKind);
    if (!database) return fail(database.error());
    return readDatabase(*database, shipped);
}

Result<void> saveDocument(const DocumentFile& file, const QString& path) {
    const auto bytes = writeDocument(file);
    if (!bytes) return fail(bytes.error());
    if (bytes->size() > kMaxDocumentBytes) {
        return fail(Errc::TooLarge, "The document is larger than " +
                                        std::to_string(kMaxDocumentBytes >> 20U) +
                                        " MiB and could not be opened again.");
    }
    return writeFileBytes(path, *bytes);
}

Result<DocumentFile> loadDocument(const QString& path, const TemplateLibrary& shipped) {
    auto bytes = readFileBytes(path, kMaxDocumentBytes);
    if (!bytes) return fail(bytes.error());
    const std::string name = QFileInfo(path).fileName().toStdString();
    if (auto ok = refuseOtherKinds(name, *bytes); !ok) return fail(ok.error());
    auto file = readDocument(*bytes, shipped);
    if (file) return file;
    const Error& error = file.error();
    if (error.code == Errc::Damaged) {
        return fail(error.code,
                    name + " is damaged and cannot be opened whole: " + error.message + ".");
    }
    return fail(error.code, name + ": " + error.message);
}

}  // namespace ew
