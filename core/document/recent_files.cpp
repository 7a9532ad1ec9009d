// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/recent_files.h"

#include <QByteArray>
#include <QDir>
#include <QFileInfo>
#include <algorithm>
#include <tuple>

#include "core/document/file_bytes.h"
#include "core/document/json_text.h"
#include "core/document/work_folder.h"

namespace ew {

namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t kMaxListBytes = 64U << 20U;
constexpr const char* kFormat = "edgewright-recent";

std::string textOf(const nlohmann::json& value) {
    return value.is_string() ? value.get<std::string>() : std::string();
}

/// What a list says; what it does not say right is left out, since it is no more than a help.
std::vector<RecentFile> readList(const QString& path) {
    std::vector<RecentFile> files;
    const auto text = readFileBytes(path, kMaxListBytes);
    if (!text) return files;
    const auto tree = parseJson(*text, {.maxBytes = kMaxListBytes});
    if (!tree || !tree->is_object()) return files;
    const auto list = tree->find("files");
    if (tree->value("format", nlohmann::json()) != kFormat || list == tree->end()) return files;
    for (const nlohmann::json& item : *list) {
        if (!item.is_object()) continue;
        RecentFile file;
        file.path = QString::fromStdString(textOf(item.value("path", nlohmann::json())));
        if (!QDir::isAbsolutePath(file.path)) continue;
        file.used = QDateTime::fromString(
            QString::fromStdString(textOf(item.value("used", nlohmann::json()))),
            Qt::ISODateWithMs);
        file.pinned = item.value("pinned", nlohmann::json()) == true;
        file.thumbnail =
            QByteArray::fromBase64(
                QByteArray::fromStdString(textOf(item.value("thumbnail", nlohmann::json()))))
                .toStdString();
        files.push_back(std::move(file));
    }
    return files;
}

std::string listText(const std::vector<RecentFile>& files) {
    Json list = Json::array();
    for (const RecentFile& file : files) {
        const QByteArray png = QByteArray::fromStdString(file.thumbnail).toBase64();
        list.push_back({{"path", file.path.toStdString()},
                        {"used", file.used.toUTC().toString(Qt::ISODateWithMs).toStdString()},
                        {"pinned", file.pinned},
                        {"thumbnail", png.toStdString()}});
    }
    const Json all{{"format", kFormat}, {"version", 1}, {"files", std::move(list)}};
    return all.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

/// The pinned ones first, then the newest.
void order(std::vector<RecentFile>& files) {
    std::stable_sort(files.begin(), files.end(), [](const RecentFile& a, const RecentFile& b) {
        return std::tie(b.pinned, b.used) < std::tie(a.pinned, a.used);
    });
}

auto find(std::vector<RecentFile>& files, const QString& path) {
    const QString wanted = QFileInfo(path).absoluteFilePath();
    return std::find_if(files.begin(), files.end(),
                        [&](const RecentFile& file) { return file.path == wanted; });
}

}  // namespace

QString RecentFiles::standardPath() {
    return QFileInfo(WorkFolder::standardPath()).absolutePath() + QStringLiteral("/recent.json");
}

std::vector<RecentFile> RecentFiles::list() const {
    std::vector<RecentFile> files = readList(path_);
    order(files);
    for (RecentFile& file : files) file.missing = !QFileInfo(file.path).isFile();
    return files;
}

template <class Change>
Result<void> RecentFiles::change(const Change& change) {
    if (!QDir().mkpath(QFileInfo(path_).absolutePath())) {
        return fail(Errc::CannotWrite, "The folder of " + path_.toStdString() + " cannot be made.");
    }
    // Another window may be at it; it holds the lock no longer than it takes to write.
    const auto lock = WorkLock::wait(path_ + QStringLiteral(".lock"));
    std::vector<RecentFile> files = readList(path_);
    change(files);
    order(files);
    int loose = 0;
    std::erase_if(files, [&](const RecentFile& file) { return !file.pinned && ++loose > kMost; });
    return writeFileBytes(path_, listText(files));
}

Result<void> RecentFiles::add(const QString& path, const std::string& thumbnail) {
    return change([&](std::vector<RecentFile>& files) {
        RecentFile file;
        const auto known = find(files, path);
        if (known != files.end()) {
            file = *known;
            files.erase(known);
        }
        file.path = QFileInfo(path).absoluteFilePath();
        file.used = QDateTime::currentDateTimeUtc();
        if (!thumbnail.empty()) file.thumbnail = thumbnail;
        files.insert(files.begin(), std::move(file));
    });
}

Result<void> RecentFiles::setPinned(const QString& path, bool pinned) {
    return change([&](std::vector<RecentFile>& files) {
        const auto known = find(files, path);
        if (known != files.end()) known->pinned = pinned;
    });
}

Result<void> RecentFiles::remove(const QString& path) {
    return change([&](std::vector<RecentFile>& files) {
        const auto known = find(files, path);
        if (known != files.end()) files.erase(known);
    });
}

}  // namespace ew
