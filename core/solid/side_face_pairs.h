// SPDX-License-Identifier: GPL-3.0-or-later
// Private to core/solid.
#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <unordered_map>
#include <vector>

#include "core/solid/operand.h"

namespace ew {

/// The sides and the faces of a solid, or of a part of it, and which of them come near each other.
class SideFacePairs {
  public:
    struct Side {
        int a = -1, b = -1;
        std::array<int, 2> faces{-1, -1};  ///< [1] is -1 where the other face is out of the part
        Box3 box;
    };
    struct Face {
        int face = -1;
        Box3 box;
    };

    /// \param points  rounded.
    /// \param within  the part; null for all.
    /// \param margin  boxes reach that much farther [mm].
    SideFacePairs(const std::vector<Vec3>& points, const std::vector<FaceLoops>& faces,
                  const Box3* within, double margin)
        : points_(points), within_(within), margin_(margin), facesAt_(points.size()) {
        std::unordered_map<std::uint64_t, std::size_t> known;
        for (std::size_t f = 0; f < faces.size(); ++f) {
            Face face;
            face.face = static_cast<int>(f);
            face.box = boxOf(faces[f][0]);
            if (within_ && !within_->intersects(face.box)) continue;
            faces_.push_back(face);
            for (const std::vector<int>& loop : faces[f]) {
                for (std::size_t i = 0; i < loop.size(); ++i) {
                    const int a = loop[i];
                    const int b = loop[i + 1 < loop.size() ? i + 1 : 0];
                    facesAt_[idx(a)].push_back(face.face);
                    addSide(a, b, face.face, known);
                }
            }
        }
        std::sort(sides_.begin(), sides_.end(), ByStart());
        std::sort(faces_.begin(), faces_.end(), ByStart());
    }

    /// Is it a corner of a face of the part?
    bool isCorner(int face, int point) const {
        const auto& list = facesAt_[idx(point)];
        return std::find(list.begin(), list.end(), face) != list.end();
    }

    /// Calls visit(side, face) where the boxes of a side and of a face that it does not belong to
    /// meet, until it returns true. A sweep along x: whatever begins meets what has begun and not
    /// ended.
    template <class Visit>
    bool any(Visit&& visit) const {
        std::vector<const Side*> openSides;
        std::vector<const Face*> openFaces;
        std::size_t s = 0;
        std::size_t f = 0;
        const auto meet = [&](const Side& side, const Face& face) {
            if (side.faces[0] == face.face || side.faces[1] == face.face) return false;
            return side.box.intersects(face.box) && visit(side, face);
        };
        while (s < sides_.size() || f < faces_.size()) {
            const bool side =
                f == faces_.size() || (s < sides_.size() && ByStart()(sides_[s], faces_[f]));
            if (side) {
                const Side& now = sides_[s++];
                dropPassed(openFaces, now.box);
                for (const Face* face : openFaces) {
                    if (meet(now, *face)) return true;
                }
                openSides.push_back(&now);
            } else {
                const Face& now = faces_[f++];
                dropPassed(openSides, now.box);
                for (const Side* other : openSides) {
                    if (meet(*other, now)) return true;
                }
                openFaces.push_back(&now);
            }
        }
        return false;
    }

  private:
    struct ByStart {
        template <class A, class B>
        bool operator()(const A& a, const B& b) const {
            return a.box.min().x() < b.box.min().x();
        }
    };
    static std::size_t idx(int i) { return static_cast<std::size_t>(i); }

    template <class T>
    static void dropPassed(std::vector<const T*>& open, const Box3& now) {
        std::erase_if(open, [&](const T* t) { return t->box.max().x() < now.min().x(); });
    }

    Box3 boxOf(std::span<const int> loop) const {
        Box3 box;
        for (const int v : loop) box.extend(points_[idx(v)]);
        return {box.min() - Vec3::Constant(margin_), box.max() + Vec3::Constant(margin_)};
    }

    void addSide(int a, int b, int face, std::unordered_map<std::uint64_t, std::size_t>& known) {
        Side side;
        side.box = boxOf(std::array<int, 2>{a, b});
        if (within_ && !within_->intersects(side.box)) return;
        const auto low = static_cast<std::uint64_t>(std::min(a, b));
        const auto key = (low << 32U) | static_cast<std::uint64_t>(std::max(a, b));
        const auto [it, fresh] = known.emplace(key, sides_.size());
        if (!fresh) {
            sides_[it->second].faces[1] = face;
            return;
        }
        side.a = a;
        side.b = b;
        side.faces[0] = face;
        sides_.push_back(side);
    }

    const std::vector<Vec3>& points_;
    const Box3* within_;
    double margin_;
    std::vector<std::vector<int>> facesAt_;  ///< by point
    std::vector<Side> sides_;                ///< by the start of their boxes
    std::vector<Face> faces_;
};

}  // namespace ew
