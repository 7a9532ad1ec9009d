// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reading/overlay/box_on_solid.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/reading/propose/placement.h"
#include "tests/reading/reading_fixture.h"
#include "tests/support/modification_cases.h"
#include "tests/support/random.h"

namespace ew::test {
namespace {

ModificationCase onBox(const std::string& name) { return caseNamed(boxModifications(), name); }

/// Every line without its ends: none meets another.
std::vector<Stroke> shortened(const ModificationCase& c, double share) {
    std::vector<Stroke> strokes;
    for (const Line2& l : linesOnPlane(c)) {
        const Vec2 off = share * (l[1] - l[0]);
        strokes.push_back(line(l[0] + off, l[1] - off));
    }
    return strokes;
}

struct Laid {
    std::vector<LaidBox> boxes;
    ModelView view;
};

Laid layOn(const ModificationCase& c, const std::vector<Stroke>& strokes) {
    ModelView view = *ModelView::make(c.target, c.camera);
    auto boxes = layBoxes(readInk(strokes, 14.0), view, entryOf("cube"), {});
    return {std::move(boxes), std::move(view)};
}

TEST(BoxOnSolid, NeedsNoLinesThatMeet) {
    for (const char* name :
         {"pocket with its inside", "pocket in the front", "box inside a face",
          "box on a side face", "square slot by its outline", "square slot with its inside",
          "edge notch by its outline", "corner notch by its outline",
          "corner notch with its inner Y", "box flush with one edge", "box flush with two edges",
          "box hanging over the border", "box over the whole face"}) {
        SCOPED_TRACE(name);
        const ModificationCase c = onBox(name);
        const Laid laid = layOn(c, shortened(c, 0.12));
        ASSERT_FALSE(laid.boxes.empty());
        const LaidBox& best = laid.boxes.front();
        EXPECT_EQ(best.operation, c.operation);
        EXPECT_EQ(best.strayPx, 0.0);
        const auto placed = placementsOn({best.operation, best.pairs}, *best.joint, best.reading,
                                         best.match, laid.view, {{}, 1.0, true});
        ASSERT_FALSE(placed.empty());
        // Where the pens stopped pulls a little.
        EXPECT_LT(placed.front().residualPx, 1.0);
    }
}

// A box that stands on a face and a pocket in it can be the same twelve lines; which of them are
// seen tells.
TEST(BoxOnSolid, APocketIsNoBoxTurnedInsideOut) {
    for (const char* name : {"pocket in the front", "box on the front"}) {
        SCOPED_TRACE(name);
        const ModificationCase c = onBox(name);
        const Laid laid = layOn(c, exactStrokes(linesOnPlane(c)));
        ASSERT_FALSE(laid.boxes.empty());
        for (const LaidBox& b : laid.boxes) {
            if (b.operation == c.operation) continue;
            EXPECT_GT(b.price + b.strayPx, 10.0);
        }
    }
}

TEST(BoxOnSolid, SaysWhatIsBareAndWhatIsLeftOver) {
    const ModificationCase c = onBox("box inside a face");
    auto strokes = shortened(c, 0.05);
    const double whole = layOn(c, strokes).boxes.front().price;
    EXPECT_EQ(whole, 0.0);
    const Vec2 a = strokes.back().samples.front().position;
    const Vec2 b = strokes.back().samples.back().position;
    // Half of a line is not drawn, and one leads away.
    strokes.back() = line(a, 0.5 * (a + b));
    strokes.push_back(line(a + Vec2(-40, 60), a + Vec2(60, 85)));
    const LaidBox best = layOn(c, strokes).boxes.front();
    EXPECT_GT(best.price, 0.0);
    EXPECT_NEAR(best.strayPx, std::hypot(100, 25), 2.0);
}

TEST(BoxOnSolid, InkBesideTheSolidLaysNothing) {
    const ModificationCase c = onBox("box inside a face");
    std::vector<Stroke> strokes = shortened(c, 0.0);
    for (Stroke& s : strokes) {
        for (PenSample& p : s.samples) p.position += Vec2(2000, 0);
    }
    EXPECT_TRUE(layOn(c, strokes).boxes.empty());
}

TEST(BoxOnSolid, OnlyBoxesAreLaid) {
    EXPECT_TRUE(isBox(*entryOf("cube")));
    for (const char* id : {"triangular-prism", "triangular-pyramid", "wedge-frustum", "l-prism"}) {
        EXPECT_FALSE(isBox(*entryOf(id))) << id;
    }
}

/// Of so many drawings by a hand, those that are taken for the change that was meant.
std::uint64_t rightOf(const ModificationCase& c, const HandLevel& level, std::uint64_t seed,
                      std::uint64_t drawings) {
    InterpretOptions o;
    o.camera = c.camera;
    o.bodies = {c.target};
    std::uint64_t right = 0;
    for (std::uint64_t i = 0; i < drawings; ++i) {
        Random hand(Random::mix(seed, i));
        const Interpretation r =
            interpret(drawByHand(linesOnPlane(c), level, hand), shippedLibrary(), o);
        if (!r.accepted) continue;
        const Candidate& k = r.candidates[static_cast<std::size_t>(*r.accepted)];
        right += k.result && k.operation == c.operation &&
                 static_cast<int>(k.result->faces().size()) == c.faces;
    }
    return right;
}

// Ends of a rough hand lie so far apart that joining them leads to nothing.
TEST(BoxOnSolid, RoughPocketsAndBoxesAreRead) {
    for (const char* name : {"pocket in the front", "box on the front"}) {
        EXPECT_GE(rightOf(onBox(name), kRoughHand, 17, 12), 10u) << name;
    }
}

// Three lines lead from wall to wall; the sides that stand at these are out of sight.
TEST(BoxOnSolid, BetweenTwoWallsTheLinesThatAreSeenDo) {
    constexpr std::uint64_t kDrawings = 8;
    std::uint64_t right = 0;
    std::uint64_t all = 0;
    for (const int view : {2, 6, 9}) {
        for (const ModificationCase& c : jointModifications(view)) {
            if (c.name != "bridge between the bosses" || !c.legible()) continue;
            right += rightOf(c, kLightHand, 5, kDrawings);
            all += kDrawings;
        }
    }
    EXPECT_EQ(all, 3 * kDrawings);
    EXPECT_GE(right, all - 1);
}

}  // namespace
}  // namespace ew::test
