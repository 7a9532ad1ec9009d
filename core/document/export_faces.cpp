// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/export_faces.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace ew {

namespace {
constexpr std::pair<ExportFaces, std::string_view> kNames[] = {
    {ExportFaces::Simple, "simple"},
    {ExportFaces::Triangles, "triangles"},
    {ExportFaces::Polygons, "polygons"},
};
}  // namespace

std::string_view exportFacesName(ExportFaces faces) {
    return std::find_if(std::begin(kNames), std::end(kNames),
                        [&](const auto& pair) { return pair.first == faces; })
        ->second;
}

std::optional<ExportFaces> exportFacesFromName(std::string_view name) {
    const auto* const found = std::find_if(std::begin(kNames), std::end(kNames),
                                           [&](const auto& pair) { return pair.second == name; });
    if (found == std::end(kNames)) return std::nullopt;
    return found->first;
}

}  // namespace ew
