// SPDX-License-Identifier: GPL-3.0-or-later
// Corners of three to six edges in every mix of convex and concave, filleted and sharp.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <set>

#include "core/surface/fillet.h"
#include "tests/surface/surface_fixture.h"

namespace ew::test {
namespace {

/// An edge of a corner: where it leads to on the unit circle, and how high [rad, mm].
struct Ray {
    double azimuth;
    double height;
};

/// A block with upright walls, round about, whose roof has one flat face between each two rays from
/// the origin, also where these are more than half a turn apart.
PolyhedronSpec roofSpec(const std::vector<Ray>& rays) {
    constexpr double kTurn = 2.0 * std::numbers::pi;
    constexpr double kFloor = -6.0;
    PolyhedronSpec spec;
    spec.vertices.emplace_back(0, 0, 0);
    const auto point = [](const Ray& r) {
        return Vec3(std::cos(r.azimuth), std::sin(r.azimuth), r.height);
    };
    std::vector<int> rim;
    for (std::size_t i = 0; i < rays.size(); ++i) {
        const Ray& from = rays[i];
        const Ray& to = rays[(i + 1) % rays.size()];
        const double gap = to.azimuth - from.azimuth + (i + 1 == rays.size() ? kTurn : 0.0);
        const Vec3 normal = point(from).cross(point(to));
        const int pieces = 1 + static_cast<int>(gap / 2.0);
        std::vector<int> face{0};
        for (int k = 0; k < pieces; ++k) {
            const double a = from.azimuth + gap * k / pieces;
            Vec3 p = point({a, from.height});
            if (k > 0) p.z() = -(normal.x() * p.x() + normal.y() * p.y()) / normal.z();
            rim.push_back(static_cast<int>(spec.vertices.size()));
            face.push_back(rim.back());
            spec.vertices.push_back(p);
        }
        face.push_back(i + 1 == rays.size() ? 1 : static_cast<int>(spec.vertices.size()));
        spec.faces.push_back(face);
    }
    const int n = static_cast<int>(rim.size());
    std::vector<int> bottom;
    for (int i = 0; i < n; ++i) {
        const Vec3 p = spec.vertices[static_cast<std::size_t>(rim[static_cast<std::size_t>(i)])];
        spec.vertices.emplace_back(p.x(), p.y(), kFloor);
        spec.faces.push_back({1 + n + i, 1 + n + (i + 1) % n, 1 + (i + 1) % n, 1 + i});
        bottom.insert(bottom.begin(), 1 + n + i);
    }
    spec.faces.push_back(bottom);
    return spec;
}

/// n rays, counter-clockwise, none nearly opposite to its neighbour or beside it.
std::vector<Ray> randomRays(int n, Random& random) {
    const double most = random.uniform(0.3, 1.2);
    while (true) {
        std::vector<Ray> rays;
        for (int i = 0; i < n; ++i) {
            rays.push_back(
                {random.uniform(0.0, 2.0 * std::numbers::pi), random.uniform(-most, most)});
        }
        std::sort(rays.begin(), rays.end(),
                  [](const Ray& a, const Ray& b) { return a.azimuth < b.azimuth; });
        bool good = true;
        for (std::size_t i = 0; i < rays.size(); ++i) {
            const double gap = rays[(i + 1) % rays.size()].azimuth - rays[i].azimuth;
            good = good && std::abs(std::sin(gap)) > 0.35;
        }
        if (good) return rays;
    }
}

/// A corner with its edges in order.
struct Corner {
    Solid solid;
    std::vector<int> edges;
    std::vector<bool> convex;
};

Corner cornerOf(const Solid& solid) {
    Corner out{solid, {}, {}};
    std::vector<std::pair<double, int>> byAngle;
    for (std::size_t e = 0; e < solid.edges().size(); ++e) {
        const auto& ends = solid.edges()[e].ends;
        for (const std::size_t k : {std::size_t{0}, std::size_t{1}}) {
            if (solid.vertices()[static_cast<std::size_t>(ends[k])].norm() > 1e-6) continue;
            const Vec3& to = solid.vertices()[static_cast<std::size_t>(ends[1 - k])];
            byAngle.emplace_back(std::atan2(to.y(), to.x()), static_cast<int>(e));
        }
    }
    std::sort(byAngle.begin(), byAngle.end());
    for (const auto& [angle, e] : byAngle) {
        out.edges.push_back(e);
        out.convex.push_back(solid.edges()[static_cast<std::size_t>(e)].convex);
    }
    return out;
}

/// The same mix, begun at another edge: the least of its rotations.
std::vector<bool> leastRotation(std::vector<bool> mix) {
    std::vector<bool> least = mix;
    for (std::size_t k = 0; k < mix.size(); ++k) {
        std::rotate(mix.begin(), mix.begin() + 1, mix.end());
        least = std::min(least, mix);
    }
    return least;
}

/// One corner of n edges for every mix of convex and concave ones, wherever it begins.
/// \param mixes  how many there are.
std::vector<Corner> cornersOf(int n, std::size_t mixes) {
    std::vector<Corner> out;
    std::set<std::vector<bool>> seen;
    Random random(static_cast<std::uint64_t>(n));
    for (int attempt = 0; attempt < 4000 && out.size() < mixes; ++attempt) {
        const auto solid = Solid::fromSpec(roofSpec(randomRays(n, random)));
        if (!solid) continue;
        Corner corner = cornerOf(*solid);
        // Where the corner lies on a line or in a plane it has fewer edges.
        if (corner.edges.size() != static_cast<std::size_t>(n)) continue;
        if (seen.insert(leastRotation(corner.convex)).second) out.push_back(std::move(corner));
    }
    return out;
}

void checkCorner(const Corner& corner, std::size_t subset, bool others, int segments) {
    FilletOptions options;
    options.segments = segments;
    for (std::size_t e = 0; e < corner.solid.edges().size(); ++e) {
        const auto at = std::find(corner.edges.begin(), corner.edges.end(), static_cast<int>(e));
        const auto place = static_cast<std::size_t>(at - corner.edges.begin());
        const bool chosen =
            at == corner.edges.end() ? others && e % 3 == 0 : ((subset >> place) & 1U) != 0;
        if (chosen)
            options.edges.push_back(
                {static_cast<int>(e), 0.06 + 0.01 * static_cast<double>(e % 4)});
    }
    if (options.edges.empty()) return;
    const auto cage = fillet(corner.solid, options);
    ASSERT_TRUE(cage);
    ASSERT_EQ(faultsByExactArithmetic(*cage), "");
    for (const FilletClamp& clamp : cage->clamped) EXPECT_GT(clamp.used, 0.0) << clamp.edge;
}

TEST(FilletCorner, EveryMixOfThreeToSixEdges) {
    // Mixes of so many edges that no rotation makes another one of.
    constexpr std::array<std::size_t, 4> kMixes{4, 6, 8, 14};
    std::size_t number = 0;
    for (std::size_t k = 0; k < kMixes.size(); ++k) {
        const int n = 3 + static_cast<int>(k);
        const std::vector<Corner> corners = cornersOf(n, kMixes[k]);
        ASSERT_EQ(corners.size(), kMixes[k]) << n;
        for (const Corner& corner : corners) {
            for (std::size_t subset = 0; subset < std::size_t{1} << corner.edges.size(); ++subset) {
                // Every segment count meets every kind of corner in turn.
                const int segments = 1 + static_cast<int>(number++ % kMaxFilletSegments);
                SCOPED_TRACE(::testing::Message()
                             << n << " edges, subset " << subset << ", segments " << segments);
                checkCorner(corner, subset, number % 2 == 0, segments);
                if (HasFatalFailure()) return;
            }
        }
    }
}

TEST(FilletCorner, FacesOfOnePlaneThatCrossInACornerAreNoFault) {
    // Four cubes like winding stairs: in the middle two faces of one plane meet in a point, and the
    // edges of each go on in the lines of the other's.
    std::vector<bool> filled(8, false);
    for (const std::size_t cell : {0U, 2U, 3U, 7U}) filled[cell] = true;
    const std::vector<double> line{0.0, 1.0, 2.0};
    const Solid stairs = solidOf(cellsSpec({line, line, line}, filled));
    for (int e = 0; e < static_cast<int>(stairs.edges().size()); ++e) {
        const auto cage = fillet(stairs, {{{e, 0.1}}, 2});
        ASSERT_TRUE(cage);
        EXPECT_EQ(faultsByExactArithmetic(*cage), "") << e;
        EXPECT_TRUE(cage->clamped.empty()) << e;
    }
}

}  // namespace
}  // namespace ew::test
