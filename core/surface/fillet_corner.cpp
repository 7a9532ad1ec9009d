// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/surface/fillet_corner.h"

#include <algorithm>
#include <cmath>

#include "core/base/tolerance.h"
#include "core/surface/fillet_build.h"

namespace ew {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// Puts a point into the first fan face of the corner, after the apex.
void finishFirst(FilletedCage& cage, int point, std::vector<int>& open) {
    PolyMesh& mesh = cage.mesh;
    if (cage.origins.size() == at(mesh.faceCount())) {
        open.insert(open.begin() + 1, point);
        return;
    }
    const auto face = cage.origins.size();
    const auto loop = at(mesh.faceStart[face]);
    const auto where = mesh.corners.begin() + mesh.loopStart[loop];
    mesh.corners.insert(where + 1, point);
    for (std::size_t l = loop + 1; l < mesh.loopStart.size(); ++l) ++mesh.loopStart[l];
}

}  // namespace

void addSharpEnd(FilletedCage& cage, std::span<const int> run, int edge) {
    for (std::size_t k = 0; k + 1 < run.size(); ++k) {
        cage.sharpEnds.push_back({run[k], run[k + 1], edge});
    }
}

void addFans(FilletedCage& cage, int apex, std::vector<HoleSide> sides, int sharp) {
    PolyMesh& mesh = cage.mesh;
    const auto isCurve = [](const HoleSide& s) { return s.half >= 0; };
    for (const HoleSide& side : sides) {
        if (isCurve(side) && sharp >= 0) addSharpEnd(cage, side.ids, sharp);
    }
    std::rotate(sides.begin(), std::find_if(sides.begin(), sides.end(), isCurve), sides.end());
    const Vec3 p = mesh.point(apex);
    int before = -1;  // a point on the line to the next strip end's first point
    std::vector<int> open;
    const auto close = [&] {
        if (!open.empty()) mesh.addFace(open);
        open.clear();
    };
    for (const HoleSide& side : sides) {
        const int a = side.ids.front();
        const int b = side.ids.back();
        if (isCurve(side)) {
            close();
            open = {apex};
            if (before >= 0) open.push_back(before);
            before = -1;
            open.insert(open.end(), side.ids.begin(), side.ids.end());
            continue;
        }
        if (a == apex || b == apex) continue;
        const Vec3 toA = mesh.point(a) - p;
        const Vec3 toB = mesh.point(b) - p;
        const bool inLine = toA.cross(toB).norm() <= tol::kFilletFlat * toA.norm() * toB.norm();
        if (!inLine) {
            close();
            open = {apex};
            if (before >= 0) open.push_back(before);
            before = -1;
            open.insert(open.end(), {a, b});
        } else if (toA.norm() < toB.norm()) {
            before = a;
        } else if (!open.empty()) {
            open.push_back(b);
        }
    }
    if (before >= 0) {
        // The line leads to the first strip end, whose face is written already or still open.
        finishFirst(cage, before, open);
    }
    close();
}

void addBridge(FilletedCage& cage, std::span<const HoleSide> sides, int sharp) {
    std::array<std::span<const int>, 2> ends;
    std::size_t n = 0;
    for (const HoleSide& side : sides) {
        if (side.half >= 0) ends[n++] = side.ids;
    }
    const std::size_t k = ends[0].size() - 1;
    for (std::size_t j = 0; j < k && sharp >= 0; ++j) {
        if (ends[0][j] == ends[1][k - j] && ends[0][j + 1] == ends[1][k - j - 1]) {
            cage.sharpEnds.push_back({ends[0][j], ends[0][j + 1], sharp});
        }
    }
    if (k == 1) {
        addPolygon(cage.mesh, sides);
        return;
    }
    for (std::size_t j = 0; j < k; ++j) {
        std::array<int, 4> quad{ends[0][j], ends[0][j + 1], ends[1][k - j - 1], ends[1][k - j]};
        std::vector<int> face;
        for (const int id : quad) {
            if (std::find(face.begin(), face.end(), id) == face.end()) face.push_back(id);
        }
        if (face.size() > 2) cage.mesh.addFace(face);
    }
}

void addPolygon(PolyMesh& mesh, std::span<const HoleSide> sides) {
    std::vector<int> ring;
    Vec3 middle = Vec3::Zero();
    for (const HoleSide& side : sides) {
        ring.insert(ring.end(), side.ids.begin(), side.ids.end() - 1);
        middle += 0.5 * (mesh.point(side.ids.front()) + mesh.point(side.ids.back()));
    }
    if (ring.size() < 3) return;
    middle /= static_cast<double>(sides.size());
    const Vec3 normal = loopAreaVector(mesh.points, ring).normalized();
    double size = 0.0;
    double off = 0.0;
    for (const int id : ring) {
        const Vec3 d = mesh.point(id) - mesh.point(ring[0]);
        size = std::max(size, d.norm());
        off = std::max(off, std::abs(normal.dot(d)));
    }
    if (ring.size() == 3 || off <= tol::kFilletFlat * size) {
        mesh.addFace(ring);
        return;
    }
    const int center = mesh.addPoint(middle);
    for (std::size_t k = 0; k < ring.size(); ++k) {
        mesh.addFace({center, ring[k], ring[(k + 1) % ring.size()]});
    }
}

Vec3 FaceArc::at(double t) const {
    const Vec3 from = corner + start[0] * along[0] + setback[0] * inward[0];
    const Vec3 to = corner + start[1] * along[1] + setback[1] * inward[1];
    const MiterWeights miter = miterWeights(angle);
    const double ahead0 = start[0] - miter.own * setback[0] - miter.other * setback[1];
    const double ahead1 = start[1] - miter.own * setback[1] - miter.other * setback[0];
    if (std::abs(std::sin(angle)) > tol::kFilletStraightSine &&
        std::min(ahead0, ahead1) > tol::kFilletArcSkew * std::max(ahead0, ahead1)) {
        const auto w = arcWeights(std::cos(angle), t);
        return from - ahead0 * along[0] + w[0] * ahead0 * along[0] + w[1] * ahead1 * along[1];
    }
    // The sides meet far away or behind where the arc begins.
    const double reach = (to - from).norm() / 3.0;
    const double s = 1.0 - t;
    return s * s * s * from + 3.0 * s * s * t * (from - reach * along[0]) +
           3.0 * s * t * t * (to - reach * along[1]) + t * t * t * to;
}

void addSweptPatch(PolyMesh& mesh, const SweptCorner& c) {
    const std::size_t k = c.arc.size() - 1;
    const auto& starts = c.starts;
    const double between =
        std::clamp(starts[0].normalized().dot(starts[1].normalized()), -1.0, 1.0);
    std::vector<int> grid((k + 1) * (k + 1));
    // From the first strip (i = 0) to the second one, from the third strip (j = 0) to the face.
    const auto id = [&](std::size_t i, std::size_t j) -> int& { return grid[i * (k + 1) + j]; };
    for (std::size_t i = 0; i <= k; ++i) {
        const double u = static_cast<double>(i) / static_cast<double>(k);
        const auto along = arcWeights(between, u);
        const Vec3 edge = c.corner + along[0] * starts[0] + along[1] * starts[1];
        const Vec3 a = mesh.point(c.third[k - i]) - edge;
        const Vec3 b = mesh.point(c.arc[i]) - edge;
        const double fold = std::clamp(a.normalized().dot(b.normalized()), -1.0, 1.0);
        for (std::size_t j = 0; j <= k; ++j) {
            if (i == 0) {
                id(i, j) = c.first[j];
            } else if (i == k) {
                id(i, j) = c.last[k - j];
            } else if (j == 0) {
                id(i, j) = c.third[k - i];
            } else if (j == k) {
                id(i, j) = c.arc[i];
            } else {
                const auto w = arcWeights(fold, static_cast<double>(j) / static_cast<double>(k));
                id(i, j) = mesh.addPoint(edge + w[0] * a + w[1] * b);
            }
        }
    }
    for (std::size_t i = 0; i < k; ++i) {
        for (std::size_t j = 0; j < k; ++j) {
            mesh.addFace({id(i, j), id(i, j + 1), id(i + 1, j + 1), id(i + 1, j)});
        }
    }
}

}  // namespace ew
