// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSize>
#include <QString>
#include <QStringList>
#include <optional>
#include <vector>

#include "core/base/result.h"
#include "core/document/export_options.h"

namespace ew {

/// How a picture of the viewport looks.
struct PictureLook {
    bool transparent = false;  ///< nothing behind bodies and ink, not even the grid
    bool cage = false;         ///< the cage is shown over surfaces
    bool hiddenEdges = false;  ///< as dashes
    bool dark = false;         ///< colours of the dark theme
    bool occlusion = false;    ///< corners and hollows are darker, as under an even sky
    bool operator==(const PictureLook&) const = default;
};

/// Sets what one of --transparent, --cage, --hidden-edges, --dark, --occlusion stands for; false
/// where the name is none of them.
bool readLookOption(const QString& name, PictureLook& look);
/// The options that set a look.
QStringList lookOptions(const PictureLook& look);

/// The command line of edgewright-replay.
struct ReplayArguments {
    QString script;  ///< or document
    QString outFolder = QStringLiteral(".");
    ExportFaces faces = ExportFaces::Simple;   ///< of exports
    ExportUnit unit = ExportUnit::Millimetre;  ///< of exports to formats that have none
    std::vector<int> bodies;                   ///< that are exported; empty: all
    QString changedStep;                       ///< empty: none; which step of a document's history
                                               ///< is changed, from 0, ...
    QString stepText;                          ///< ... and the step that it becomes, as JSON
    QStringList exports;                       ///< relative to the current folder, or absolute
    QString screenshot;                ///< empty: none; relative to the current folder, or absolute
    std::optional<QSize> size;         ///< of the screenshot [px]
    PictureLook look;                  ///< of the screenshot
    QString until;                     ///< empty: to the end; else as findStep() wants it
    QString report;                    ///< empty: none; relative to the current folder, or absolute
    std::optional<QString> templates;  ///< use this template folder and no other
    QString save;                      ///< empty: no; where the document is written at the end
    QString saveScript;                ///< empty: no; where what was done is written as a script
    QString workCopy;                  ///< empty: none; folder for a working copy
    QString recover;        ///< empty: no; folder of working copies to list, and to restore where
                            ///< outFolder is named
    bool namesOut = false;  ///< --out was given
    bool progress = false;  ///< tell of each step when it is done
    bool keepGoing = false;
    bool allowOutside = false;  ///< steps may write and open files outside their folders
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
