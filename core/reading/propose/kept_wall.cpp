// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reading/propose/kept_wall.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "core/base/tolerance.h"

namespace ew {
namespace {

std::size_t at(int i) { return static_cast<std::size_t>(i); }

/// The part of a polygon behind a plane.
std::vector<Vec3> behind(const std::vector<Vec3>& polygon, const CameraPlane& plane) {
    std::vector<Vec3> out;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
        const Vec3& p = polygon[i];
        const Vec3& q = polygon[(i + 1) % polygon.size()];
        const double a = plane.normal.dot(p) - plane.offset;
        const double b = plane.normal.dot(q) - plane.offset;
        if (a <= 0) out.push_back(p);
        if ((a < 0 && b > 0) || (a > 0 && b < 0)) out.push_back(p + a / (a - b) * (q - p));
    }
    return out;
}

CameraPlane outwardPlane(const std::vector<int>& loop, const CameraPoints& points) {
    Vec3 middle = Vec3::Zero();
    for (const Vec3& p : points) middle += p / static_cast<double>(points.size());
    // Newell's normal.
    Vec3 n = Vec3::Zero();
    for (std::size_t i = 0; i < loop.size(); ++i) {
        n += (points[at(loop[i])] - middle).cross(points[at(loop[(i + 1) % loop.size()])] - middle);
    }
    n.normalize();
    const double offset = n.dot(points[at(loop.front())]);
    return n.dot(middle) > offset ? CameraPlane{-n, -offset} : CameraPlane{n, offset};
}

}  // namespace

std::optional<KeptWall> wallClearOf(const std::vector<std::vector<int>>& faces,
                                    const CameraPoints& points, const std::vector<int>& movable,
                                    const ModelView& model, const std::vector<int>& met,
                                    double gapPx) {
    std::vector<CameraPlane> planes;
    for (const auto& loop : faces) planes.push_back(outwardPlane(loop, points));
    std::vector<std::vector<Vec3>> inside;
    for (const int f : met) {
        std::vector<Vec3> polygon;
        for (const int v : model.solid().faces()[at(f)].loops.front()) {
            polygon.push_back(model.vertex(v));
        }
        for (const CameraPlane& plane : planes) polygon = behind(polygon, plane);
        inside.push_back(std::move(polygon));
    }
    std::optional<KeptWall> best;
    double least = std::numeric_limits<double>::infinity();
    for (const int t : movable) {
        const CameraPlane& plane = planes[at(t)];
        double far = plane.offset;
        double near = std::numeric_limits<double>::infinity();
        for (const Vec3& p : points) near = std::min(near, plane.normal.dot(p));
        for (const auto& polygon : inside) {
            for (const Vec3& p : polygon) far = std::min(far, plane.normal.dot(p) - gapPx);
        }
        const double move = plane.offset - far;
        if (move <= 0 || move >= least || far - near < gapPx) continue;
        least = move;
        best = KeptWall{t, plane.normal, far};
    }
    return best;
}

bool moveWall(const KeptWall& wall, const std::vector<std::vector<int>>& faces,
              CameraPoints& points) {
    const std::vector<int>& moved = faces[at(wall.face)];
    const auto moves = [&](int v) {
        return std::find(moved.begin(), moved.end(), v) != moved.end();
    };
    std::map<int, std::set<int>> leads;  // from a corner of the face to those beside it
    for (const auto& loop : faces) {
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const int v = loop[i];
            const int w = loop[(i + 1) % loop.size()];
            if (moves(v) && !moves(w)) leads[v].insert(w);
            if (moves(w) && !moves(v)) leads[w].insert(v);
        }
    }
    CameraPoints out = points;
    for (const int v : moved) {
        if (leads[v].size() != 1) return false;
        const Vec3& p = points[at(v)];
        const Vec3 along = points[at(*leads[v].begin())] - p;
        const double slope = wall.normal.dot(along);
        if (std::abs(slope) < tol::kEdgeOnSine * along.norm()) return false;
        out[at(v)] = p + (wall.offset - wall.normal.dot(p)) / slope * along;
    }
    points = std::move(out);
    return true;
}

}  // namespace ew
