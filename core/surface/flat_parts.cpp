// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/surface/flat_parts.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <unordered_map>

#include "core/base/tolerance.h"
#include "core/surface/planar_triangulation.h"

namespace ew {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

std::uint64_t key(int a, int b) {
    return (static_cast<std::uint64_t>(static_cast<std::uint32_t>(a)) << 32U) |
           static_cast<std::uint32_t>(b);
}

/// The flat triangles of one face of the filleted cage that hang together.
struct Part {
    Vec3 normal = Vec3::Zero();
    std::vector<std::size_t> triangles;
    bool folded = false;
};

class FlatParts {
  public:
    FlatParts(const ControlCage& cage, SurfaceMesh& surface) : cage_(cage), surface_(surface) {
        Box3 box;
        for (const Vec3& p : cage.mesh.points) box.extend(p);
        room_ = tol::kSamePlaneRelative * box.diagonal().norm();
        for (int f = 0; f < cage.mesh.faceCount(); ++f) {
            normals_.push_back(loopAreaVector(cage.mesh.points, cage.mesh.outline(f)).normalized());
        }
    }

    void unfold() {
        for (const int face : foldedFaces()) {
            for (const Part& part : parts(face)) {
                if (part.folded) cutAnew(part);
            }
        }
    }

  private:
    using Box3 = Eigen::AlignedBox3d;

    /// In the plane of its control polygon.
    bool isFlat(std::size_t t) const {
        const int face = surface_.origin[t];
        const Vec3& normal = normals_[at(face)];
        const Vec3& on = cage_.mesh.point(cage_.mesh.outline(face)[0]);
        return std::all_of(surface_.triangles[t].begin(), surface_.triangles[t].end(), [&](int i) {
            return std::abs(normal.dot(surface_.positions[at(i)] - on)) <= room_;
        });
    }
    bool runsBackwards(std::size_t t, const Vec3& normal) const {
        const auto& corners = surface_.triangles[t];
        const Vec3& a = surface_.positions[at(corners[0])];
        const Vec3 area =
            (surface_.positions[at(corners[1])] - a).cross(surface_.positions[at(corners[2])] - a);
        return area.dot(normal) < 0.0;
    }

    /// Faces of the filleted cage with flat triangles that run backwards.
    std::vector<int> foldedFaces() const {
        std::vector<int> out;
        for (std::size_t t = 0; t < surface_.triangles.size(); ++t) {
            if (!runsBackwards(t, normals_[at(surface_.origin[t])]) || !isFlat(t)) continue;
            out.push_back(cage_.origin[at(surface_.origin[t])]);
        }
        std::sort(out.begin(), out.end());
        out.erase(std::unique(out.begin(), out.end()), out.end());
        return out;
    }

    std::vector<Part> parts(int face) const {
        std::vector<std::size_t> flat;
        for (std::size_t t = 0; t < surface_.triangles.size(); ++t) {
            if (cage_.origin[at(surface_.origin[t])] == face && isFlat(t)) flat.push_back(t);
        }
        std::unordered_map<std::uint64_t, std::size_t> left;
        for (std::size_t k = 0; k < flat.size(); ++k) {
            const auto& t = surface_.triangles[flat[k]];
            for (std::size_t c = 0; c < 3; ++c) left[key(t[c], t[(c + 1) % 3])] = k;
        }
        std::vector<Part> out;
        std::vector<bool> seen(flat.size(), false);
        for (std::size_t first = 0; first < flat.size(); ++first) {
            if (seen[first]) continue;
            seen[first] = true;
            Part part;
            part.normal = normals_[at(surface_.origin[flat[first]])];
            std::vector<std::size_t> open{first};
            while (!open.empty()) {
                const std::size_t k = open.back();
                open.pop_back();
                part.triangles.push_back(flat[k]);
                part.folded = part.folded || runsBackwards(flat[k], part.normal);
                const auto& t = surface_.triangles[flat[k]];
                for (std::size_t c = 0; c < 3; ++c) {
                    const auto beyond = left.find(key(t[(c + 1) % 3], t[c]));
                    if (beyond == left.end() || seen[beyond->second]) continue;
                    seen[beyond->second] = true;
                    open.push_back(beyond->second);
                }
            }
            out.push_back(std::move(part));
        }
        return out;
    }

    /// Sides that only one triangle has, as loops, the outline first; none where loops touch.
    std::vector<std::vector<int>> border(const Part& part) const {
        std::unordered_map<std::uint64_t, int> sides;
        for (const std::size_t t : part.triangles) {
            const auto& corners = surface_.triangles[t];
            for (std::size_t c = 0; c < 3; ++c) {
                const int a = corners[c];
                const int b = corners[(c + 1) % 3];
                if (sides.erase(key(b, a)) == 0) sides[key(a, b)] = b;
            }
        }
        std::unordered_map<int, int> next;
        for (const auto& [side, to] : sides) {
            if (!next.try_emplace(static_cast<int>(side >> 32U), to).second) return {};
        }
        std::vector<std::vector<int>> out;
        while (!next.empty()) {
            std::vector<int> loop;
            // The first point in the mesh, so that the same mesh gives the same triangles.
            int point = std::min_element(next.begin(), next.end())->first;
            for (auto it = next.find(point); it != next.end(); it = next.find(point)) {
                loop.push_back(point);
                point = it->second;
                next.erase(it);
            }
            out.push_back(std::move(loop));
        }
        const auto area = [&](const std::vector<int>& loop) {
            return loopAreaVector(surface_.positions, loop).dot(part.normal);
        };
        std::stable_sort(out.begin(), out.end(),
                         [&](const auto& a, const auto& b) { return area(a) > area(b); });
        return out;
    }

    /// By the number of sides that a ray in the plane crosses; false at a side, too.
    bool isInside(int point, const std::vector<std::vector<int>>& loops, const Vec3& normal) const {
        const Vec3 along = normal.unitOrthogonal();
        const Vec3 across = normal.cross(along);
        const Vec3& p = surface_.positions[at(point)];
        bool in = false;
        for (const auto& loop : loops) {
            for (std::size_t k = 0; k < loop.size(); ++k) {
                const Vec3 a = surface_.positions[at(loop[k])] - p;
                const Vec3 b = surface_.positions[at(loop[(k + 1) % loop.size()])] - p;
                const double length = (b - a).squaredNorm();
                const double t = length > 0.0 ? std::clamp(-a.dot(b - a) / length, 0.0, 1.0) : 0.0;
                if ((a + t * (b - a)).norm() <= room_) return false;
                const double ya = across.dot(a);
                const double yb = across.dot(b);
                if ((ya > 0.0) == (yb > 0.0)) continue;
                const double xa = along.dot(a);
                if (xa + ya / (ya - yb) * (along.dot(b) - xa) > 0.0) in = !in;
            }
        }
        return in;
    }

    /// Moves a point into the middle of the largest triangle, which is on the surface as well.
    void splitLargest(int point, std::vector<std::array<int, 3>>& triangles) {
        const auto corner = [&](const std::array<int, 3>& t, std::size_t k) -> const Vec3& {
            return surface_.positions[at(t[k])];
        };
        const auto area = [&](const std::array<int, 3>& t) {
            return (corner(t, 1) - corner(t, 0)).cross(corner(t, 2) - corner(t, 0)).squaredNorm();
        };
        const auto largest =
            std::max_element(triangles.begin(), triangles.end(),
                             [&](const auto& s, const auto& t) { return area(s) < area(t); });
        const std::array<int, 3> t = *largest;
        surface_.positions[at(point)] = (corner(t, 0) + corner(t, 1) + corner(t, 2)) / 3.0;
        *largest = {t[0], t[1], point};
        triangles.push_back({t[1], t[2], point});
        triangles.push_back({t[2], t[0], point});
    }

    void cutAnew(const Part& part) {
        const auto loops = border(part);
        if (loops.empty()) return;
        std::unordered_map<int, int> normalOf;
        std::vector<int> inside;
        const auto& ids = surface_.normalTriangles;
        for (const std::size_t t : part.triangles) {
            for (std::size_t c = 0; c < 3; ++c) {
                const int point = surface_.triangles[t][c];
                const int normal = ids.empty() ? point : ids[t][c];
                if (normalOf.try_emplace(point, normal).second) inside.push_back(point);
            }
        }
        std::vector<int> onBorder;
        for (const auto& loop : loops) onBorder.insert(onBorder.end(), loop.begin(), loop.end());
        std::sort(onBorder.begin(), onBorder.end());
        std::erase_if(inside, [&](int point) {
            return std::binary_search(onBorder.begin(), onBorder.end(), point);
        });
        std::sort(inside.begin(), inside.end());
        std::vector<int> beyond;
        std::erase_if(inside, [&](int point) {
            if (isInside(point, loops, part.normal)) return false;
            beyond.push_back(point);
            return true;
        });
        const std::vector<std::span<const int>> spans(loops.begin(), loops.end());
        auto cut = triangulatePlanar(surface_.positions, spans, part.normal, inside);
        if (!cut || cut->size() + 2 * beyond.size() != part.triangles.size()) return;
        for (const int point : beyond) splitLargest(point, *cut);
        for (std::size_t k = 0; k < cut->size(); ++k) {
            const std::size_t t = part.triangles[k];
            surface_.triangles[t] = (*cut)[k];
            if (ids.empty()) continue;
            for (std::size_t c = 0; c < 3; ++c) {
                surface_.normalTriangles[t][c] = normalOf.at((*cut)[k][c]);
            }
        }
    }

    const ControlCage& cage_;
    SurfaceMesh& surface_;
    double room_ = 0.0;          ///< what counts as in a plane [mm]
    std::vector<Vec3> normals_;  ///< by face of the control cage
};

}  // namespace

void unfoldFlatParts(const ControlCage& cage, SurfaceMesh& surface) {
    FlatParts(cage, surface).unfold();
}

}  // namespace ew
