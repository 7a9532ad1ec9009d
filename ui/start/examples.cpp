// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/start/examples.h"

#include <QDir>
#include <QFileInfo>
#include <algorithm>
#include <variant>

#include "core/document/file_bytes.h"
#include "core/document/resources.h"
#include "core/document/sketch_script.h"
#include "ui/core_text.h"

namespace ew {

namespace {

/// Is a step one of those that the history lists?
bool isCommand(const ScriptStep& step) {
    return !std::holds_alternative<CameraStep>(step) &&
           !std::holds_alternative<ThresholdsStep>(step) &&
           !std::holds_alternative<StrokeStep>(step) && !std::holds_alternative<EraseStep>(step) &&
           !std::holds_alternative<ClearStep>(step) && !std::holds_alternative<UndoStep>(step) &&
           !std::holds_alternative<RedoStep>(step) && !std::holds_alternative<SaveStep>(step) &&
           !std::holds_alternative<OpenStep>(step) && !std::holds_alternative<ExportStep>(step);
}

}  // namespace

std::vector<Example> examples() {
    std::vector<Example> found;
    const auto resources = resourcesFolder();
    if (!resources) return found;
    const QDir folder(*resources + QStringLiteral("/examples"));
    for (const QFileInfo& file : folder.entryInfoList({"*.json"}, QDir::Files, QDir::Name)) {
        Example example;
        example.path = file.absoluteFilePath();
        example.title = file.completeBaseName();
        example.picture = folder.absoluteFilePath(file.completeBaseName() + ".png");
        if (const auto text = readFileBytes(example.path, kMaxScriptBytes)) {
            if (const auto script = readSketchScript(*text)) {
                if (!script->title.empty()) example.title = coreText(script->title);
                example.steps = static_cast<int>(
                    std::count_if(script->steps.begin(), script->steps.end(), isCommand));
            }
        }
        found.push_back(std::move(example));
    }
    return found;
}

}  // namespace ew
