// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/export_options.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <iterator>

namespace ew {

namespace {

struct Unit {
    ExportUnit unit;
    std::string_view name;
    double perMm;
};

constexpr double kMmPerInch = 25.4;
constexpr Unit kUnits[] = {
    {ExportUnit::Millimetre, "mm", 1.0},
    {ExportUnit::Centimetre, "cm", 0.1},
    {ExportUnit::Metre, "m", 0.001},
    {ExportUnit::Inch, "inch", 1.0 / kMmPerInch},
};

const Unit& of(ExportUnit unit) {
    return *std::find_if(std::begin(kUnits), std::end(kUnits),
                         [&](const Unit& u) { return u.unit == unit; });
}

}  // namespace

std::string_view exportUnitName(ExportUnit unit) { return of(unit).name; }

std::optional<ExportUnit> exportUnitFromName(std::string_view name) {
    const auto* const found = std::find_if(std::begin(kUnits), std::end(kUnits),
                                           [&](const Unit& u) { return u.name == name; });
    if (found == std::end(kUnits)) return std::nullopt;
    return found->unit;
}

double unitsPerMm(ExportUnit unit) { return of(unit).perMm; }

bool formatLacksUnit(const std::string& path) {
    constexpr std::array<std::string_view, 3> kFormats{".obj", ".stl", ".ply"};
    return std::any_of(kFormats.begin(), kFormats.end(), [&](std::string_view ending) {
        return path.size() >= ending.size() &&
               std::equal(
                   ending.begin(), ending.end(),
                   path.end() - static_cast<std::ptrdiff_t>(ending.size()), [](char a, char b) {
                       return a == static_cast<char>(std::tolower(static_cast<unsigned char>(b)));
                   });
    });
}

}  // namespace ew
