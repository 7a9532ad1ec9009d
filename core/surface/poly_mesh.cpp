// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/surface/poly_mesh.h"

#include <algorithm>
#include <string>

#include "core/surface/planar_triangulation.h"

namespace ew {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

class Triangulator {
  public:
    explicit Triangulator(const PolyMesh& mesh) : mesh_(mesh) {
        out_.triangles.reserve(2 * mesh.corners.size());
        out_.face.reserve(2 * mesh.corners.size());
    }

    /// False where the face is no simple polygon.
    bool add(int face) {
        const auto outline = mesh_.outline(face);
        if (mesh_.loopCount(face) == 1 && outline.size() == 3) {
            emit(face, {outline[0], outline[1], outline[2]});
            return true;
        }
        if (mesh_.loopCount(face) == 1 && outline.size() == 4 && addQuad(face, outline))
            return true;
        loops_.clear();
        for (int l = 0; l < mesh_.loopCount(face); ++l) loops_.push_back(mesh_.loop(face, l));
        const Vec3 normal = loopAreaVector(mesh_.points, outline);
        if (normal.isZero(0.0)) return false;
        const auto triangles = triangulatePlanar(mesh_.points, loops_, normal);
        if (!triangles) return false;
        for (const auto& t : *triangles) emit(face, t);
        return true;
    }

    PolyTriangles take() { return std::move(out_); }

  private:
    void emit(int face, const std::array<int, 3>& t) {
        out_.triangles.push_back(t);
        out_.face.push_back(face);
    }

    /// Splits along the diagonal across which the two triangles fold least; false where neither
    /// leaves both turned the same way.
    bool addQuad(int face, std::span<const int> q) {
        const Vec3 normal = loopAreaVector(mesh_.points, q);
        int best = -1;
        double flattest = 0.0;
        for (int k = 0; k < 2; ++k) {
            const Vec3& a = mesh_.point(q[at(k)]);
            const Vec3& b = mesh_.point(q[at(k + 1)]);
            const Vec3& c = mesh_.point(q[at(k + 2)]);
            const Vec3& d = mesh_.point(q[at((k + 3) % 4)]);
            const Vec3 first = (b - a).cross(c - a);
            const Vec3 second = (c - a).cross(d - a);
            if (first.dot(normal) <= 0.0 || second.dot(normal) <= 0.0) continue;
            const double fold = first.dot(second) / (first.norm() * second.norm());
            // Rounding must not choose between the diagonals of a flat quadrangle.
            if (best >= 0 && fold <= flattest + 1e-9) continue;
            best = k;
            flattest = fold;
        }
        if (best < 0) return false;
        const auto k = at(best);
        emit(face, {q[k], q[k + 1], q[k + 2]});
        emit(face, {q[k], q[k + 2], q[(k + 3) % 4]});
        return true;
    }

    const PolyMesh& mesh_;
    PolyTriangles out_;
    std::vector<std::span<const int>> loops_;
};

}  // namespace

Vec3 loopAreaVector(const std::vector<Vec3>& points, std::span<const int> loop) {
    Vec3 sum = Vec3::Zero();
    const Vec3& origin = points[at(loop[0])];
    for (std::size_t k = 1; k + 1 < loop.size(); ++k) {
        sum += (points[at(loop[k])] - origin).cross(points[at(loop[k + 1])] - origin);
    }
    return sum;
}

Result<PolyTriangles> triangulate(const PolyMesh& mesh, std::vector<int>* brokenFaces) {
    Triangulator triangulator(mesh);
    for (int f = 0; f < mesh.faceCount(); ++f) {
        for (int l = 0; l < mesh.loopCount(f); ++l) {
            if (mesh.loop(f, l).size() >= 3) continue;
            return fail(Errc::BadValue,
                        "Face " + std::to_string(f) + " has fewer than three corners.");
        }
        if (triangulator.add(f)) continue;
        if (brokenFaces == nullptr) {
            return fail(Errc::SelfIntersecting,
                        "The outline of face " + std::to_string(f) + " crosses or touches itself.");
        }
        brokenFaces->push_back(f);
    }
    return triangulator.take();
}

double enclosedVolume(const std::vector<Vec3>& points,
                      const std::vector<std::array<int, 3>>& triangles) {
    if (points.empty()) return 0.0;
    const Vec3 origin = points[0];
    double six = 0.0;
    for (const auto& t : triangles) {
        const Vec3 a = points[at(t[0])] - origin;
        six += a.dot((points[at(t[1])] - origin).cross(points[at(t[2])] - origin));
    }
    return six / 6.0;
}

namespace {

/// The sides of all loops, by the point that they begin at and then by the one that they lead to. A
/// side has the number of the corner that it begins at.
class SideTable {
  public:
    static Result<SideTable> create(const PolyMesh& mesh) {
        SideTable out;
        const std::size_t count = mesh.corners.size();
        out.target_.resize(count);
        out.previous_.resize(count);
        out.start_.assign(mesh.points.size() + 1, 0);
        for (std::size_t l = 0; l + 1 < mesh.loopStart.size(); ++l) {
            const int first = mesh.loopStart[l];
            const int last = mesh.loopStart[l + 1];
            for (int k = first; k < last; ++k) {
                const int next = k + 1 < last ? k + 1 : first;
                const int from = mesh.corners[at(k)];
                out.previous_[at(next)] = k;
                out.target_[at(k)] = mesh.corners[at(next)];
                if (from == out.target_[at(k)] || from < 0 || at(from) >= mesh.points.size()) {
                    return fail(Errc::BadValue, "Loop " + std::to_string(l) + " names point " +
                                                    std::to_string(from) + " wrongly.");
                }
                ++out.start_[at(from) + 1];
            }
        }
        for (std::size_t v = 1; v < out.start_.size(); ++v) out.start_[v] += out.start_[v - 1];
        std::vector<std::size_t> fill(out.start_.begin(), out.start_.end() - 1);
        out.sides_.resize(count);
        for (std::size_t k = 0; k < count; ++k) {
            out.sides_[fill[at(mesh.corners[k])]++] = static_cast<int>(k);
        }
        for (std::size_t v = 0; v < mesh.points.size(); ++v) {
            const auto first = out.sides_.begin();
            std::sort(first + static_cast<std::ptrdiff_t>(out.start_[v]),
                      first + static_cast<std::ptrdiff_t>(out.start_[v + 1]),
                      [&](int a, int b) { return out.target_[at(a)] < out.target_[at(b)]; });
        }
        return out;
    }

    std::span<const int> leaving(std::size_t point) const {
        return {sides_.data() + start_[point], sides_.data() + start_[point + 1]};
    }
    int target(int side) const { return target_[at(side)]; }
    int previous(int side) const { return previous_[at(side)]; }
    /// The side from one point to another, -1 where there is none.
    int find(int from, int to) const {
        const auto all = leaving(at(from));
        const auto it = std::lower_bound(all.begin(), all.end(), to,
                                         [&](int s, int point) { return target(s) < point; });
        return it != all.end() && target(*it) == to ? *it : -1;
    }

  private:
    std::vector<int> target_;
    std::vector<int> previous_;  ///< in its loop
    std::vector<std::size_t> start_;
    std::vector<int> sides_;
};

}  // namespace

Result<void> checkClosed(const PolyMesh& mesh) {
    const auto sides = SideTable::create(mesh);
    if (!sides) return fail(sides.error());
    std::vector<int> twin(mesh.corners.size());
    for (std::size_t v = 0; v < mesh.points.size(); ++v) {
        const auto leaving = sides->leaving(v);
        for (std::size_t i = 0; i < leaving.size(); ++i) {
            const int to = sides->target(leaving[i]);
            const auto name = [&] { return std::to_string(v) + "-" + std::to_string(to); };
            if (i > 0 && sides->target(leaving[i - 1]) == to) {
                return fail(Errc::NotOriented,
                            "Two faces run along edge " + name() + " in one direction.");
            }
            const int back = sides->find(to, static_cast<int>(v));
            if (back < 0) {
                return fail(Errc::NotClosed, "Edge " + name() + " has a face on one side only.");
            }
            twin[at(leaving[i])] = back;
        }
    }
    for (std::size_t v = 0; v < mesh.points.size(); ++v) {
        const auto leaving = sides->leaving(v);
        if (leaving.empty()) continue;
        std::size_t steps = 0;
        int side = leaving[0];
        do {
            side = twin[at(sides->previous(side))];
            ++steps;
        } while (side != leaving[0] && steps <= leaving.size());
        if (steps != leaving.size()) {
            return fail(Errc::NotManifold,
                        "Two parts of the surface touch in point " + std::to_string(v) + " only.");
        }
    }
    return {};
}

}  // namespace ew
