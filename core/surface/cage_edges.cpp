// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/surface/cage_edges.h"

#include <algorithm>

namespace ew {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

}  // namespace

CageEdges::CageEdges(const ControlCage& cage) {
    const PolyMesh& mesh = cage.mesh;
    struct Ends {
        int low;
        int high;
        std::size_t side;
    };
    std::vector<Ends> all;
    all.reserve(mesh.corners.size());
    for (int f = 0; f < mesh.faceCount(); ++f) {
        const auto loop = mesh.outline(f);
        for (std::size_t k = 0; k < loop.size(); ++k) {
            const int a = loop[k];
            const int b = loop[(k + 1) % loop.size()];
            all.push_back({std::min(a, b), std::max(a, b), all.size()});
        }
        start_.push_back(all.size());
    }
    sides_.resize(all.size());
    const auto less = [](const Ends& a, const Ends& b) {
        return std::pair(a.low, a.high) < std::pair(b.low, b.high);
    };
    std::sort(all.begin(), all.end(), less);
    std::vector<Ends> unique;
    for (const Ends& e : all) {
        if (unique.empty() || less(unique.back(), e)) unique.push_back(e);
        sides_[e.side].edge = static_cast<int>(unique.size()) - 1;
    }
    hard_.assign(unique.size(), false);
    hardPoint_.assign(mesh.points.size(), false);
    std::vector<bool> sharpPoint(mesh.points.size(), false);
    for (const CreaseEdge& c : cage.creases) {
        if (c.sharpness <= 0.0) continue;
        const Ends key{std::min(c.from, c.to), std::max(c.from, c.to), 0};
        const auto it = std::lower_bound(unique.begin(), unique.end(), key, less);
        if (it == unique.end() || less(key, *it)) continue;
        for (const int end : {c.from, c.to}) {
            sharpPoint[at(end)] = true;
            if (c.sharpness >= kInfiniteSharpness) hardPoint_[at(end)] = true;
        }
        if (c.sharpness >= kInfiniteSharpness) {
            hard_[static_cast<std::size_t>(it - unique.begin())] = true;
            anyHard_ = true;
        }
    }
    for (const SharpPoint& c : cage.corners) {
        if (c.sharpness <= 0.0) continue;
        sharpPoint[at(c.point)] = true;
        hardPoint_[at(c.point)] = true;
        anyHard_ = true;
    }
    std::vector<int> faces(mesh.points.size(), 0);
    std::vector<bool> irregular(mesh.points.size(), false);
    for (int f = 0; f < mesh.faceCount(); ++f) {
        for (const int v : mesh.outline(f)) {
            ++faces[at(v)];
            if (mesh.outline(f).size() != 4) irregular[at(v)] = true;
        }
    }
    plain_.resize(at(mesh.faceCount()));
    for (int f = 0; f < mesh.faceCount(); ++f) {
        const auto loop = mesh.outline(f);
        plain_[at(f)] = loop.size() == 4 && std::all_of(loop.begin(), loop.end(), [&](int v) {
                            return faces[at(v)] == 4 && !sharpPoint[at(v)] && !irregular[at(v)];
                        });
    }
}

}  // namespace ew
