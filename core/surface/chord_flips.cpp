// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/surface/chord_flips.h"

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <unordered_map>
#include <unordered_set>

#include "core/surface/side_key.h"
#include "core/surface/surface_diagonal.h"

namespace ew {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

class ChordFlips {
  public:
    explicit ChordFlips(SurfaceMesh& surface)
        : surface_(surface), leastHeight_(leastHeight(farthestCoordinate(surface.positions))) {}

    /// \return whether anything was flipped.
    bool pass() {
        findFlips();
        if (flips_.empty()) return false;
        findNeighbours();
        bool any = false;
        for (const Flip& flip : flips_) any = perform(flip) || any;
        return any;
    }

  private:
    using Ids = std::array<int, 3>;

    /// A triangle that runs backwards or has no area, and which of its sides is the longest.
    struct Flip {
        std::size_t triangle = 0;
        std::size_t side = 0;
    };

    const Ids& ids(std::size_t t) const { return surface_.triangles[t]; }
    const Ids& normalIds(std::size_t t) const {
        return surface_.normalTriangles.empty() ? surface_.triangles[t]
                                                : surface_.normalTriangles[t];
    }
    const Vec3& point(int i) const { return surface_.positions[at(i)]; }
    Vec3 normal(int i) const { return surface_.normals[at(i)].cast<double>(); }

    /// 1: by all its normals the triangle faces outwards, -1: inwards or nowhere, 0: they do not
    /// agree.
    int facing(const Ids& corners, const Ids& normals) const {
        if (!hasArea(point(corners[0]), point(corners[1]), point(corners[2]), leastHeight_))
            return -1;
        const Vec3 area =
            (point(corners[1]) - point(corners[0])).cross(point(corners[2]) - point(corners[0]));
        int outwards = 0;
        int inwards = 0;
        for (const int n : normals) ++(area.dot(normal(n)) > 0.0 ? outwards : inwards);
        if (outwards == 3) return 1;
        return inwards == 3 ? -1 : 0;
    }

    bool alike(const Ids& normals) const {
        constexpr double kAlike = 0.8;  // cosine; farther turns are the surface's own
        return normal(normals[0]).dot(normal(normals[1])) > kAlike &&
               normal(normals[1]).dot(normal(normals[2])) > kAlike &&
               normal(normals[2]).dot(normal(normals[0])) > kAlike;
    }

    /// Among all triangles, and later among those that the last pass had to do with.
    void findFlips() {
        std::vector<std::size_t> among;
        if (isFirst_) {
            among.resize(surface_.triangles.size());
            std::iota(among.begin(), among.end(), std::size_t{0});
        } else {
            for (const Flip& flip : flips_) among.push_back(flip.triangle);
            among.insert(among.end(), touched_.begin(), touched_.end());
            std::sort(among.begin(), among.end());
            among.erase(std::unique(among.begin(), among.end()), among.end());
        }
        isFirst_ = false;
        flips_.clear();
        for (const std::size_t t : among) {
            if (facing(ids(t), normalIds(t)) >= 0 || !alike(normalIds(t))) continue;
            const auto length = [&](std::size_t side) {
                return (point(ids(t)[(side + 1) % 3]) - point(ids(t)[side])).squaredNorm();
            };
            std::size_t longest = 0;
            for (std::size_t side = 1; side < 3; ++side) {
                if (length(side) > length(longest)) longest = side;
            }
            flips_.push_back({t, longest});
        }
    }

    /// The triangles beyond the sides to be flipped, and what their tips are joined to already.
    void findNeighbours() {
        beyond_.clear();
        joined_.clear();
        // Most points have to do with nothing of this.
        std::vector<bool> isTip(surface_.positions.size(), false);
        std::vector<bool> isEnd(surface_.positions.size(), false);
        for (const Flip& flip : flips_) {
            const Ids& t = ids(flip.triangle);
            beyond_[sideKey(t[(flip.side + 1) % 3], t[flip.side])] = -1;
            isEnd[at(t[flip.side])] = isEnd[at(t[(flip.side + 1) % 3])] = true;
            isTip[at(t[(flip.side + 2) % 3])] = true;
        }
        for (std::size_t t = 0; t < surface_.triangles.size(); ++t) {
            for (std::size_t k = 0; k < 3; ++k) {
                const int a = ids(t)[k];
                const int b = ids(t)[(k + 1) % 3];
                if (isTip[at(a)]) joined_.insert(sideKey(a, b));
                if (!isEnd[at(a)] || !isEnd[at(b)]) continue;
                const auto it = beyond_.find(sideKey(a, b));
                if (it != beyond_.end()) it->second = static_cast<int>(t);
            }
        }
        touched_.clear();
    }

    bool perform(const Flip& flip) {
        const std::size_t t = flip.triangle;
        if (touched_.contains(t)) return false;  // it is no longer the one that was found
        const Ids corners = ids(t);
        const Ids normals = normalIds(t);
        const std::size_t i = flip.side;
        const std::size_t j = (i + 1) % 3;
        const std::size_t k = (i + 2) % 3;
        const int other = beyond_.at(sideKey(corners[j], corners[i]));
        if (other < 0 || touched_.contains(at(other))) return false;
        const Ids far = ids(at(other));
        const Ids farNormals = normalIds(at(other));
        const std::size_t m =
            static_cast<std::size_t>(std::find(far.begin(), far.end(), corners[j]) - far.begin());
        const std::size_t tip = (m + 2) % 3;
        const bool crease = farNormals[m] != normals[j] || farNormals[(m + 1) % 3] != normals[i];
        if (crease || joined_.contains(sideKey(corners[k], far[tip]))) return false;
        const Ids first{corners[k], corners[i], far[tip]};
        const Ids firstNormals{normals[k], normals[i], farNormals[tip]};
        const Ids second{far[tip], corners[j], corners[k]};
        const Ids secondNormals{farNormals[tip], normals[j], normals[k]};
        if (facing(first, firstNormals) <= 0 || facing(second, secondNormals) <= 0) return false;
        surface_.triangles[t] = first;
        surface_.triangles[at(other)] = second;
        if (!surface_.normalTriangles.empty()) {
            surface_.normalTriangles[t] = firstNormals;
            surface_.normalTriangles[at(other)] = secondNormals;
        }
        touched_.insert(t);
        touched_.insert(at(other));
        joined_.insert(sideKey(corners[k], far[tip]));
        joined_.insert(sideKey(far[tip], corners[k]));
        return true;
    }

    SurfaceMesh& surface_;
    double leastHeight_;  ///< of a triangle [mm]
    bool isFirst_ = true;
    std::vector<Flip> flips_;
    std::unordered_map<std::uint64_t, int> beyond_;  ///< by side: the triangle that has it
    std::unordered_set<std::uint64_t> joined_;       ///< sides that leave tips
    std::unordered_set<std::size_t> touched_;        ///< triangles flipped in this pass
};

}  // namespace

void flipBadTriangles(SurfaceMesh& surface) {
    // A row of points on one line is undone from its ends, one triangle a pass.
    constexpr int kPasses = 64;
    ChordFlips flips(surface);
    for (int pass = 0; pass < kPasses && flips.pass(); ++pass) {
    }
}

}  // namespace ew
