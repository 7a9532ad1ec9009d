// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>
#include <QStringList>
#include <utility>
#include <vector>

#include "core/base/result.h"

namespace ew {

/// What the command line of a program for authors says: a command, files, options.
struct ToolWords {
    QString command;
    QStringList files;
    bool json = false;
};

/// Reads `COMMAND FILE... [--json] [--OPTION VALUE...]`, in any order.
/// \param commands  the commands there are.
/// \param options   the names of options with a value, and where it goes.
/// \param alone     those of the commands that need no file.
/// Errors: BadValue, with a sentence to say.
Result<ToolWords> readToolWords(const QStringList& words, const QStringList& commands,
                                const std::vector<std::pair<const char*, QString*>>& options,
                                const QStringList& alone = {});

}  // namespace ew
