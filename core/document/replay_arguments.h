// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSize>
#include <QString>
#include <QStringList>
#include <optional>

#include "core/base/result.h"

namespace ew {

/// The command line of edgewright-replay.
struct ReplayArguments {
    QString script;
    QString outFolder = QStringLiteral(".");
    QStringList exports;               ///< relative to the current folder, or absolute
    QString screenshot;                ///< empty: none; relative to the current folder, or absolute
    std::optional<QSize> size;         ///< of the screenshot [px]
    QString report;                    ///< empty: none; relative to the current folder, or absolute
    std::optional<QString> templates;  ///< use this template folder and no other
    bool keepGoing = false;
    bool help = false;
    bool version = false;
};

/// Reads the arguments after the program's name.
/// Errors: UnknownKey (option), MissingKey (no script, an option without its value), BadValue.
Result<ReplayArguments> parseReplayArguments(const QStringList& arguments);

/// Usage, one option a line.
QString replayHelp();

/// "WxH" with 16 <= W, H <= 16384. Errc::BadValue.
Result<QSize> parseSize(const QString& text);

}  // namespace ew
