// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/surface/cage_edges.h"

#include <algorithm>

namespace ew {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

}  // namespace

CageEdges::CageEdges(const ControlCage& cage) : mesh_(&cage.mesh) {
    number();
    readSharpness(cage);
}

void CageEdges::number() {
    const std::vector<int>& corners = mesh_->corners;
    edge_.assign(corners.size(), -1);
    twin_.assign(corners.size(), -1);
    face_.reserve(corners.size());
    outStart_.assign(mesh_->points.size() + 1, 0);
    for (const int v : corners) ++outStart_[at(v) + 1];
    for (std::size_t v = 1; v < outStart_.size(); ++v) outStart_[v] += outStart_[v - 1];
    out_.resize(corners.size());
    std::vector<std::size_t> fill(outStart_.begin(), outStart_.end() - 1);
    std::vector<int> target(corners.size());
    for (int f = 0; f < mesh_->faceCount(); ++f) {
        const int last = firstSide(f + 1) - 1;
        for (int s = firstSide(f); s <= last; ++s) {
            face_.push_back(f);
            target[at(s)] = corners[at(s < last ? s + 1 : firstSide(f))];
            out_[fill[at(corners[at(s)])]++] = s;
        }
    }
    for (std::size_t v = 0; v + 1 < outStart_.size(); ++v) {
        std::sort(out_.begin() + static_cast<std::ptrdiff_t>(outStart_[v]),
                  out_.begin() + static_cast<std::ptrdiff_t>(outStart_[v + 1]),
                  [&](int a, int b) { return target[at(a)] < target[at(b)]; });
    }
    // Twins: the sides from a to b and from b to a, by a search among the few that leave b.
    int edges = 0;
    for (std::size_t s = 0; s < corners.size(); ++s) {
        if (twin_[s] >= 0) continue;
        const auto first = out_.begin() + static_cast<std::ptrdiff_t>(outStart_[at(target[s])]);
        const auto last = out_.begin() + static_cast<std::ptrdiff_t>(outStart_[at(target[s]) + 1]);
        const auto back = std::lower_bound(first, last, corners[s],
                                           [&](int t, int to) { return target[at(t)] < to; });
        twin_[s] = *back;
        twin_[at(*back)] = static_cast<int>(s);
        edge_[s] = edge_[at(*back)] = edges++;
    }
    sharpness_.assign(at(edges), 0.0F);
}

int CageEdges::find(int a, int b) const {
    for (std::size_t i = outStart_[at(a)]; i < outStart_[at(a) + 1]; ++i) {
        if (mesh_->corners[at(twin(out_[i]))] == b) return edge(out_[i]);
    }
    return -1;
}

void CageEdges::readSharpness(const ControlCage& cage) {
    pointSharpness_.assign(mesh_->points.size(), 0.0F);
    hardPoint_.assign(mesh_->points.size(), false);
    for (const CreaseEdge& c : cage.creases) {
        const int e = c.sharpness > 0.0 ? find(c.from, c.to) : -1;
        if (e < 0) continue;
        sharpness_[at(e)] = static_cast<float>(std::min(c.sharpness, kInfiniteSharpness));
        if (!hard(e)) continue;
        hardPoint_[at(c.from)] = hardPoint_[at(c.to)] = anyHard_ = true;
    }
    for (const SharpPoint& c : cage.corners) {
        if (c.sharpness <= 0.0) continue;
        pointSharpness_[at(c.point)] =
            static_cast<float>(std::min(c.sharpness, kInfiniteSharpness));
        hardPoint_[at(c.point)] = anyHard_ = true;
    }
}

}  // namespace ew
