// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/surface/flat_parts.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <unordered_map>
#include <unordered_set>

#include "core/base/tolerance.h"
#include "core/surface/planar_triangulation.h"
#include "core/surface/side_key.h"

namespace ew {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

class FlatParts {
  public:
    FlatParts(const ControlCage& cage, SurfaceMesh& surface) : cage_(cage), surface_(surface) {
        Eigen::AlignedBox3d box;
        for (const Vec3& p : cage.mesh.points) box.extend(p);
        room_ = tol::kSamePlaneRelative * box.diagonal().norm();
        for (int f = 0; f < cage.mesh.faceCount(); ++f) {
            normals_.push_back(loopAreaVector(cage.mesh.points, cage.mesh.outline(f)).normalized());
        }
    }

    /// \return false where nothing was to be done.
    bool unfold() {
        const std::vector<int> folded = foldedFaces();
        if (folded.empty()) return false;
        findNeighbours();
        for (const int face : folded) {
            if (isFolded(face)) unfold(face);
        }
        return true;
    }

  private:
    /// In the plane of its control polygon.
    bool isFlat(std::size_t t) const {
        const int face = surface_.origin[t];
        const Vec3& normal = normals_[at(face)];
        const Vec3& on = cage_.mesh.point(cage_.mesh.outline(face)[0]);
        return std::all_of(surface_.triangles[t].begin(), surface_.triangles[t].end(), [&](int i) {
            return std::abs(normal.dot(surface_.positions[at(i)] - on)) <= room_;
        });
    }
    bool runsBackwards(std::size_t t) const {
        const auto& corners = surface_.triangles[t];
        const Vec3& a = surface_.positions[at(corners[0])];
        const Vec3 area =
            (surface_.positions[at(corners[1])] - a).cross(surface_.positions[at(corners[2])] - a);
        return area.dot(normals_[at(surface_.origin[t])]) < 0.0;
    }

    /// Faces of the control cage with flat triangles that run backwards.
    std::vector<int> foldedFaces() const {
        std::vector<int> out;
        for (std::size_t t = 0; t < surface_.triangles.size(); ++t) {
            const int face = surface_.origin[t];
            const bool known = !out.empty() && out.back() == face;
            if (!known && runsBackwards(t) && isFlat(t)) out.push_back(face);
        }
        return out;
    }

    void findNeighbours() {
        const PolyMesh& mesh = cage_.mesh;
        facesAt_.resize(mesh.points.size());
        for (int f = 0; f < mesh.faceCount(); ++f) {
            for (const int point : mesh.outline(f)) facesAt_[at(point)].push_back(f);
        }
        // Triangles of a face follow each other.
        firstTriangle_.assign(at(mesh.faceCount()) + 1, 0);
        for (const int face : surface_.origin) ++firstTriangle_[at(face) + 1];
        std::partial_sum(firstTriangle_.begin(), firstTriangle_.end(), firstTriangle_.begin());
    }

    template <class Test>
    bool anyTriangle(int face, const Test& test) const {
        for (std::size_t t = firstTriangle_[at(face)]; t < firstTriangle_[at(face) + 1]; ++t) {
            if (test(t)) return true;
        }
        return false;
    }
    bool isFolded(int face) const {
        return anyTriangle(face, [&](std::size_t t) { return runsBackwards(t); });
    }

    /// Takes in the flat faces round it, ring by ring, until all can be cut anew.
    void unfold(int face) {
        constexpr int kRings = 6;
        std::vector<int> region{face};
        std::unordered_set<int> taken{face};
        for (int ring = 0; ring < kRings; ++ring) {
            const std::vector<int> inner = region;
            for (const int f : inner) {
                for (const int point : cage_.mesh.outline(f)) {
                    for (const int next : facesAt_[at(point)]) {
                        if (cage_.origin[at(next)] != cage_.origin[at(face)]) continue;
                        if (!taken.insert(next).second) continue;
                        const auto bent = [&](std::size_t t) { return !isFlat(t); };
                        if (!anyTriangle(next, bent)) region.push_back(next);
                    }
                }
            }
            if (cutAnew(region) || region.size() == inner.size()) return;
        }
    }

    /// Sides that only one triangle has, as loops, the outline first; none where loops touch.
    std::vector<std::vector<int>> border(const std::vector<std::size_t>& part,
                                         const Vec3& normal) const {
        std::unordered_map<std::uint64_t, int> sides;
        for (const std::size_t t : part) {
            const auto& corners = surface_.triangles[t];
            for (std::size_t c = 0; c < 3; ++c) {
                const int a = corners[c];
                const int b = corners[(c + 1) % 3];
                if (sides.erase(sideKey(b, a)) == 0) sides[sideKey(a, b)] = b;
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
            return loopAreaVector(surface_.positions, loop).dot(normal);
        };
        std::stable_sort(out.begin(), out.end(),
                         [&](const auto& a, const auto& b) { return area(a) > area(b); });
        return out;
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

    /// Has the surface outside of a part a side that this cut of the part makes inside it? The two
    /// would be one edge with four triangles.
    bool joinsOutside(const std::vector<std::array<int, 3>>& cut,
                      const std::vector<std::size_t>& part, const std::vector<int>& border) const {
        std::unordered_set<std::uint64_t> made;
        for (const auto& t : cut) {
            for (std::size_t c = 0; c < 3; ++c) made.insert(sideKey(t[c], t[(c + 1) % 3]));
        }
        std::vector<bool> isBorder(surface_.positions.size(), false);
        for (const int point : border) isBorder[at(point)] = true;
        std::vector<bool> inPart(surface_.triangles.size(), false);
        for (const std::size_t t : part) inPart[t] = true;
        for (std::size_t t = 0; t < surface_.triangles.size(); ++t) {
            if (inPart[t]) continue;
            for (std::size_t c = 0; c < 3; ++c) {
                const int a = surface_.triangles[t][c];
                const int b = surface_.triangles[t][(c + 1) % 3];
                if (isBorder[at(a)] && isBorder[at(b)] && made.contains(sideKey(a, b))) return true;
            }
        }
        return false;
    }

    /// \return false where that is not possible.
    bool cutAnew(const std::vector<int>& region) {
        std::vector<std::size_t> part;
        for (const int f : region) {
            for (std::size_t t = firstTriangle_[at(f)]; t < firstTriangle_[at(f) + 1]; ++t) {
                part.push_back(t);
            }
        }
        const Vec3& up = normals_[at(region.front())];
        const auto loops = border(part, up);
        if (loops.empty()) return false;
        std::unordered_map<int, int> normalOf;
        std::vector<int> inside;
        const auto& ids = surface_.normalTriangles;
        for (const std::size_t t : part) {
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
        const std::vector<int> all = inside;
        const std::vector<std::span<const int>> spans(loops.begin(), loops.end());
        auto cut = triangulatePlanar(surface_.positions, spans, up, &inside);
        if (!cut || cut->size() + 2 * (all.size() - inside.size()) != part.size()) return false;
        if (joinsOutside(*cut, part, onBorder)) return false;
        for (const int point : all) {
            if (!std::binary_search(inside.begin(), inside.end(), point)) splitLargest(point, *cut);
        }
        for (std::size_t k = 0; k < cut->size(); ++k) {
            const std::size_t t = part[k];
            surface_.triangles[t] = (*cut)[k];
            if (ids.empty()) continue;
            for (std::size_t c = 0; c < 3; ++c) {
                surface_.normalTriangles[t][c] = normalOf.at((*cut)[k][c]);
            }
        }
        return true;
    }

    const ControlCage& cage_;
    SurfaceMesh& surface_;
    double room_ = 0.0;                       ///< what counts as in a plane [mm]
    std::vector<Vec3> normals_;               ///< by face of the control cage
    std::vector<std::vector<int>> facesAt_;   ///< by point of the control cage
    std::vector<std::size_t> firstTriangle_;  ///< by face of the control cage, and the end
};

/// Parts that were cut anew have one normal a point: drops those that nothing uses any more.
void dropUnusedNormals(SurfaceMesh& surface) {
    std::vector<int> kept(surface.normals.size(), -1);
    for (const auto& ids : surface.normalTriangles) {
        for (const int n : ids) kept[at(n)] = n;
    }
    std::size_t count = 0;
    for (std::size_t n = 0; n < kept.size(); ++n) {
        if (kept[n] < 0) continue;
        surface.normals[count] = surface.normals[n];
        kept[n] = static_cast<int>(count++);
    }
    surface.normals.resize(count);
    for (auto& ids : surface.normalTriangles) {
        for (int& n : ids) n = kept[at(n)];
    }
}

}  // namespace

void unfoldFlatParts(const ControlCage& cage, SurfaceMesh& surface) {
    if (FlatParts(cage, surface).unfold() && !surface.normalTriangles.empty()) {
        dropUnusedNormals(surface);
    }
}

}  // namespace ew
