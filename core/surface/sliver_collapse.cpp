// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/surface/sliver_collapse.h"

#include <algorithm>
#include <array>
#include <set>
#include <vector>

#include "core/surface/surface_diagonal.h"

namespace ew {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

class SliverCollapse {
  public:
    explicit SliverCollapse(SurfaceMesh& surface) : surface_(surface) {
        const double farthest = farthestCoordinate(surface.positions);
        leastHeight_ = leastHeight(farthest);
        tinySide_ = kTinySide * farthest;
    }

    void run() {
        std::vector<std::size_t> slivers = findSlivers();
        if (slivers.empty()) return;
        findFans();
        gone_.assign(surface_.triangles.size(), false);
        bool any = false;
        // What is in the way of one may be gone after another.
        for (bool again = true; again;) {
            again = false;
            for (const std::size_t t : slivers) again = mend(t) || again;
            any = any || again;
            if (again) slivers = findSlivers();
        }
        for (const std::size_t t : slivers) {
            if (!gone_[t] && isSliver(ids(t)) && !moveAside(t, false)) moveAside(t, true);
        }
        if (any) compact();
    }

  private:
    /// Sides shorter than this share of the largest coordinate are nothing that anybody sees: what
    /// is so small may lose its area when it is drawn together.
    static constexpr double kTinySide = 1e-4;

    /// How far a corner is moved aside, in least heights; rounding may take some of it.
    static constexpr std::array<double, 3> kMoves{1.5, 4.0, 10.0};
    /// A triangle lower than this is thin, in least heights: 2e-5 of the largest coordinate.
    static constexpr double kThin = 30.0;

    using Ids = std::array<int, 3>;

    const Ids& ids(std::size_t t) const { return surface_.triangles[t]; }
    const Vec3& point(int i) const { return surface_.positions[at(i)]; }

    bool isSliver(const Ids& t) const {
        return !hasArea(point(t[0]), point(t[1]), point(t[2]), leastHeight_);
    }

    std::vector<std::size_t> findSlivers() const {
        std::vector<std::size_t> out;
        for (std::size_t t = 0; t < surface_.triangles.size(); ++t) {
            if (isSliver(ids(t)) && (gone_.empty() || !gone_[t])) out.push_back(t);
        }
        return out;
    }

    void findFans() {
        fans_.resize(surface_.positions.size());
        for (std::size_t t = 0; t < surface_.triangles.size(); ++t) {
            for (const int v : ids(t)) fans_[at(v)].push_back(t);
        }
    }

    bool mend(std::size_t t) {
        if (gone_[t] || !isSliver(ids(t))) return false;
        const Ids corners = ids(t);
        std::vector<std::array<int, 2>> sides;
        for (std::size_t k = 0; k < 3; ++k) {
            sides.push_back({corners[k], corners[(k + 1) % 3]});
            sides.push_back({corners[(k + 1) % 3], corners[k]});
        }
        std::stable_sort(sides.begin(), sides.end(), [&](const auto& a, const auto& b) {
            return (point(a[0]) - point(a[1])).squaredNorm() <
                   (point(b[0]) - point(b[1])).squaredNorm();
        });
        return std::any_of(sides.begin(), sides.end(),
                           [&](const auto& side) { return collapse(side[0], side[1]); });
    }

    std::set<int> neighbours(int v) const {
        std::set<int> out;
        for (const std::size_t t : fans_[at(v)]) out.insert(ids(t).begin(), ids(t).end());
        out.erase(v);
        return out;
    }

    /// Would the surface stay 2-manifold without `from`, and no triangle turn over?
    bool canCollapse(int from, int to) const {
        const std::set<int> a = neighbours(from);
        const std::set<int> b = neighbours(to);
        const auto common = std::count_if(a.begin(), a.end(), [&](int v) { return b.contains(v); });
        if (common != 2) return false;
        const bool tiny = (point(from) - point(to)).norm() <= tinySide_;
        int slivers = 0;  // more of them than before
        for (const std::size_t t : fans_[at(from)]) {
            const Ids& was = ids(t);
            if (isSliver(was)) --slivers;
            if (std::find(was.begin(), was.end(), to) != was.end()) continue;
            Ids now = was;
            std::replace(now.begin(), now.end(), from, to);
            if (isSliver(now)) ++slivers;
            if (area(now).dot(outward(t)) < std::min(0.0, area(was).dot(outward(t)))) return false;
            if (!isSliver(was) && !isSliver(now) && area(was).dot(area(now)) <= 0.0) return false;
        }
        return tiny || slivers < 0;
    }

    /// Gives a triangle its area by moving one of its corners within the surface: out of it, the
    /// triangle would stand across.
    /// \param folded  the surface lies on itself here, to and fro: which way a triangle that nobody
    /// can see is turned makes no difference then.
    bool moveAside(std::size_t t, bool folded) {
        const Vec3 up = outward(t).normalized();
        if (!up.allFinite()) return false;
        for (const double heights : kMoves) {
            for (std::size_t k = 0; k < 3; ++k) {
                const int v = ids(t)[k];
                const Vec3 side = point(ids(t)[(k + 2) % 3]) - point(ids(t)[(k + 1) % 3]);
                const Vec3 across = up.cross(side).normalized();
                if (!across.allFinite() || (folded && !isFolded(v))) continue;
                for (const Vec3& way : {across, Vec3(-across)}) {
                    if (moveTo(v, point(v) + heights * leastHeight_ * way, t, folded)) return true;
                }
            }
        }
        return false;
    }

    /// Does a triangle at this point run backwards?
    bool isFolded(int v) const {
        const auto& fan = fans_[at(v)];
        return std::any_of(fan.begin(), fan.end(),
                           [&](std::size_t t) { return area(ids(t)).dot(outward(t)) < 0.0; });
    }

    /// Too low for anybody to see, though not for single precision.
    bool isThin(const Ids& t) const {
        return !hasArea(point(t[0]), point(t[1]), point(t[2]), kThin * leastHeight_);
    }

    /// Moves a point unless a triangle at it loses its area or turns over, thin ones that are
    /// `folded` excepted; `mended` must get an area.
    bool moveTo(int v, const Vec3& place, std::size_t mended, bool folded) {
        const auto& fan = fans_[at(v)];
        std::vector<Vec3> before;
        std::vector<bool> wasSliver;
        std::vector<bool> mayTurn;
        for (const std::size_t t : fan) {
            before.push_back(area(ids(t)));
            wasSliver.push_back(isSliver(ids(t)));
            mayTurn.push_back(folded && isThin(ids(t)));
        }
        const Vec3 from = point(v);
        surface_.positions[at(v)] = place;
        bool fine =
            !isSliver(ids(mended)) && (folded || area(ids(mended)).dot(outward(mended)) > 0.0);
        for (std::size_t i = 0; fine && i < fan.size(); ++i) {
            const Vec3 now = area(ids(fan[i]));
            const Vec3 out = outward(fan[i]);
            const bool turned = wasSliver[i] ? now.dot(out) < std::min(0.0, before[i].dot(out))
                                             : now.dot(before[i]) <= 0.0;
            fine = (wasSliver[i] || !isSliver(ids(fan[i]))) && (!turned || mayTurn[i]);
        }
        if (!fine) surface_.positions[at(v)] = from;
        return fine;
    }

    Vec3 area(const Ids& t) const {
        return (point(t[1]) - point(t[0])).cross(point(t[2]) - point(t[0]));
    }

    /// By the normals at the corners of a triangle; no unit.
    Vec3 outward(std::size_t t) const {
        Vec3 sum = Vec3::Zero();
        for (std::size_t c = 0; c < 3; ++c) sum += surface_.normal(t, c);
        return sum;
    }

    bool collapse(int from, int to) {
        if (!canCollapse(from, to)) return false;
        for (const std::size_t t : fans_[at(from)]) {
            Ids& triangle = surface_.triangles[t];
            if (std::find(triangle.begin(), triangle.end(), to) != triangle.end()) {
                gone_[t] = true;
                for (const int v : triangle) {
                    if (v != from) std::erase(fans_[at(v)], t);
                }
                continue;
            }
            std::replace(triangle.begin(), triangle.end(), from, to);
            fans_[at(to)].push_back(t);
        }
        fans_[at(from)].clear();
        return true;
    }

    void compact() {
        std::size_t kept = 0;
        std::vector<bool> used(surface_.positions.size(), false);
        const bool ownNormals = !surface_.normalTriangles.empty();
        for (std::size_t t = 0; t < surface_.triangles.size(); ++t) {
            if (gone_[t]) continue;
            surface_.triangles[kept] = surface_.triangles[t];
            if (ownNormals) surface_.normalTriangles[kept] = surface_.normalTriangles[t];
            surface_.origin[kept] = surface_.origin[t];
            for (const int v : surface_.triangles[kept]) used[at(v)] = true;
            ++kept;
        }
        surface_.triangles.resize(kept);
        surface_.origin.resize(kept);
        if (ownNormals) surface_.normalTriangles.resize(kept);
        std::vector<int> number(used.size(), -1);
        int count = 0;
        for (std::size_t i = 0; i < used.size(); ++i) {
            if (!used[i]) continue;
            number[i] = count;
            surface_.positions[at(count)] = surface_.positions[i];
            if (!ownNormals) surface_.normals[at(count)] = surface_.normals[i];
            ++count;
        }
        surface_.positions.resize(at(count));
        if (!ownNormals) surface_.normals.resize(at(count));
        for (Ids& t : surface_.triangles) {
            for (int& v : t) v = number[at(v)];
        }
    }

    SurfaceMesh& surface_;
    double leastHeight_ = 0.0;                    ///< of a triangle [mm]
    double tinySide_ = 0.0;                       ///< [mm]
    std::vector<std::vector<std::size_t>> fans_;  ///< by point: its triangles
    std::vector<bool> gone_;                      ///< by triangle
};

}  // namespace

void collapseSlivers(SurfaceMesh& surface) { SliverCollapse(surface).run(); }

}  // namespace ew
