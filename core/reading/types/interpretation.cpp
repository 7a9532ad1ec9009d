// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reading/types/interpretation.h"

namespace ew {

std::string_view operationName(Operation op) {
    switch (op) {
        case Operation::Auto:
            return "auto";
        case Operation::Create:
            return "create";
        case Operation::Add:
            return "add";
        case Operation::Cut:
            return "cut";
        case Operation::Split:
            return "split";
    }
    return "auto";
}

}  // namespace ew
