// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <numeric>
#include <vector>

namespace ew {

/// Numbers 0..n-1 in groups that can be joined. Nearly O(1) a call.
class DisjointSets {
  public:
    explicit DisjointSets(std::size_t n) : parent_(n) {
        std::iota(parent_.begin(), parent_.end(), 0);
    }

    /// One number of the group, the same for all of it until the next join.
    int root(int i) {
        while (parent(i) != i) i = parent(i) = parent(parent(i));
        return i;
    }

    /// The root of `into` becomes the root of both groups.
    void join(int i, int into) { parent(root(i)) = root(into); }

  private:
    int& parent(int i) { return parent_[static_cast<std::size_t>(i)]; }

    std::vector<int> parent_;
};

}  // namespace ew
