// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/tlib/mesh_shape.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <set>

#include "core/base/disjoint_sets.h"

namespace ew {

namespace {

constexpr double kSamePlace = 1e-6;  // of the size
constexpr double kSamePlane = 1e-5;  // sine, and of the size
constexpr double kStraight = 1e-5;   // sine

using Edge = std::array<int, 2>;

std::size_t at(int i) { return static_cast<std::size_t>(i); }

Unexpected<Error> bad(const std::string& text) { return fail(Errc::BadTemplate, text); }

double sizeOf(const PolyhedronSpec& mesh) {
    Eigen::AlignedBox3d box;
    for (const Vec3& p : mesh.vertices) box.extend(p);
    return box.isEmpty() ? 0.0 : box.diagonal().norm();
}

/// Per point the first one at its place.
std::vector<int> firstAtPlace(const std::vector<Vec3>& points, double reach) {
    std::map<std::array<std::int64_t, 3>, std::vector<int>> cells;
    std::vector<int> first;
    Eigen::AlignedBox3d box;
    for (const Vec3& p : points) box.extend(p);
    for (std::size_t i = 0; i < points.size(); ++i) {
        std::array<std::int64_t, 3> cell{};
        for (std::size_t k = 0; k < 3; ++k) {
            const auto axis = static_cast<Eigen::Index>(k);
            cell[k] = std::llround((points[i][axis] - box.min()[axis]) / reach);
        }
        int found = static_cast<int>(i);
        for (int n = 0; n < 27 && found == static_cast<int>(i); ++n) {
            const auto near =
                cells.find({cell[0] + n % 3 - 1, cell[1] + n / 3 % 3 - 1, cell[2] + n / 9 - 1});
            if (near == cells.end()) continue;
            for (const int other : near->second) {
                if ((points[at(other)] - points[i]).norm() <= reach) found = other;
            }
        }
        first.push_back(found);
        if (found == static_cast<int>(i)) cells[cell].push_back(found);
    }
    return first;
}

/// Puts faces of one plane together.
class Merger {
  public:
    Merger(const PolyhedronSpec& mesh, double size) : points_(mesh.vertices), size_(size) {
        const std::vector<int> first = firstAtPlace(points_, kSamePlace * size);
        for (const std::vector<int>& face : mesh.faces) {
            std::vector<int> loop;
            for (const int v : face) {
                const int w = first[at(v)];
                if (loop.empty() || (loop.back() != w && loop.front() != w)) loop.push_back(w);
            }
            if (loop.size() >= 3 && normalOf(loop).norm() > kSamePlace * size * size * kSamePlace) {
                loops_.push_back(std::move(loop));
            }
        }
    }

    Result<PolyhedronSpec> run() {
        if (auto ok = findNeighbours(); !ok) return fail(ok.error());
        unite();
        if (auto ok = trace(); !ok) return fail(ok.error());
        return result();
    }

  private:
    Vec3 normalOf(const std::vector<int>& loop) const {
        Vec3 n = Vec3::Zero();
        const Vec3& origin = points_[at(loop[0])];
        for (std::size_t i = 1; i + 1 < loop.size(); ++i) {
            n += (points_[at(loop[i])] - origin).cross(points_[at(loop[i + 1])] - origin);
        }
        return n;
    }

    Result<void> findNeighbours() {
        for (std::size_t f = 0; f < loops_.size(); ++f) {
            const std::vector<int>& loop = loops_[f];
            for (std::size_t i = 0; i < loop.size(); ++i) {
                const Edge edge{loop[i], loop[(i + 1) % loop.size()]};
                if (!left_.emplace(edge, static_cast<int>(f)).second) {
                    return bad("The mesh touches itself in an edge, or a face is inside out.");
                }
            }
        }
        const bool closed = std::all_of(left_.begin(), left_.end(), [&](const auto& entry) {
            return left_.contains({entry.first[1], entry.first[0]});
        });
        if (left_.empty() || !closed) return bad("The mesh is not closed.");
        return {};
    }

    void unite() {
        std::vector<Vec3> normals;
        for (const auto& loop : loops_) normals.push_back(normalOf(loop).normalized());
        DisjointSets sets(loops_.size());
        for (const auto& [edge, f] : left_) {
            const int g = left_.at({edge[1], edge[0]});
            const Vec3& a = normals[at(f)];
            const Vec3& b = normals[at(g)];
            if (a.dot(b) <= 0.0 || a.cross(b).norm() > kSamePlane) continue;
            const bool flat = std::all_of(loops_[at(g)].begin(), loops_[at(g)].end(), [&](int v) {
                return std::abs((points_[at(v)] - points_[at(edge[0])]).dot(a)) <=
                       kSamePlane * size_;
            });
            if (flat) sets.join(f, g);
        }
        for (std::size_t f = 0; f < loops_.size(); ++f) {
            region_.push_back(sets.root(static_cast<int>(f)));
        }
    }

    /// The outline of every region.
    Result<void> trace() {
        std::map<int, std::map<int, int>> next;  // region -> from -> to
        for (const auto& [edge, f] : left_) {
            const int region = region_[at(f)];
            if (region_[at(left_.at({edge[1], edge[0]}))] == region) continue;
            if (!next[region].emplace(edge[0], edge[1]).second) {
                return bad("A face of the mesh touches itself in a point.");
            }
        }
        for (auto& [region, steps] : next) {
            std::vector<int> outline;
            const int start = steps.begin()->first;
            for (int v = start; outline.empty() || v != start; v = steps.at(v)) {
                outline.push_back(v);
                if (outline.size() > steps.size()) break;
            }
            if (outline.size() != steps.size()) {
                return bad("A template's faces have no holes; this solid's have.");
            }
            outlines_.push_back(std::move(outline));
        }
        return {};
    }

    bool isStraight(int before, int v, int after) const {
        const Vec3 a = (points_[at(v)] - points_[at(before)]).normalized();
        const Vec3 b = (points_[at(after)] - points_[at(v)]).normalized();
        return a.dot(b) > 0.0 && a.cross(b).norm() <= kStraight;
    }

    /// A vertex of two faces only lies inside an edge of theirs.
    PolyhedronSpec result() const {
        std::map<int, int> faces;
        for (const auto& outline : outlines_) {
            for (const int v : outline) ++faces[v];
        }
        PolyhedronSpec out;
        std::map<int, int> number;
        for (const auto& outline : outlines_) {
            std::vector<int> loop;
            for (std::size_t i = 0; i < outline.size(); ++i) {
                const int before = outline[(i + outline.size() - 1) % outline.size()];
                const int v = outline[i];
                if (faces[v] == 2 && isStraight(before, v, outline[(i + 1) % outline.size()])) {
                    continue;
                }
                const auto [it, isNew] = number.emplace(v, static_cast<int>(out.vertices.size()));
                if (isNew) out.vertices.push_back(points_[at(v)]);
                loop.push_back(it->second);
            }
            out.faces.push_back(std::move(loop));
        }
        return out;
    }

    std::vector<Vec3> points_;
    double size_;
    std::vector<std::vector<int>> loops_;
    std::map<Edge, int> left_;  // face on the left of each directed edge
    std::vector<int> region_;   // per face
    std::vector<std::vector<int>> outlines_;
};

}  // namespace

Result<PolyhedronSpec> shapeOfMesh(const PolyhedronSpec& mesh) {
    if (mesh.vertices.size() > kMaxMeshPoints || mesh.faces.size() > 2 * kMaxMeshPoints) {
        return bad("The mesh has more than " + std::to_string(kMaxMeshPoints) + " points.");
    }
    const int count = static_cast<int>(mesh.vertices.size());
    for (const Vec3& p : mesh.vertices) {
        if (!p.allFinite()) return fail(Errc::BadValue, "The mesh has a point that is nowhere.");
    }
    for (const std::vector<int>& face : mesh.faces) {
        const bool known =
            std::all_of(face.begin(), face.end(), [&](int v) { return v >= 0 && v < count; });
        if (!known)
            return fail(Errc::BadValue, "A face of the mesh names a point that is not there.");
    }
    const double size = sizeOf(mesh);
    if (!(size > 0.0) || !std::isfinite(size)) return bad("The mesh is not closed.");
    return Merger(mesh, size).run();
}

}  // namespace ew
