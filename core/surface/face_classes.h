// SPDX-License-Identifier: GPL-3.0-or-later
// Private to core/surface.
#pragma once

#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

#include "core/surface/cage_edges.h"

namespace ew {

/// Sorts the faces of a control cage by the topology and sharpness of what is round them, which is
/// all that the weights of their surfaces depend on: faces of one class have the same weights for
/// corresponding points.
class FaceClasses {
  public:
    /// \pre the cage is closed, its faces have no holes.
    FaceClasses(const ControlCage& cage, const CageEdges& edges);

    int of(int face) const { return class_[static_cast<std::size_t>(face)]; }
    int count() const { return static_cast<int>(size_.size()); }
    /// How many faces are in a class.
    int size(int index) const { return size_[static_cast<std::size_t>(index)]; }
    /// The points of a face and of all faces that touch it, each once; those of the faces of one
    /// class correspond.
    std::span<const int> hull(int face) const {
        const auto f = static_cast<std::size_t>(face);
        return {hull_.data() + hullStart_[f], hull_.data() + hullStart_[f + 1]};
    }

  private:
    void describe(int face);
    int classify();

    const PolyMesh& mesh_;
    const CageEdges& edges_;
    std::vector<int> class_;
    std::vector<int> size_;
    std::vector<int> hull_;
    std::vector<std::size_t> hullStart_{0};
    std::vector<std::uint32_t> key_;  ///< of the face under way
    std::vector<std::vector<std::uint32_t>> keys_;
    std::unordered_map<std::uint64_t, int> byHash_;
    std::vector<int> seen_;   ///< by point: the last face that has it in its hull
    std::vector<int> place_;  ///< by point: its place in that hull
};

}  // namespace ew
