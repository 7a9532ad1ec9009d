// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/practice/practice_log.h"

#include <QDir>
#include <QFileInfo>

#include "core/document/file_bytes.h"
#include "core/document/json_text.h"
#include "core/document/practice/practice_json.h"
#include "core/document/work_folder.h"

namespace ew {

using Json = nlohmann::ordered_json;

namespace {

constexpr const char* kFormat = "edgewright-practice-log";
constexpr std::size_t kMaxLogBytes = 1U << 20U;
}  // namespace

void addResult(std::vector<PracticeResult>& results, const PracticeResult& result) {
    results.push_back(result);
    if (results.size() > kMostResults) results.erase(results.begin());
}

QString PracticeLog::standardPath() {
    return QFileInfo(WorkFolder::standardPath()).absolutePath() + QStringLiteral("/practice.json");
}

Result<std::vector<PracticeResult>> PracticeLog::list() const {
    if (!QFileInfo::exists(path_)) return std::vector<PracticeResult>();
    const auto text = readFileBytes(path_, kMaxLogBytes);
    if (!text) return fail(text.error());
    const std::string source = path_.toStdString() + ": ";
    auto tree = parseJson(*text, {.maxBytes = kMaxLogBytes});
    if (!tree) return fail(tree.error().code, source + tree.error().message);
    try {
        const ObjectReader in(*tree, source + "/");
        if (in.require("format") != kFormat || in.require("version") != 1) {
            throwRead(Errc::WrongFormat, source + "/format: this is no practice log");
        }
        return practiceFromJson(in.require("results"), source + "/results");
    } catch (ReadError& e) {
        return fail(std::move(e.error));
    }
}

Result<void> PracticeLog::add(const PracticeResult& result) const {
    if (!QDir().mkpath(QFileInfo(path_).absolutePath())) {
        return fail(
            Errc::CannotWrite,
            "The folder " + QFileInfo(path_).absolutePath().toStdString() + " cannot be made.");
    }
    // Another window may be at it.
    const auto lock = WorkLock::wait(path_ + QStringLiteral(".lock"));
    auto results = list();
    if (!results) return fail(results.error());
    addResult(*results, result);
    const Json all{{"format", kFormat}, {"version", 1}, {"results", practiceJson(*results)}};
    return writeFileBytes(path_, all.dump(1) + "\n");
}

}  // namespace ew
