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

Result<void> checkClosed(const PolyMesh& mesh) {
    struct Side {
        int from;
        int to;
        std::size_t corner;
    };
    const std::size_t count = mesh.corners.size();
    std::vector<Side> sides;
    std::vector<int> previous(count);  // the corner before, in its loop
    sides.reserve(count);
    for (std::size_t l = 0; l + 1 < mesh.loopStart.size(); ++l) {
        const int first = mesh.loopStart[l];
        const int last = mesh.loopStart[l + 1];
        for (int k = first; k < last; ++k) {
            const int next = k + 1 < last ? k + 1 : first;
            previous[at(next)] = k;
            const int from = mesh.corners[at(k)];
            const int to = mesh.corners[at(next)];
            if (from == to || from < 0 || at(from) >= mesh.points.size()) {
                return fail(Errc::BadValue, "Loop " + std::to_string(l) + " names point " +
                                                std::to_string(from) + " wrongly.");
            }
            sides.push_back({from, to, at(k)});
        }
    }
    std::sort(sides.begin(), sides.end(), [](const Side& a, const Side& b) {
        return std::pair(a.from, a.to) < std::pair(b.from, b.to);
    });
    std::vector<std::size_t> twin(count);
    for (std::size_t i = 0; i < sides.size(); ++i) {
        const Side& s = sides[i];
        const std::string name = std::to_string(s.from) + "-" + std::to_string(s.to);
        if (i > 0 && sides[i - 1].from == s.from && sides[i - 1].to == s.to) {
            return fail(Errc::NotOriented,
                        "Two faces run along edge " + name + " in one direction.");
        }
        const auto back = std::lower_bound(
            sides.begin(), sides.end(), std::pair(s.to, s.from),
            [](const Side& a, const auto& key) { return std::pair(a.from, a.to) < key; });
        if (back == sides.end() || back->from != s.to || back->to != s.from) {
            return fail(Errc::NotClosed, "Edge " + name + " has a face on one side only.");
        }
        twin[s.corner] = back->corner;
    }
    std::vector<int> degree(mesh.points.size(), 0);
    std::vector<std::size_t> start(mesh.points.size(), count);
    for (std::size_t k = 0; k < count; ++k) {
        ++degree[at(mesh.corners[k])];
        start[at(mesh.corners[k])] = k;
    }
    for (std::size_t v = 0; v < mesh.points.size(); ++v) {
        if (start[v] == count) continue;
        int steps = 0;
        std::size_t k = start[v];
        do {
            k = twin[at(previous[k])];
            ++steps;
        } while (k != start[v] && steps <= degree[v]);
        if (steps != degree[v]) {
            return fail(Errc::NotManifold,
                        "Two parts of the surface touch in point " + std::to_string(v) + " only.");
        }
    }
    return {};
}

}  // namespace ew
