// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <vector>

#include "core/reading/overlay/box_frame.h"

namespace ew {

/// Should a line be where an edge of the box is?
enum class Drawn { Never, Maybe, Surely };

/// A box in a frame: two sides across each axis.
struct Box {
    std::array<std::array<double, 2>, 3> side{};
    std::array<std::array<int, 2>, 3> on{{{-1, -1}, {-1, -1}, {-1, -1}}};  ///< face of the solid
    std::array<std::array<bool, 2>, 3> facesOn{};  ///< ... whose outside is on the same side
    double cost = 0.0;

    bool adds() const { return side[2][1] > 0; }
    /// Does it fill the way from one wall to another that looks at it?
    bool betweenWalls() const {
        for (std::size_t a = 0; a < 2; ++a) {
            if (adds() && on[a][0] >= 0 && on[a][1] >= 0 && !facesOn[a][0] && !facesOn[a][1]) {
                return true;
            }
        }
        return false;
    }
    /// The template's plane: the far side of a cut lies below the face, which turns their order.
    std::size_t plane(std::size_t axis, std::size_t k) const {
        return side[axis][k] > side[axis][1 - k] ? 1 : 0;
    }
    /// Does that side lie in a face of the solid? A cut opens in faces that look its way only.
    bool coincides(std::size_t axis, std::size_t k) const {
        return on[axis][k] >= 0 && (adds() || axis == 2 || facesOn[axis][k]);
    }
};

/// One of the twelve edges: along an axis, at one side of each of the other two.
struct BoxEdge {
    std::size_t axis, b, c;       ///< b and c: the other axes
    std::size_t kb, kc;           ///< which side across those
    double offset = 0.0;          ///< across the axis on the screen, as BoxLine::offset
    double from = 0.0, to = 0.0;  ///< along it, as BoxLine::from
    Drawn drawn = Drawn::Never;
    double covered = 0.0;  ///< by lines [px]
    std::vector<std::size_t> lines;
};

/// Does the side across an axis look at the eye?
/// \param material  of a cut the wall that it leaves is meant, which looks the other way.
bool looksHere(const BoxFrame& frame, const Box& box, std::size_t axis, std::size_t k,
               bool material);

/// The twelve edges, with what is to be seen of them once the change is made.
std::array<BoxEdge, 12> edgesOf(const BoxFrame& frame, const Box& box);

}  // namespace ew
