// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/file_names.h"

#include <QFileInfo>
#include <QUrl>
#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>

#include "core/document/json_text.h"
#include "core/document/store_schema.h"

namespace ew {

namespace {

constexpr std::string_view kBlank = " \t\r\n";

/// The text after a byte order mark and blanks.
std::string_view trimmed(std::string_view bytes) {
    constexpr std::string_view kMark = "\xef\xbb\xbf";
    if (bytes.starts_with(kMark)) bytes.remove_prefix(kMark.size());
    bytes.remove_prefix(std::min(bytes.find_first_not_of(kBlank), bytes.size()));
    return bytes;
}

bool isBinaryStl(std::string_view bytes) {
    constexpr std::size_t kHead = 80;
    constexpr std::size_t kTriangle = 50;
    if (bytes.size() < kHead + 4) return false;
    std::uint64_t count = 0;
    for (std::size_t k = 4; k-- > 0;) {
        count = (count << 8U) | static_cast<unsigned char>(bytes[kHead + k]);
    }
    return bytes.size() == kHead + 4 + kTriangle * count;
}

bool looksLikeObj(std::string_view text) {
    while (!text.empty() && text.front() == '#') {
        text.remove_prefix(std::min(text.find('\n'), text.size()));
        text = trimmed(text);
    }
    constexpr std::array<std::string_view, 5> kWords{"v ", "o ", "g ", "mtllib ", "vn "};
    return std::any_of(kWords.begin(), kWords.end(),
                       [&](std::string_view word) { return text.starts_with(word); });
}

/// In words, for the middle of a sentence.
std::string_view contentWords(std::string_view bytes) {
    constexpr std::pair<std::string_view, std::string_view> kBeginnings[] = {
        {"\x89PNG", "a picture"},
        {"\xff\xd8\xff", "a picture"},
        {"GIF8", "a picture"},
        {"%PDF", "a PDF document"},
        {"PK\x03\x04", "a ZIP package, as 3MF files are"},
        {"SQLite format 3", "a database of another program"},
        {"glTF", "a glTF mesh"},
        {"ply\n", "a PLY mesh"},
        {"ply\r", "a PLY mesh"},
        {"solid", "an STL mesh"},
        {"ISO-10303-21", "a STEP model"},
        {"<", "XML text, as SVG files are"},
    };
    const std::string_view text = trimmed(bytes);
    if (text.empty()) return "nothing";
    if (isBinaryStl(bytes)) return "an STL mesh";
    for (const auto& [beginning, words] : kBeginnings) {
        if (text.starts_with(beginning)) return words;
    }
    if (looksLikeObj(text)) return "an OBJ mesh";
    constexpr std::size_t kLookedAt = 4096;
    const bool isText = text.substr(0, kLookedAt).find('\0') == std::string_view::npos;
    return isText ? "text of another kind" : "data of another kind";
}

}  // namespace

bool endsWith(const QString& path, const QString& ending) {
    return path.endsWith(ending, Qt::CaseInsensitive);
}

QString withEnding(const QString& path, const QStringList& known, const QString& ending) {
    const bool has = std::any_of(known.begin(), known.end(),
                                 [&](const QString& one) { return endsWith(path, one); });
    return path.isEmpty() || has ? path : path + ending;
}

Result<QString> localFile(const QString& pathOrUrl) {
    const bool isUrl = pathOrUrl.startsWith(QStringLiteral("file:"), Qt::CaseInsensitive) ||
                       pathOrUrl.contains(QStringLiteral("://"));
    // A file may be called like that, too.
    if (!isUrl || QFileInfo::exists(pathOrUrl)) return QFileInfo(pathOrUrl).absoluteFilePath();
    const QUrl url(pathOrUrl);
    if (!url.isLocalFile() || !url.host().isEmpty()) {
        return fail(Errc::BadValue, nameQuoted(pathOrUrl.toStdString()) +
                                        " is no file of this computer; only those can be opened.");
    }
    return QFileInfo(url.toLocalFile()).absoluteFilePath();
}

Result<QString> documentFileName(const QString& path) {
    if (endsWith(path, kScriptEnding)) {
        return fail(Errc::BadValue, "A document cannot be called " +
                                        QFileInfo(path).fileName().toStdString() +
                                        ": files that end in .json are sketch scripts.");
    }
    // A folder is refused as it stands, not written beside.
    if (QFileInfo(path).isDir()) return path;
    return withEnding(path, {kDocumentEnding}, kDocumentEnding);
}

FileKind fileKind(std::string_view bytes) {
    if (isDatabase(bytes)) {
        const bool own = databaseHead(bytes).applicationId == schema::kApplicationId;
        return own ? FileKind::Document : FileKind::Other;
    }
    const std::string_view text = trimmed(bytes);
    if (!text.starts_with('{')) return FileKind::Other;
    // Both kinds of file name their format at their beginning; a script might also do it behind
    // its steps, where its name tells what it is.
    constexpr std::size_t kLookedAt = 4096;
    const std::string_view head = text.substr(0, kLookedAt);
    const auto document = head.find("\"edgewright-document\"");
    const auto script = head.find("\"edgewright-sketch\"");
    if (document == script) return FileKind::Json;
    return document < script ? FileKind::Document : FileKind::Script;
}

Result<void> refuseOtherKinds(const std::string& name, std::string_view bytes) {
    if (fileKind(bytes) != FileKind::Other) return {};
    std::string text = name + " is no Edgewright document or sketch script: it holds ";
    return fail(Errc::WrongFormat, text.append(contentWords(bytes)).append("."));
}

}  // namespace ew
