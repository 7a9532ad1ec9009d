// SPDX-License-Identifier: GPL-3.0-or-later
// Two changes of a solid that nearly meet: refused by one rule, whatever they are and however they
// meet.
#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "core/base/tolerance.h"
#include "core/solid/boolean.h"
#include "tests/solid/shapes.h"

namespace ew::test {
namespace {

Solid made(const PolyhedronSpec& spec) {
    auto solid = Solid::fromSpec(spec);
    if (!solid) solid = Solid::fromSpec(insideOut(spec));
    EXPECT_TRUE(solid) << solid.error().message;
    return *solid;
}

/// A block of 10 x 10 x 10, changed once.
Solid block(const PolyhedronSpec& tool, BooleanKind kind) {
    auto out = combine(made(box(Vec3(0, 0, 0), Vec3(10, 10, 10))), made(tool), kind);
    EXPECT_TRUE(out) << out.error().message;
    return out->solid;
}

/// A right prism over a polygon.
PolyhedronSpec upright(const std::vector<Vec2>& polygon, double low, double high) {
    PolyhedronSpec spec;
    const int n = static_cast<int>(polygon.size());
    for (const double z : {low, high}) {
        for (const Vec2& p : polygon) spec.vertices.emplace_back(p.x(), p.y(), z);
    }
    std::vector<int> top;
    for (int k = 0; k < n; ++k) {
        top.push_back(n + k);
        spec.faces.push_back({k, (k + 1) % n, n + (k + 1) % n, n + k});
    }
    std::vector<int> bottom;
    for (int k = n; k-- > 0;) bottom.push_back(k);
    spec.faces.push_back(top);
    spec.faces.push_back(bottom);
    return spec;
}

/// A trough with a V cross-section along x (or y), as deep as `low`; upside down a roof.
PolyhedronSpec wedge(bool alongY, double low, double high) {
    PolyhedronSpec spec;
    for (const double along : {-1.0, 11.0}) {
        for (const Vec2& p : {Vec2(3, high), Vec2(7, high), Vec2(5, low)}) {
            spec.vertices.push_back(alongY ? Vec3(p.x(), along, p.y()) : Vec3(along, p.x(), p.y()));
        }
    }
    spec.faces = {{0, 1, 2}, {3, 5, 4}, {0, 3, 4, 1}, {1, 4, 5, 2}, {2, 5, 3, 0}};
    return spec;
}

/// A pyramid over a square of the plane z = base with its apex there.
PolyhedronSpec spike(const Vec3& apex, double base) {
    PolyhedronSpec spec;
    for (const Vec2& p : {Vec2(-1, -1), Vec2(1, -1), Vec2(1, 1), Vec2(-1, 1)}) {
        spec.vertices.emplace_back(apex.x() + p.x(), apex.y() + p.y(), base);
    }
    spec.vertices.push_back(apex);
    spec.faces = {{0, 3, 2, 1}, {0, 1, 4}, {1, 2, 4}, {2, 3, 4}, {3, 0, 4}};
    return spec;
}

/// Two changes that are `gap` apart: the solid after the first one, the second one's body.
struct Change {
    Solid solid;
    Solid tool;
    BooleanKind kind;
};

struct Meeting {
    const char* name;
    std::function<Change(double gap)> make;
    const char* exactly;             ///< what becomes of it where they meet; empty: it is made
    const char* overlap = "sliver";  ///< ... and where they overlap by less than a hair
};

constexpr auto kAdd = BooleanKind::Add;
constexpr auto kCut = BooleanKind::Cut;

void PrintTo(const Meeting& m, std::ostream* out) { *out << m.name; }

std::vector<Meeting> meetings() {
    const auto two = [](BooleanKind kind, const Vec3& low, const Vec3& high,
                        const std::function<PolyhedronSpec(double)>& second) {
        return [=](double gap) {
            return Change{block(box(low, high), kind), made(second(gap)), kind};
        };
    };
    return {
        {"PocketsEdgeToEdge",
         two(kCut, {2, 2, 6}, {5, 5, 10},
             [](double g) { return box(Vec3(5 + g, 5 + g, 6), Vec3(8, 8, 10)); }),
         "touches-in-edge"},
        {"BossesEdgeToEdge",
         two(kAdd, {2, 2, 10}, {5, 5, 14},
             [](double g) { return box(Vec3(5 + g, 5 + g, 10), Vec3(8, 8, 14)); }),
         "touches-in-edge"},
        {"PocketsOfTwoDepthsEdgeToEdge",
         two(kCut, {2, 2, 6}, {5, 5, 10},
             [](double g) { return box(Vec3(5 + g, 5 + g, 3), Vec3(8, 8, 10)); }),
         "touches-in-edge"},
        {"PocketsWithAWallBetween",
         two(kCut, {2, 2, 6}, {5, 5, 10},
             [](double g) { return box(Vec3(5 + g, 2.5, 7), Vec3(8, 4, 10)); }),
         "", ""},
        {"BossesWithASlitBetween",
         two(kAdd, {2, 2, 10}, {5, 5, 14},
             [](double g) { return box(Vec3(5 + g, 2.5, 10), Vec3(8, 4, 13)); }),
         "", ""},
        {"BossesOfAllButOneHeight",
         two(kAdd, {2, 2, 10}, {5, 5, 14},
             [](double g) { return box(Vec3(5, 2.5, 10), Vec3(8, 4, 14 + g)); }),
         ""},
        {"PocketsOfAllButOneDepth",
         two(kCut, {2, 2, 6}, {5, 5, 10},
             [](double g) { return box(Vec3(5, 2.5, 6 + g), Vec3(8, 4, 10)); }),
         ""},
        {"PocketsFromBothSides",
         two(kCut, {2, 2, 6}, {5, 5, 10},
             [](double g) { return box(Vec3(3, 3, 0), Vec3(4, 4, 6 - g)); }),
         "", ""},
        {"PocketsCornerToCorner",
         two(kCut, {2, 2, 6}, {5, 5, 10},
             [](double g) { return box(Vec3(5 + g, 5 + g, 0), Vec3(8, 8, 6 - g)); }),
         "touches-in-point"},
        {"APocketAndTheOuterEdge",
         two(kCut, {0, 0, 6}, {5, 5, 10},
             [](double g) { return box(Vec3(5 + g, 5 + g, 6), Vec3(10, 10, 10)); }),
         "touches-in-edge"},
        {"ABossOverABoss",
         two(kAdd, {2, 2, 10}, {5, 5, 14},
             [](double g) { return box(Vec3(3, 3, 14 + g), Vec3(4, 4, 15)); }),
         "", ""},
        {"AThroughHoleAllButOut",
         two(kCut, {2, 2, 6}, {5, 5, 10},
             [](double g) { return box(Vec3(6, 2, 6), Vec3(10 - g, 5, 8)); }),
         "", ""},
        {"TroughsAcrossEachOther",
         [](double g) {
             return Change{block(wedge(false, 5, 11), kCut), made(wedge(true, 5 - g, -1)), kCut};
         },
         "touches-in-point"},
        {"RoofsAcrossEachOther",
         [](double g) {
             const Solid bar = made(box(Vec3(0, 0, 0), Vec3(10, 10, 1)));
             const Solid upright =
                 combine(bar, made(box(Vec3(0, 0, 1), Vec3(1, 10, 9))), kAdd)->solid;
             const Solid arch =
                 combine(upright, made(box(Vec3(1, 0, 8), Vec3(10, 10, 9))), kAdd)->solid;
             auto low = combine(arch, made(wedge(false, 5, 0.5)), kAdd);
             return Change{low->solid, made(wedge(true, 5 + g, 8.5)), kAdd};
         },
         "touches-in-point"},
        {"ASpikeAndTheBottomOfAPocket",
         two(kCut, {2, 2, 6}, {5, 5, 10},
             [](double g) {
                 return spike({3.5, 3.5, 6 - g}, -1);
             }),
         "touches-in-point"},
        {"ASpikeAndTheEdgeOfAPocket",
         two(kCut, {2, 2, 6}, {5, 5, 10},
             [](double g) {
                 return spike({5 + g, 3.5, 6 - g}, -1);
             }),
         "touches-in-point"},
    };
}

class NearTouch : public testing::TestWithParam<Meeting> {};

std::string outcomeOf(const Change& c) {
    const auto out = combine(c.solid, c.tool, c.kind);
    return out ? "" : std::string(errcName(out.error().code));
}

TEST_P(NearTouch, IsRefusedWhereNobodyCouldSeeIt) {
    // A size of 20 mm at the most: 1.5e-5 mm is what a drawing was seen to leave.
    for (const double gap : {1e-10, 1e-8, 1.5e-7, 1.5e-5, 1e-4}) {
        EXPECT_EQ(outcomeOf(GetParam().make(gap)), "sliver") << gap;
        // Within a rounding error nobody knows what was meant.
        const bool rounding = gap < 100.0 * tol::kSliverRelative;
        EXPECT_EQ(outcomeOf(GetParam().make(-gap)), rounding ? "sliver" : GetParam().overlap)
            << -gap;
    }
}

TEST_P(NearTouch, IsWhatItIsWhereTheyMeetExactlyOrAreApart) {
    EXPECT_EQ(outcomeOf(GetParam().make(0.0)), GetParam().exactly);
    for (const double gap : {0.01, 0.1}) {
        EXPECT_EQ(outcomeOf(GetParam().make(gap)), "") << gap;
        EXPECT_EQ(outcomeOf(GetParam().make(-gap)), "") << -gap;
    }
}

INSTANTIATE_TEST_SUITE_P(Boolean, NearTouch, testing::ValuesIn(meetings()),
                         [](const auto& one) { return std::string(one.param.name); });

// What the solid had before is not the change's doing.
TEST(NearTouch, AThinGapThatWasThereStopsNoChangeElsewhere) {
    const Solid slit = made(upright(
        {{0, 0}, {10, 0}, {10, 10}, {5 + 1.5e-5, 10}, {5 + 1.5e-5, 2}, {5, 2}, {5, 10}, {0, 10}}, 0,
        10));
    // Round the slit, on its own face.
    const Solid rim =
        made(upright({{1, 0.5}, {9.5, 0.5}, {9.5, 1.5}, {2, 1.5}, {2, 9}, {1, 9}}, -3, 0));
    const auto out = combine(slit, rim, kAdd);
    ASSERT_TRUE(out) << out.error().message;
}

}  // namespace
}  // namespace ew::test
