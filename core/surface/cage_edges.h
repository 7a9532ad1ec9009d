// SPDX-License-Identifier: GPL-3.0-or-later
// Private to core/surface.
#pragma once

#include <span>
#include <vector>

#include "core/surface/control_cage.h"

namespace ew {

/// The edges of a closed control cage and what is sharp about them.
class CageEdges {
  public:
    struct Side {
        int edge = -1;
    };

    explicit CageEdges(const ControlCage& cage);

    int count() const { return static_cast<int>(hard_.size()); }
    /// By corner of a face: the edge from there to the next corner.
    std::span<const Side> of(int face) const {
        const auto f = static_cast<std::size_t>(face);
        return {sides_.data() + start_[f], sides_.data() + start_[f + 1]};
    }
    /// Infinitely sharp.
    bool hard(int edge) const { return hard_[static_cast<std::size_t>(edge)]; }
    /// A corner, or on a hard edge.
    bool hardPoint(int point) const { return hardPoint_[static_cast<std::size_t>(point)]; }
    bool anyHard() const { return anyHard_; }
    /// A quadrangle with four faces at each corner and nothing sharp in reach: its surface is one
    /// bicubic B-spline patch.
    bool plain(int face) const { return plain_[static_cast<std::size_t>(face)]; }

  private:
    std::vector<Side> sides_;
    std::vector<std::size_t> start_{0};
    std::vector<bool> hard_;
    std::vector<bool> hardPoint_;
    std::vector<bool> plain_;
    bool anyHard_ = false;
};

}  // namespace ew
