// SPDX-License-Identifier: GPL-3.0-or-later
// Private to core/surface.
#pragma once

#include <span>
#include <vector>

#include "core/surface/control_cage.h"

namespace ew {

/// The edges of a closed control cage and what is sharp about them. A side is one face's part of an
/// edge; it has the number of the corner that it begins at, in PolyMesh::corners.
class CageEdges {
  public:
    /// \pre the cage is closed, its faces have no holes.
    explicit CageEdges(const ControlCage& cage);

    int count() const { return static_cast<int>(sharpness_.size()); }
    /// By corner of a face: the edge from there to the next corner.
    std::span<const int> of(int face) const {
        const auto first = static_cast<std::size_t>(firstSide(face));
        return {edge_.data() + first, edge_.data() + firstSide(face + 1)};
    }
    int firstSide(int face) const { return mesh_->loopStart[static_cast<std::size_t>(face)]; }
    int faceOf(int side) const { return face_[static_cast<std::size_t>(side)]; }
    /// The same edge as the face beyond it has it.
    int twin(int side) const { return twin_[static_cast<std::size_t>(side)]; }
    int edge(int side) const { return edge_[static_cast<std::size_t>(side)]; }

    /// Faces, and edges, that meet in a point.
    int valence(int point) const {
        const auto p = static_cast<std::size_t>(point);
        return static_cast<int>(outStart_[p + 1] - outStart_[p]);
    }

    /// 0 smooth .. kInfiniteSharpness.
    float sharpness(int edge) const { return sharpness_[static_cast<std::size_t>(edge)]; }
    float pointSharpness(int point) const {
        return pointSharpness_[static_cast<std::size_t>(point)];
    }
    /// Infinitely sharp.
    bool hard(int edge) const { return sharpness(edge) >= kInfiniteSharpness; }
    /// A corner, or on a hard edge.
    bool hardPoint(int point) const { return hardPoint_[static_cast<std::size_t>(point)]; }
    bool anyHard() const { return anyHard_; }

  private:
    void number();
    void readSharpness(const ControlCage& cage);
    int find(int a, int b) const;

    const PolyMesh* mesh_;
    std::vector<int> edge_;  ///< by side, in the three
    std::vector<int> face_;
    std::vector<int> twin_;
    std::vector<std::size_t> outStart_;  ///< sides by the point that they begin at
    std::vector<int> out_;
    std::vector<float> sharpness_;
    std::vector<float> pointSharpness_;
    std::vector<bool> hardPoint_;
    bool anyHard_ = false;
};

}  // namespace ew
