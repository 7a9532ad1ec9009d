// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/solid/validity.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>

#include "core/base/tolerance.h"

namespace ew {
namespace {

std::string number(std::size_t i) { return std::to_string(i); }

std::uint64_t edgeKey(int a, int b) {
    return (static_cast<std::uint64_t>(static_cast<std::uint32_t>(a)) << 32U) |
           static_cast<std::uint32_t>(b);
}

std::string edgeName(std::uint64_t key) {
    return std::to_string(key >> 32U) + "-" + std::to_string(key & 0xffffffffU);
}

/// Indices of one face; marks the points that it uses.
Result<void> checkFaceIndices(std::size_t f, const FaceLoops& loops, std::vector<bool>& used) {
    if (loops.empty()) return fail(Errc::BadValue, "Face " + number(f) + " has no points.");
    for (const std::vector<int>& loop : loops) {
        if (loop.size() < 3) {
            return fail(Errc::BadValue, "Face " + number(f) + " has fewer than three points.");
        }
        for (const int i : loop) {
            if (i < 0 || static_cast<std::size_t>(i) >= used.size()) {
                return fail(Errc::BadValue, "Face " + number(f) + " names point " +
                                                std::to_string(i) + ", which does not exist.");
            }
            used[static_cast<std::size_t>(i)] = true;
        }
    }
    return {};
}

}  // namespace

Result<void> checkCoordinates(const std::vector<Vec3>& points) {
    for (std::size_t i = 0; i < points.size(); ++i) {
        if (!points[i].allFinite() || points[i].cwiseAbs().maxCoeff() > tol::kMaxCoordinateMm) {
            return fail(Errc::BadValue,
                        "Point " + number(i) + " has a coordinate that is not a usable number.");
        }
    }
    if (points.size() < 4) return fail(Errc::NotClosed, "A solid has at least four corners.");
    if (sizeOf(points) < tol::kMinSizeMm) {
        return fail(Errc::NoVolume, "The solid is too small to hold a volume.");
    }
    return {};
}

double sizeOf(const std::vector<Vec3>& points) {
    Eigen::AlignedBox3d box;
    for (const Vec3& p : points) box.extend(p);
    return box.isEmpty() ? 0.0 : box.diagonal().norm();
}

Result<void> checkLoops(std::size_t pointCount, const std::vector<FaceLoops>& faces) {
    std::vector<bool> used(pointCount, false);
    std::unordered_map<std::uint64_t, std::size_t> faceAt;  // directed edge -> face on its left
    std::vector<std::pair<std::uint64_t, std::size_t>> twice;
    for (std::size_t f = 0; f < faces.size(); ++f) {
        if (auto ok = checkFaceIndices(f, faces[f], used); !ok) return ok;
        for (const std::vector<int>& loop : faces[f]) {
            for (std::size_t k = 0; k < loop.size(); ++k) {
                const int a = loop[k];
                const int b = loop[(k + 1) % loop.size()];
                if (a == b || b == loop[(k + loop.size() - 1) % loop.size()]) {
                    return fail(Errc::BadValue, "Face " + number(f) +
                                                    " runs back on itself at point " +
                                                    std::to_string(a) + ".");
                }
                const auto key = edgeKey(a, b);
                if (!faceAt.emplace(key, f).second) twice.emplace_back(key, f);
            }
        }
    }
    // Two faces along an edge in one direction: inside out if there are two, else a fin.
    for (const auto& [key, f] : twice) {
        const auto back =
            edgeKey(static_cast<int>(key & 0xffffffffU), static_cast<int>(key >> 32U));
        const std::string text = "Faces " + number(faceAt.at(key)) + " and " + number(f) +
                                 " run along edge " + edgeName(key) + " in the same direction";
        if (faceAt.contains(back)) {
            return fail(Errc::NotManifold,
                        "More than two faces meet in edge " + edgeName(key) + ".");
        }
        return fail(Errc::NotOriented, text + "; one of them is inside out.");
    }
    for (std::size_t f = 0; f < faces.size(); ++f) {
        for (const std::vector<int>& loop : faces[f]) {
            for (std::size_t k = 0; k < loop.size(); ++k) {
                const int a = loop[k];
                const int b = loop[(k + 1) % loop.size()];
                if (faceAt.contains(edgeKey(b, a))) continue;
                return fail(Errc::NotClosed, "Face " + number(f) + " has no neighbour along edge " +
                                                 edgeName(edgeKey(a, b)) + ".");
            }
        }
    }
    const auto unused = std::find(used.begin(), used.end(), false);
    if (unused != used.end()) {
        return fail(Errc::BadValue,
                    "Point " + std::to_string(unused - used.begin()) + " belongs to no face.");
    }
    return {};
}

Vec3 newellNormal(const std::vector<Vec3>& points, const std::vector<int>& loop) {
    // Relative to the first point: equal coordinates give exact zeros, and a far-away solid
    // loses no digits.
    const Vec3& origin = points[static_cast<std::size_t>(loop[0])];
    Vec3 sum = Vec3::Zero();
    for (std::size_t k = 1; k + 1 < loop.size(); ++k) {
        const Vec3 a = points[static_cast<std::size_t>(loop[k])] - origin;
        const Vec3 b = points[static_cast<std::size_t>(loop[k + 1])] - origin;
        sum += a.cross(b);
    }
    const double length = sum.norm();
    return length > 0.0 ? Vec3(sum / length) : Vec3(Vec3::Zero());
}

Result<void> checkPlanar(const std::vector<Vec3>& points, const std::vector<FaceLoops>& faces) {
    const double slack = tol::kPlanarRelative * sizeOf(points);
    for (std::size_t f = 0; f < faces.size(); ++f) {
        const std::vector<int>& outer = faces[f][0];
        const Vec3 normal = newellNormal(points, outer);
        if (normal.isZero(0.0)) {
            return fail(Errc::NoVolume, "Face " + number(f) + " has no area.");
        }
        double low = std::numeric_limits<double>::infinity();
        double high = -low;
        const Vec3& origin = points[static_cast<std::size_t>(outer[0])];
        for (const std::vector<int>& loop : faces[f]) {
            for (const int i : loop) {
                const double d = normal.dot(points[static_cast<std::size_t>(i)] - origin);
                low = std::min(low, d);
                high = std::max(high, d);
            }
        }
        // The middle plane is at most half the spread from every point.
        if (high - low > 2.0 * slack) {
            return fail(Errc::NotPlanar,
                        "Face " + number(f) + " is not flat: its points are up to " +
                            std::to_string(0.5 * (high - low)) + " mm off a plane.");
        }
    }
    return {};
}

Result<void> checkFans(std::size_t pointCount, const std::vector<std::array<int, 3>>& triangles) {
    std::unordered_map<std::uint64_t, int> apex;  // directed edge -> third point of its triangle
    std::vector<int> degree(pointCount, 0);
    std::vector<int> start(pointCount, -1);
    apex.reserve(3 * triangles.size());
    for (const auto& t : triangles) {
        for (std::size_t k = 0; k < 3; ++k) {
            apex.emplace(edgeKey(t[k], t[(k + 1) % 3]), t[(k + 2) % 3]);
            ++degree[static_cast<std::size_t>(t[k])];
            start[static_cast<std::size_t>(t[k])] = t[(k + 1) % 3];
        }
    }
    for (std::size_t v = 0; v < pointCount; ++v) {
        int steps = 0;
        int to = start[v];
        do {
            to = apex.at(edgeKey(static_cast<int>(v), to));
            ++steps;
        } while (to != start[v] && steps <= degree[v]);
        if (steps != degree[v]) {
            return fail(Errc::NotManifold,
                        "Two parts of the solid touch in point " + number(v) + " only.");
        }
    }
    return {};
}

}  // namespace ew
