// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

namespace ew {

/// An id that is well-formed, for a name: "House with a roof" -> "house-with-a-roof"; at most 64 of
/// [a-z0-9-]. Empty where the name has no letter or digit of these.
std::string idFromName(const std::string& name);

/// The id itself where no template has it, else with the first number behind it that is free.
/// \param taken  does a template have this id?
template <class Taken>
std::string freeId(const std::string& wanted, const Taken& taken) {
    constexpr std::size_t kRoomForNumber = 58;
    const std::string base = wanted.empty() ? std::string("template") : wanted;
    std::string id = base;
    for (int i = 2; taken(id); ++i) id = base.substr(0, kRoomForNumber) + "-" + std::to_string(i);
    return id;
}

}  // namespace ew
