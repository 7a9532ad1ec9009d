// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "core/base/result.h"

namespace ew {

/// What is wrong with a file, as the programs for authors tell it: "FILE: /json/path: sentence".
struct FileFault {
    std::string file;
    std::string path;  ///< JSON path; "/" for the whole file
    std::string message;
    Errc code = Errc::Internal;

    std::string line() const { return file + ": " + path + ": " + message; }
};

/// Takes the message of an error, which may begin with file and JSON path, into its parts.
FileFault fileFault(const std::string& file, const Error& error);

}  // namespace ew
