// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/solid/voxels.h"

#include <algorithm>
#include <map>
#include <numeric>

namespace ew::test {
namespace {

constexpr int kN = Voxels::kSize;

/// Sets of things that are joined two by two.
class Joined {
  public:
    explicit Joined(int count) : parent_(static_cast<std::size_t>(count)) {
        std::iota(parent_.begin(), parent_.end(), 0);
    }
    int root(int i) {
        while (parent_[static_cast<std::size_t>(i)] != i) i = parent_[static_cast<std::size_t>(i)];
        return i;
    }
    void join(int a, int b) { parent_[static_cast<std::size_t>(root(a))] = root(b); }
    int count() {
        int n = 0;
        for (int i = 0; i < static_cast<int>(parent_.size()); ++i) n += root(i) == i ? 1 : 0;
        return n;
    }

  private:
    std::vector<int> parent_;
};

using Place = std::array<int, 3>;

/// The unit squares of the surface, the lattice edges between them and the lattice points.
class Surface {
  public:
    explicit Surface(const Voxels& voxels) : voxels_(voxels) {
        eachPlace([&](int axis, const Place& p) {
            Place below = p;
            --below[static_cast<std::size_t>(axis)];
            if (cell(p) != cell(below)) {
                squareAt_.emplace(key(axis, p), static_cast<int>(squareAt_.size()));
                axisOf_.push_back(axis);
            }
        });
    }

    SurfaceCounts counts() const {
        SurfaceCounts out;
        Joined faces(static_cast<int>(squareAt_.size()));
        Joined shells(static_cast<int>(squareAt_.size()));
        std::map<Place, std::vector<std::array<int, 2>>> creases;  // at a point: axis, direction
        std::map<Place, std::vector<std::array<int, 2>>> joints;   // at a point: pairs of squares
        int latticeEdges = 0;
        eachPlace([&](int axis, const Place& p) {
            const std::vector<int> round = squaresRound(axis, p);
            if (round.empty()) return;
            Place end = p;
            ++end[static_cast<std::size_t>(axis)];
            if (round.size() == 4) {
                out.touchesInEdge = true;
                return;
            }
            ++latticeEdges;
            shells.join(round[0], round[1]);
            for (const Place& at : {p, end}) joints[at].push_back({round[0], round[1]});
            if (axisOf_[static_cast<std::size_t>(round[0])] ==
                axisOf_[static_cast<std::size_t>(round[1])]) {
                faces.join(round[0], round[1]);
            } else {
                creases[p].push_back({axis, 1});
                creases[end].push_back({axis, -1});
            }
        });
        if (out.touchesInEdge) return out;
        for (const auto& [place, pairs] : joints) {
            std::map<int, int> index;
            for (const auto& pair : pairs) {
                for (const int s : pair) index.emplace(s, static_cast<int>(index.size()));
            }
            Joined fans(static_cast<int>(index.size()));
            for (const auto& pair : pairs) fans.join(index.at(pair[0]), index.at(pair[1]));
            out.touchesInPoint |= fans.count() > 1;
        }
        if (out.touchesInPoint) return out;
        int ends = 0;
        for (const auto& [place, list] : creases) {
            if (list.size() == 2 && list[0][0] == list[1][0]) continue;
            ++out.vertices;
            ends += static_cast<int>(list.size());
        }
        out.edges = ends / 2;
        out.faces = faces.count();
        out.shells = shells.count();
        const int euler =
            static_cast<int>(joints.size()) - latticeEdges + static_cast<int>(squareAt_.size());
        out.genus = out.shells - euler / 2;
        return out;
    }

  private:
    template <class Visit>
    static void eachPlace(const Visit& visit) {
        for (int axis = 0; axis < 3; ++axis) {
            for (int x = 0; x <= kN; ++x) {
                for (int y = 0; y <= kN; ++y) {
                    for (int z = 0; z <= kN; ++z) visit(axis, Place{x, y, z});
                }
            }
        }
    }
    static int key(int axis, const Place& p) {
        return ((axis * (kN + 2) + p[0]) * (kN + 2) + p[1]) * (kN + 2) + p[2];
    }
    bool cell(const Place& p) const { return voxels_.at(p[0], p[1], p[2]); }

    /// Surface squares that meet in the lattice edge from p along an axis.
    std::vector<int> squaresRound(int axis, const Place& p) const {
        std::vector<int> out;
        const auto u = static_cast<std::size_t>((axis + 1) % 3);
        const auto v = static_cast<std::size_t>((axis + 2) % 3);
        const auto add = [&](std::size_t normal, Place q) {
            const auto it = squareAt_.find(key(static_cast<int>(normal), q));
            if (it != squareAt_.end()) out.push_back(it->second);
        };
        for (const int step : {0, -1}) {
            Place q = p;
            q[v] += step;
            if (q[v] >= 0) add(u, q);
            q = p;
            q[u] += step;
            if (q[u] >= 0) add(v, q);
        }
        return out;
    }

    const Voxels& voxels_;
    std::map<int, int> squareAt_;
    std::vector<int> axisOf_;  ///< by square
};

}  // namespace

bool Voxels::at(int x, int y, int z) const {
    if (std::min({x, y, z}) < 0 || std::max({x, y, z}) >= kN) return false;
    return cells_[static_cast<std::size_t>((x * kN + y) * kN + z)];
}

void Voxels::combine(const IntBox& box, BooleanKind kind) {
    for (int x = 0; x < kN; ++x) {
        for (int y = 0; y < kN; ++y) {
            for (int z = 0; z < kN; ++z) {
                const bool in = x >= box.low[0] && x < box.high[0] && y >= box.low[1] &&
                                y < box.high[1] && z >= box.low[2] && z < box.high[2];
                const auto i = static_cast<std::size_t>((x * kN + y) * kN + z);
                if (kind == BooleanKind::Add && in) cells_[i] = true;
                if (kind == BooleanKind::Cut && in) cells_[i] = false;
                if (kind == BooleanKind::Intersect && !in) cells_[i] = false;
            }
        }
    }
}

bool Voxels::empty() const { return std::find(cells_.begin(), cells_.end(), true) == cells_.end(); }

SurfaceCounts Voxels::counts() const {
    SurfaceCounts out = Surface(*this).counts();
    out.volume = static_cast<int>(std::count(cells_.begin(), cells_.end(), true));
    return out;
}

std::ostream& operator<<(std::ostream& out, const SurfaceCounts& c) {
    return out << "volume " << c.volume << ", " << c.vertices << " vertices, " << c.edges
               << " edges, " << c.faces << " faces, " << c.shells << " shells, genus " << c.genus;
}

}  // namespace ew::test
