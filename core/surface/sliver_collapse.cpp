// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/surface/sliver_collapse.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <optional>
#include <set>
#include <utility>
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
        std::size_t left = findSlivers().size();
        if (left == 0) return;
        findFans();
        gone_.assign(surface_.triangles.size(), false);
        bool any = false;
        // Where corners were moved, others may be drawn together now.
        constexpr int kRounds = 4;
        for (int round = 0; left > 0 && round < kRounds; ++round) {
            any = drawTogether() || any;
            moveAsideAll();
            const std::size_t now = findSlivers().size();
            if (now >= left) break;
            left = now;
        }
        if (any) compact();
    }

  private:
    /// Sides shorter than this share of the largest coordinate are nothing that anybody sees: what
    /// is so small may lose its area when it is drawn together.
    static constexpr double kTinySide = 1e-4;

    /// How far a corner is moved aside, in least heights; rounding may take some of it.
    static constexpr std::array<double, 6> kMoves{1.5, 0.7, 2.5, 4.0, 10.0, 20.0};
    static constexpr int kWays = 16;  ///< directions
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

    /// \return whether there was anything to be done.
    bool drawTogether() {
        bool any = false;
        // What is in the way of one may be gone after another.
        for (bool again = true; again;) {
            again = false;
            for (const std::size_t t : findSlivers()) again = mend(t) || handOver(t) || again;
            any = any || again;
        }
        return any;
    }

    void moveAsideAll() {
        for (const std::size_t t : findSlivers()) {
            if (!isSliver(ids(t)) || moveAside(t, false) || makeRoom(t)) continue;
            moveAside(t, true);
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

    /// Flips a side, the longest first: the corner across, which lies on it or next to it, then
    /// cuts the triangle beyond in two.
    bool handOver(std::size_t t) {
        if (gone_[t] || !isSliver(ids(t))) return false;
        std::array<std::size_t, 3> sides{0, 1, 2};
        std::stable_sort(sides.begin(), sides.end(), [&](std::size_t a, std::size_t b) {
            return length(ids(t), a) > length(ids(t), b);
        });
        return std::any_of(sides.begin(), sides.end(),
                           [&](std::size_t side) { return handOver(t, side, side == sides[0]); });
    }

    /// \param mayCrease  the side may be a crease, as the surface stays where it is.
    bool handOver(std::size_t t, std::size_t a, bool mayCrease) {
        const Ids corners = ids(t);
        const std::size_t b = (a + 1) % 3;
        const std::size_t c = (a + 2) % 3;
        const auto& fan = fans_[at(corners[a])];
        const auto beyond = std::find_if(fan.begin(), fan.end(), [&](std::size_t other) {
            return other != t &&
                   std::find(ids(other).begin(), ids(other).end(), corners[b]) != ids(other).end();
        });
        if (beyond == fan.end()) return false;
        const std::size_t other = *beyond;
        const Ids far = ids(other);
        const auto m =
            static_cast<std::size_t>(std::find(far.begin(), far.end(), corners[b]) - far.begin());
        const int tip = far[(m + 2) % 3];
        if (far[(m + 1) % 3] != corners[a] || tip == corners[c]) return false;
        if (neighbours(corners[c]).contains(tip)) return false;
        if (!mayCrease && isCrease(t, a, other, m)) return false;
        const Ids first{corners[c], corners[a], tip};
        const Ids second{tip, corners[b], corners[c]};
        const int before = 1 + (isSliver(far) ? 1 : 0);
        const int after = (isSliver(first) ? 1 : 0) + (isSliver(second) ? 1 : 0);
        if (after >= before) return false;
        const auto turns = [&](const Ids& part) {
            return !isSliver(part) &&
                   area(part).dot(isSliver(far) ? outward(other) : area(far)) < 0.0;
        };
        if (turns(first) || turns(second)) return false;
        handOverNormals(t, a, other, m);
        surface_.triangles[t] = first;
        surface_.triangles[other] = second;
        surface_.origin[t] = surface_.origin[other];
        std::erase(fans_[at(corners[b])], t);
        std::erase(fans_[at(corners[a])], other);
        fans_[at(tip)].push_back(t);
        fans_[at(corners[c])].push_back(other);
        return true;
    }

    /// Have two triangles other normals at their common side?
    /// \param a  where the side begins in t. \param m  ... and in the other one, at its other end.
    bool isCrease(std::size_t t, std::size_t a, std::size_t other, std::size_t m) const {
        if (surface_.normalTriangles.empty()) return false;
        const Ids& own = surface_.normalTriangles[t];
        const Ids& far = surface_.normalTriangles[other];
        return far[m] != own[(a + 1) % 3] || far[(m + 1) % 3] != own[a];
    }

    /// Both triangles get the normals of the other one.
    void handOverNormals(std::size_t t, std::size_t a, std::size_t other, std::size_t m) {
        if (surface_.normalTriangles.empty()) return;
        const Ids corners = ids(t);
        const Ids far = surface_.normalTriangles[other];
        const int atB = far[m];
        const int atA = far[(m + 1) % 3];
        const std::size_t c = (a + 2) % 3;
        const int atC =
            isCrease(t, a, other, m)
                ? normalBetween(corners[c], {corners[a], corners[(a + 1) % 3]}, {atA, atB})
                : surface_.normalTriangles[t][c];
        surface_.normalTriangles[t] = {atC, atA, far[(m + 2) % 3]};
        surface_.normalTriangles[other] = {far[(m + 2) % 3], atB, atC};
    }

    double length(const Ids& t, std::size_t side) const {
        return (point(t[(side + 1) % 3]) - point(t[side])).norm();
    }

    /// A new normal for a point on a side, of those at the ends of it.
    int normalBetween(int v, const std::array<int, 2>& ends, const std::array<int, 2>& normals) {
        const double toFirst = (point(v) - point(ends[0])).norm();
        const double toSecond = (point(v) - point(ends[1])).norm();
        const auto share = static_cast<float>(toFirst / (toFirst + toSecond));
        const Eigen::Vector3f& first = surface_.normals[at(normals[0])];
        const Eigen::Vector3f mixed =
            (1.0F - share) * first + share * surface_.normals[at(normals[1])];
        // Opposite ones have none between them.
        constexpr float kUnit = 0.5F;
        surface_.normals.push_back(mixed.squaredNorm() > kUnit ? mixed.normalized() : first);
        return static_cast<int>(surface_.normals.size()) - 1;
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
                for (int way = 0; way < kWays; ++way) {
                    // To and fro across the side first, then ever more along it.
                    const double turn = std::numbers::pi * (way % 2 + (way / 2) * 2.0 / kWays);
                    const Vec3 to = std::cos(turn) * across + std::sin(turn) * up.cross(across);
                    if (moveTo(v, point(v) + heights * leastHeight_ * to, t, folded)) return true;
                }
            }
        }
        return false;
    }

    /// Moves corners of a triangle, and of those that get too low by that, until none is left or
    /// nothing helps; then all is as it was.
    bool makeRoom(std::size_t t) {
        constexpr int kMostMoves = 200;
        std::map<int, Vec3> before;
        std::set<std::size_t> low{t};
        for (int moves = 0; !low.empty() && moves < kMostMoves; ++moves) {
            std::optional<std::pair<int, Vec3>> move;
            for (auto it = low.begin(); it != low.end() && !move; ++it) move = bestMove(*it);
            if (!move) break;
            before.emplace(move->first, point(move->first));
            surface_.positions[at(move->first)] = move->second;
            for (const std::size_t other : fans_[at(move->first)]) {
                isSliver(ids(other)) ? (void)low.insert(other) : (void)low.erase(other);
            }
        }
        if (low.empty()) return true;
        for (const auto& [v, place] : before) surface_.positions[at(v)] = place;
        return false;
    }

    /// The move of a corner of a triangle after which the lowest triangle round it is the highest;
    /// none where none gets higher.
    std::optional<std::pair<int, Vec3>> bestMove(std::size_t t) {
        const Vec3 up = outward(t).normalized();
        if (!up.allFinite()) return std::nullopt;
        const Vec3 along = up.unitOrthogonal();
        const Vec3 across = up.cross(along);
        std::optional<std::pair<int, Vec3>> best;
        double highest = 0.0;
        for (const int v : ids(t)) {
            const double lowest = lowestHeight(v, point(v));
            for (const double heights : kMoves) {
                for (int way = 0; way < kWays; ++way) {
                    const double turn = 2.0 * std::numbers::pi * way / kWays;
                    const Vec3 to =
                        point(v) +
                        heights * leastHeight_ * (std::cos(turn) * along + std::sin(turn) * across);
                    const double now = lowestHeight(v, to);
                    if (now <= 1.01 * lowest + 0.01 || now <= highest) continue;
                    highest = now;
                    best = {v, to};
                }
            }
        }
        return best;
    }

    /// Of the triangles at a point, were it at a place: how high the lowest one is, in least
    /// heights, at most 2; less than 0 where one runs backwards that does not do so now.
    double lowestHeight(int v, const Vec3& place) {
        const auto& fan = fans_[at(v)];
        const Vec3 from = point(v);
        double lowest = 2.0;
        for (const std::size_t t : fan) {
            const Vec3 up = outward(t).normalized();
            const double sign = area(ids(t)).dot(up) < 0.0 && !isSliver(ids(t)) ? -1.0 : 1.0;
            surface_.positions[at(v)] = place;
            const double longest =
                std::max({length(ids(t), 0), length(ids(t), 1), length(ids(t), 2)});
            const double height = sign * area(ids(t)).dot(up) / (longest * leastHeight_);
            surface_.positions[at(v)] = from;
            lowest = std::min(lowest, height);
        }
        return lowest;
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
