// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/document/polygons.h"

#include <algorithm>
#include <array>
#include <map>

namespace ew {

namespace {

/// Joins two polygons along the edge a-b of the first; nothing where a point would come twice.
std::vector<int> joined(const std::vector<int>& first, std::size_t side,
                        const std::vector<int>& second) {
    const int a = first[side];
    const int b = first[(side + 1) % first.size()];
    std::vector<int> out;
    for (std::size_t k = 0; k < first.size(); ++k) {
        out.push_back(first[(side + 1 + k) % first.size()]);  // b ... a
    }
    const auto at = std::find(second.begin(), second.end(), a);
    auto k = static_cast<std::size_t>(at - second.begin());
    for (k = (k + 1) % second.size(); second[k] != b; k = (k + 1) % second.size()) {
        out.push_back(second[k]);
    }
    std::vector<int> sorted = out;
    std::sort(sorted.begin(), sorted.end());
    const bool twice = std::adjacent_find(sorted.begin(), sorted.end()) != sorted.end();
    return twice ? std::vector<int>() : out;
}

}  // namespace

std::vector<std::vector<int>> joinTriangles(std::vector<std::vector<int>> pieces) {
    std::map<std::array<int, 2>, std::size_t> pieceAt;  // directed edge -> piece on its left
    std::vector<std::array<int, 2>> edges;
    for (std::size_t p = 0; p < pieces.size(); ++p) {
        for (std::size_t k = 0; k < pieces[p].size(); ++k) {
            edges.push_back({pieces[p][k], pieces[p][(k + 1) % pieces[p].size()]});
            pieceAt[edges.back()] = p;
        }
    }
    for (const auto& edge : edges) {
        const auto back = pieceAt.find({edge[1], edge[0]});
        const auto here = pieceAt.find(edge);
        if (here == pieceAt.end() || back == pieceAt.end() || here->second == back->second)
            continue;
        const std::size_t keep = here->second;
        const std::size_t drop = back->second;
        const auto& piece = pieces[keep];
        std::size_t side = 0;
        while (piece[side] != edge[0] || piece[(side + 1) % piece.size()] != edge[1]) ++side;
        std::vector<int> whole = joined(piece, side, pieces[drop]);
        if (whole.empty()) continue;
        pieceAt.erase(here);
        pieceAt.erase(back);
        pieces[keep] = std::move(whole);
        pieces[drop].clear();
        for (std::size_t k = 0; k < pieces[keep].size(); ++k) {
            pieceAt[{pieces[keep][k], pieces[keep][(k + 1) % pieces[keep].size()]}] = keep;
        }
    }
    std::erase_if(pieces, [](const std::vector<int>& p) { return p.empty(); });
    return pieces;
}

std::vector<std::vector<int>> facePolygons(const Solid& solid) {
    std::vector<std::vector<std::vector<int>>> triangles(solid.faces().size());
    for (const SolidTriangle& t : solid.triangles()) {
        triangles[static_cast<std::size_t>(t.face)].push_back(
            {t.vertices.begin(), t.vertices.end()});
    }
    std::vector<std::vector<int>> out;
    for (std::size_t f = 0; f < solid.faces().size(); ++f) {
        const auto& loops = solid.faces()[f].loops;
        std::vector<int> sorted = loops[0];
        std::sort(sorted.begin(), sorted.end());
        // An outline that meets itself in a point is no simple polygon either.
        const bool simple = std::adjacent_find(sorted.begin(), sorted.end()) == sorted.end();
        if (loops.size() == 1 && simple) {
            out.push_back(loops[0]);
            continue;
        }
        for (auto& polygon : joinTriangles(std::move(triangles[f]))) {
            out.push_back(std::move(polygon));
        }
    }
    return out;
}

}  // namespace ew
