// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <cmath>
#include <cstdlib>
#include <functional>

#include "core/surface/fillet.h"
#include "tests/support/random_modifications.h"
#include "tests/surface/shapes.h"

namespace ew::test {
namespace {

/// Random cases of a kind; the environment variable EDGEWRIGHT_FILLET_CASES sets another number.
std::uint64_t caseCount() {
    const char* text = std::getenv("EDGEWRIGHT_FILLET_CASES");
    return text == nullptr ? 1000 : std::strtoull(text, nullptr, 10);
}

double sizeOf(const Solid& solid) { return (solid.bounds()[1] - solid.bounds()[0]).norm(); }

/// Random edges with random setbacks, from far too small to far too big.
FilletOptions randomFillet(const Solid& solid, Random& random) {
    FilletOptions options;
    options.segments = random.chance(0.5) ? 1 : 1 + random.index(6);
    const double share = random.chance(0.3) ? 1.0 : random.uniform(0.1, 0.9);
    const double least = random.uniform(-7.0, 1.0);
    for (std::size_t e = 0; e < solid.edges().size(); ++e) {
        if (!random.chance(share)) continue;
        const double setback = sizeOf(solid) * std::exp(random.uniform(least, least + 2.0) - 1.0);
        options.edges.push_back({static_cast<int>(e), setback});
    }
    if (options.edges.empty()) options.edges.push_back({0, 0.1 * sizeOf(solid)});
    return options;
}

/// Solids from a maker, by number, with random fillets: all valid, hardly an edge given up.
void checkFillets(const std::function<Solid(std::uint64_t)>& make) {
    int dropped = 0;
    int chosen = 0;
    for (std::uint64_t number = 0; number < caseCount(); ++number) {
        const Solid solid = make(number);
        Random random(Random::mix(number, 3));
        const FilletOptions options = randomFillet(solid, random);
        const auto cage = fillet(solid, options);
        ASSERT_TRUE(cage) << "case " << number << ": " << cage.error().message;
        ASSERT_EQ(faultsByExactArithmetic(*cage), "") << "case " << number;
        chosen += static_cast<int>(options.edges.size());
        for (const FilletClamp& clamp : cage->clamped) {
            if (clamp.used == 0.0) ++dropped;
        }
    }
    ::testing::Test::RecordProperty("chosen", chosen);
    ::testing::Test::RecordProperty("dropped", dropped);
    // Giving up on an edge is valid, but must stay rare.
    EXPECT_LE(dropped, chosen / 200);
}

TEST(FilletProperty, RandomFilletsOfRandomSolidsAreValid) { checkFillets(randomSolid); }

TEST(FilletProperty, RandomFilletsOfModifiedSolidsAreValid) {
    checkFillets([](std::uint64_t number) {
        Random random(Random::mix(number, 5));
        return randomModifiedSolid(8, random);
    });
}

RC_GTEST_PROP(FilletProperty, ConvexEdgesTakeAwayAndConcaveOnesAdd, ()) {
    const auto number = *rc::gen::inRange<std::uint64_t>(0, 1'000'000);
    const Solid solid = randomSolid(number);
    const bool convex = *rc::gen::arbitrary<bool>();
    FilletOptions options = edgesOfKind(solid, convex, 0.03 * sizeOf(solid), 1);
    options.segments = *rc::gen::inRange(1, 5);
    RC_PRE(!options.edges.empty());
    const auto cage = fillet(solid, options);
    RC_ASSERT(cage.has_value());
    const double volume = volumeOf(*cage);
    if (convex) {
        RC_ASSERT(volume < solid.volume());
    } else {
        RC_ASSERT(volume > solid.volume());
    }
}

RC_GTEST_PROP(FilletProperty, SmallSetbacksTendToTheSharpSolid, ()) {
    const auto number = *rc::gen::inRange<std::uint64_t>(0, 1'000'000);
    const Solid solid = randomSolid(number);
    double edges = 0.0;
    for (const SolidEdge& e : solid.edges()) {
        edges += (solid.vertices()[static_cast<std::size_t>(e.ends[0])] -
                  solid.vertices()[static_cast<std::size_t>(e.ends[1])])
                     .norm();
    }
    for (const double share : {1e-2, 1e-3, 1e-4}) {
        const double s = share * sizeOf(solid);
        const auto cage = fillet(solid, allEdges(solid, s, 2));
        RC_ASSERT(cage.has_value());
        // A strip cannot move more than the rectangle of its setbacks, along its edge.
        RC_ASSERT(std::abs(volumeOf(*cage) - solid.volume()) < s * s * edges);
    }
}

RC_GTEST_PROP(FilletProperty, WhatFitsIsNotClampedWhateverElseIsTooBig, ()) {
    const double x = *rc::gen::inRange(10, 40) * 0.1;
    const double y = *rc::gen::inRange(10, 40) * 0.1;
    const double z = *rc::gen::inRange(10, 40) * 0.1;
    const Solid box = solidOf(boxSpec({0, 0, 0}, {x, y, z}));
    const int big = *rc::gen::inRange(0, 12);
    FilletOptions options = allEdges(box, 0.2, 2);
    options.edges[static_cast<std::size_t>(big)].setback = 1000.0;
    const auto cage = fillet(box, options);
    RC_ASSERT(cage.has_value());
    RC_ASSERT(cage->clamped.size() == 1U);
    RC_ASSERT(cage->clamped[0].edge == big);
    RC_ASSERT(cage->clamped[0].used > 0.2);
}

}  // namespace
}  // namespace ew::test
