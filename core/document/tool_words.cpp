// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/tool_words.h"

namespace ew {

Result<ToolWords> readToolWords(const QStringList& words, const QStringList& commands,
                                const std::vector<std::pair<const char*, QString*>>& options,
                                const QStringList& alone) {
    ToolWords out;
    for (qsizetype i = 0; i < words.size(); ++i) {
        const QString& word = words[i];
        if (word == QStringLiteral("--json")) {
            out.json = true;
            continue;
        }
        QString* value = nullptr;
        for (const auto& [name, to] : options) {
            if (word == QLatin1String(name)) value = to;
        }
        if (value != nullptr) {
            if (i + 1 == words.size()) {
                return fail(Errc::BadValue, word.toStdString() + " needs a value");
            }
            *value = words[++i];
        } else if (word.startsWith(QStringLiteral("--"))) {
            return fail(Errc::BadValue, "unknown option " + word.toStdString());
        } else if (out.command.isEmpty()) {
            out.command = word;
        } else {
            out.files << word;
        }
    }
    if (!commands.contains(out.command)) {
        return fail(Errc::BadValue,
                    "say one of: " + commands.join(QStringLiteral(", ")).toStdString());
    }
    if (out.files.isEmpty() && !alone.contains(out.command)) {
        return fail(Errc::BadValue, "no file is named");
    }
    return out;
}

}  // namespace ew
