// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/file_fault.h"

namespace ew {

FileFault fileFault(const std::string& file, const Error& error) {
    FileFault fault{file, "/", error.message, error.code};
    if (fault.message.starts_with(file + ": ")) fault.message.erase(0, file.size() + 2);
    const std::size_t end = fault.message.find(": ");
    if (!fault.message.empty() && fault.message.front() == '/' && end != std::string::npos) {
        fault.path = fault.message.substr(0, end);
        fault.message.erase(0, end + 2);
    }
    return fault;
}

}  // namespace ew
