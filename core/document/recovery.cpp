// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/recovery.h"

#include <QDir>
#include <QFileInfo>

#include "core/document/file_names.h"
#include "core/document/json_text.h"

namespace ew {

namespace {

using Json = nlohmann::ordered_json;

Json entryJson(const WorkCopyEntry& entry) {
    Json out{{"path", entry.path.toStdString()},
             {"title", entry.summary.title},
             {"steps", entry.summary.steps},
             {"strokes", entry.summary.strokes},
             {"time", entry.time.toUTC().toString(Qt::ISODateWithMs).toStdString()},
             {"document", entry.note.documentPath.toStdString()},
             {"open", entry.open},
             {"lost", entry.lost()},
             {"saved", entry.saved}};
    if (entry.problem) {
        out["error"] = {{"code", errcName(entry.problem->code)},
                        {"message", entry.problem->message}};
    }
    return out;
}

}  // namespace

Result<std::string> recoverCopies(const WorkFolder& folder, const std::optional<QString>& outFolder,
                                  const TemplateLibrary& shipped) {
    if (!QFileInfo(folder.path()).isDir()) {
        return fail(Errc::FileNotFound, "There is no folder " + folder.path().toStdString() + ".");
    }
    if (outFolder && !QDir().mkpath(*outFolder)) {
        return fail(Errc::CannotWrite,
                    "The folder " + outFolder->toStdString() + " cannot be made.");
    }
    Json list = Json::array();
    for (const WorkCopyEntry& entry : folder.list()) {
        Json item = entryJson(entry);
        if (outFolder && !entry.open && !entry.problem) {
            const auto file = folder.read(entry, shipped);
            if (!file) {
                item["error"] = {{"code", errcName(file.error().code)},
                                 {"message", file.error().message}};
            } else {
                const QString path =
                    QDir(*outFolder).absoluteFilePath(QFileInfo(entry.path).fileName());
                if (auto ok = saveDocument(*file, path); !ok) return fail(ok.error());
                item["restored"] = path.toStdString();
            }
        }
        list.push_back(std::move(item));
    }
    return list.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace ew
