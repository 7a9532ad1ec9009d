// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/reading/propose/modification.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "core/solid/boolean.h"
#include "tests/reading/reading_fixture.h"
#include "tests/support/modification_cases.h"
#include "tests/support/random.h"

namespace ew::test {
namespace {

InterpretOptions optionsFor(const Body& body, const Pose& pose) {
    InterpretOptions o;
    o.camera = defaultBoxCamera(pose);
    o.bodies = {body};
    return o;
}

void expectRight(const ModificationCase& c, const Interpretation& r) {
    ASSERT_TRUE(r.accepted) << c.name << ": " << (r.problem ? r.problem->message : "");
    const Candidate& best = r.candidates[static_cast<std::size_t>(*r.accepted)];
    EXPECT_EQ(best.operation, c.operation) << c.name;
    ASSERT_TRUE(best.result) << c.name;
    EXPECT_EQ(static_cast<int>(best.result->vertices().size()), c.vertices) << c.name;
    EXPECT_EQ(static_cast<int>(best.result->edges().size()), c.edges) << c.name;
    EXPECT_EQ(static_cast<int>(best.result->faces().size()), c.faces) << c.name;
    EXPECT_NEAR(best.result->volume() / c.volume, 1.0, 1e-6) << c.name;
}

Pose turned(double angle, const Vec3& axis) {
    Pose pose;
    pose.rotation = Eigen::AngleAxisd(angle, axis.normalized()).toRotationMatrix();
    pose.translation = Vec3(11, -7, 5);
    return pose;
}

TEST(Modification, ExactStrokesOnABoxGiveTheExactSolid) {
    for (const Pose& pose : {Pose{}, turned(0.7, Vec3(1, 2, 3))}) {
        for (const ModificationCase& c : boxModifications(pose)) {
            const InterpretOptions o = optionsFor(c.target, pose);
            expectRight(c, interpret(exactStrokes(linesOnPlane(c)), shippedLibrary(), o));
        }
    }
}

/// The cases of a target from the first two cameras from which each is legible.
std::vector<ModificationCase> legibleCases(std::vector<ModificationCase> (*of)(int)) {
    std::map<std::string, int> taken;
    std::vector<ModificationCase> cases;
    for (int view = 0; view < kModificationViews; ++view) {
        for (ModificationCase& c : of(view)) {
            if (taken[c.name] < 2 && c.legible()) {
                ++taken[c.name];
                cases.push_back(std::move(c));
            }
        }
    }
    return cases;
}

void expectAllRight(const std::vector<ModificationCase>& cases) {
    for (const ModificationCase& c : cases) {
        SCOPED_TRACE(c.scene + ", view " + std::to_string(c.view));
        InterpretOptions o;
        o.camera = c.camera;
        o.bodies = {c.target};
        expectRight(c, interpret(exactStrokes(linesOnPlane(c)), shippedLibrary(), o));
    }
}

TEST(Modification, FromOtherCameras) {
    expectAllRight(legibleCases([](int view) { return boxModifications({}, view); }));
}

TEST(Modification, AfterTenEarlierModifications) {
    const auto cases = legibleCases(workedBoxModifications);
    EXPECT_GE(cases.size(), 40u);
    expectAllRight(cases);
}

TEST(Modification, OnThePrismsSlopeAndEnd) {
    const auto cases = legibleCases(prismModifications);
    EXPECT_GE(cases.size(), 10u);
    expectAllRight(cases);
}

TEST(Modification, SidesThatLeanAlikeTellAFrustumsHeight) {
    const auto cases = legibleCases(frustumModifications);
    EXPECT_GE(cases.size(), 4u);
    expectAllRight(cases);
}

TEST(Modification, AgainstWallsBetweenBossesAndIntoHollows) {
    const auto cases = legibleCases(jointModifications);
    EXPECT_GE(cases.size(), 18u);
    expectAllRight(cases);
}

/// The exact drawing is read as it should be; then what stays out of the faces that are met.
Candidate adjustedOf(const ModificationCase& c) {
    InterpretOptions o;
    o.camera = c.camera;
    o.bodies = {c.target};
    const Interpretation r = interpret(exactStrokes(linesOnPlane(c)), shippedLibrary(), o);
    expectRight(c, r);
    if (r.candidates.size() < 2) {
        ADD_FAILURE() << c.name << ": no other candidate";
        return {};
    }
    EXPECT_EQ(r.accepted.value_or(-1), 0);
    EXPECT_EQ(r.candidates[0].readingId, "default");
    EXPECT_FALSE(r.candidates[0].notes.empty());
    EXPECT_EQ(r.candidates[1].readingId, "adjusted");
    EXPECT_TRUE(r.candidates[1].result);
    return r.candidates[1];
}

TEST(Modification, WhereHiddenFacesMeetAnEarlierSlotTheAdjustedCutComesNext) {
    const ModificationCase c = caseNamed(jointModifications(), "deeper crossing slot");
    const Candidate adjusted = adjustedOf(c);
    ASSERT_TRUE(adjusted.result);
    // As deep as the earlier slot: 80 x 20 x 15 less what that had taken.
    EXPECT_NEAR(adjusted.result->volume(), c.target.solid.volume() - 16500.0, 1e-6);
}

// Neither slope of the groove is parallel to a wall of the pocket.
TEST(Modification, WhereNoHiddenFaceIsParallelTheAdjustedCutStaysClear) {
    const ModificationCase c = caseNamed(jointModifications(), "pocket into the groove");
    const Candidate adjusted = adjustedOf(c);
    ASSERT_TRUE(adjusted.result);
    // 50 x 44 x 20 less what would come nearer to the groove than a distance threshold: its ridge
    // lies 7 mm behind the pocket's hidden wall.
    const double clear = 7.0 + Thresholds{}.distancePx * c.camera.worldPerPixel;
    EXPECT_NEAR(adjusted.result->volume(), c.target.solid.volume() - 50.0 * (44.0 - clear) * 20.0,
                1e-6);
    // Pocket and groove stay apart: 5 faces more.
    EXPECT_EQ(adjusted.result->faces().size(), c.target.solid.faces().size() + 5);
}

TEST(Modification, OrderAndDirectionOfTheStrokesDoNotMatter) {
    Random random(5);
    for (const ModificationCase& c : boxModifications()) {
        if (c.name != "corner notch by its outline" && c.name != "box flush with one edge" &&
            c.name != "pocket with its inside") {
            continue;
        }
        const InterpretOptions o = optionsFor(c.target, {});
        std::vector<Stroke> strokes = exactStrokes(linesOnPlane(c));
        random.shuffle(strokes);
        for (std::size_t i = 0; i < strokes.size(); i += 2) {
            std::reverse(strokes[i].samples.begin(), strokes[i].samples.end());
            for (std::size_t k = 0; k < strokes[i].samples.size(); ++k) {
                strokes[i].samples[k].timeMs = 8.0 * static_cast<double>(k);
            }
        }
        expectRight(c, interpret(strokes, shippedLibrary(), o));
    }
}

TEST(Modification, AskedForTheOtherOperationItDoesNotObeyBlindly) {
    for (const ModificationCase& c : boxModifications()) {
        if (c.name != "corner cut by a triangle" && c.name != "box inside a face") continue;
        InterpretOptions o = optionsFor(c.target, {});
        o.operation = c.operation == Operation::Add ? Operation::Cut : Operation::Add;
        const auto strokes = exactStrokes(linesOnPlane(c));
        for (const Candidate& k : interpret(strokes, shippedLibrary(), o).candidates) {
            EXPECT_EQ(k.operation, o.operation) << c.name;
        }
        o.operation = c.operation;
        expectRight(c, interpret(strokes, shippedLibrary(), o));
    }
}

TEST(Modification, ASketchBesideTheSolidIsANewBody) {
    const ModificationCase first = boxModifications().front();
    const InterpretOptions o = optionsFor(first.target, {});
    // A box by itself, far to the right of the solid on the Sketch Plane.
    const Vec2 y(1040, 160), a(960, 120), b(1140, 130), c(1045, 260);
    const Vec2 ab = a + b - y, bc = b + c - y, ca = c + a - y;
    const Interpretation r = interpret(
        exactStrokes(
            {{y, a}, {y, b}, {y, c}, {a, ab}, {b, ab}, {b, bc}, {c, bc}, {c, ca}, {a, ca}}),
        shippedLibrary(), o);
    ASSERT_TRUE(r.accepted);
    EXPECT_EQ(r.candidates[static_cast<std::size_t>(*r.accepted)].operation, Operation::Create);
}

TEST(Modification, ALineAlongAnEdgeOnlyChangesNothing) {
    const ModificationCase first = boxModifications().front();
    const InterpretOptions o = optionsFor(first.target, {});
    const Interpretation r = interpret(
        exactStrokes({{o.camera.project(Vec3(10, 0, 40)), o.camera.project(Vec3(70, 0, 40))}}),
        shippedLibrary(), o);
    EXPECT_FALSE(r.accepted);
    ASSERT_TRUE(r.problem);
    EXPECT_FALSE(r.problem->message.empty());
}

TEST(Modification, ExtractedEdgesAreToldFromStrokes) {
    for (const ModificationCase& c : boxModifications()) {
        if (c.name != "corner notch by its outline") continue;
        const InterpretOptions o = optionsFor(c.target, {});
        const Interpretation r = interpret(exactStrokes(linesOnPlane(c)), shippedLibrary(), o);
        const auto extracted =
            std::count_if(r.graph.edges.begin(), r.graph.edges.end(),
                          [](const GraphEdge& e) { return e.origin == EdgeOrigin::Model; });
        EXPECT_EQ(extracted, 3);
        EXPECT_EQ(r.graph.edges.size(), 9u);
    }
}

TEST(Modification, AShakyHandsNotchSnapsToTheBoxesDirections) {
    Random random(11);
    for (const ModificationCase& c : boxModifications()) {
        if (c.name != "edge notch by its outline" && c.name != "box over the whole face") continue;
        const InterpretOptions o = optionsFor(c.target, {});
        const Interpretation r =
            interpret(drawByHand(linesOnPlane(c), kLightHand, random), shippedLibrary(), o);
        ASSERT_TRUE(r.accepted) << c.name;
        const Candidate& best = r.candidates[static_cast<std::size_t>(*r.accepted)];
        ASSERT_TRUE(best.result);
        EXPECT_EQ(static_cast<int>(best.result->faces().size()), c.faces);
        const double change = std::abs(c.volume - c.target.solid.volume());
        EXPECT_NEAR(best.result->volume(), c.volume, 0.08 * change) << c.name;
        // Every edge of the result still runs along an axis of the box.
        for (const SolidEdge& e : best.result->edges()) {
            const Vec3 d = best.result->vertices()[static_cast<std::size_t>(e.ends[1])] -
                           best.result->vertices()[static_cast<std::size_t>(e.ends[0])];
            EXPECT_NEAR(d.cwiseAbs().maxCoeff(), d.norm(), 1e-9);
        }
    }
}

// Both slopes of a V lean alike: one of them is no upright that was drawn badly.
TEST(Modification, AHandsGroovesAndRoofsAreAsSteepOnBothSides) {
    constexpr std::uint64_t kDrawings = 12;
    std::uint64_t right = 0;
    std::uint64_t all = 0;
    for (const char* name : {"V groove by its outline", "V groove with its inside",
                             "roof over the whole face", "roof over a part"}) {
        for (const int view : {0, 5}) {
            const ModificationCase c = caseNamed(boxModifications({}, view), name);
            if (!c.told || !c.legible()) continue;
            InterpretOptions o;
            o.camera = c.camera;
            o.bodies = {c.target};
            for (std::uint64_t i = 0; i < kDrawings; ++i, ++all) {
                Random hand(Random::mix(23, i));
                const Interpretation r =
                    interpret(drawByHand(linesOnPlane(c), kNormalHand, hand), shippedLibrary(), o);
                if (!r.accepted) continue;
                const Candidate& k = r.candidates[static_cast<std::size_t>(*r.accepted)];
                const double change = std::abs(c.volume - c.target.solid.volume());
                right += k.result && k.operation == c.operation &&
                         std::abs(k.result->volume() - c.volume) < 0.15 * change;
            }
        }
    }
    EXPECT_GE(all, 5 * kDrawings);
    EXPECT_GE(static_cast<double>(right), 0.88 * static_cast<double>(all)) << all;
}

// A wall in nearly the same plane, but at the other end of the solid, draws nothing to it.
TEST(Modification, OnlyWhatIsNearInSpaceIsFlush) {
    const ModificationCase c = caseNamed(workedBoxModifications(1), "pocket with its inside");
    ASSERT_TRUE(c.legible());
    InterpretOptions o;
    o.camera = c.camera;
    o.bodies = {c.target};
    for (std::uint64_t i = 0; i < 10; ++i) {
        SCOPED_TRACE(i);
        Random hand(Random::mix(29, i));
        const Interpretation r =
            interpret(drawByHand(linesOnPlane(c), kLightHand, hand), shippedLibrary(), o);
        ASSERT_TRUE(r.accepted);
        const Candidate& k = r.candidates[static_cast<std::size_t>(*r.accepted)];
        EXPECT_EQ(k.templateId, "cube");
        ASSERT_TRUE(k.result);
        const double change = std::abs(c.volume - c.target.solid.volume());
        EXPECT_NEAR(k.result->volume(), c.volume, 0.1 * change);
    }
}

// The same lines could be a box further back, but that one would be hidden.
TEST(Modification, WhatIsAddedIsNotDrawnWhereTheSolidHidesIt) {
    Body body{solidOf(boxSpec(Vec3::Zero(), Vec3(320, 320, 40))), {}};
    const Solid boss = solidOf(boxSpec(Vec3(180, 180, 40), Vec3(220, 220, 60)));
    body.solid = combine(body.solid, boss, BooleanKind::Add)->solid;
    const PolyhedronSpec spec = boxSpec(Vec3(190, 190, 60), Vec3(210, 210, 76));
    InterpretOptions o;
    o.camera = modificationCamera(0, Vec3(190, 190, 60), {});
    o.camera.worldPerPixel = 0.2;
    o.bodies = {body};
    ModificationCase c{"slab", "box", 0, body, o.camera, Operation::Add, "cube", {}};
    c.lines = newVisibleLines(body, combine(body.solid, solidOf(spec), BooleanKind::Add)->solid,
                              o.camera);
    constexpr std::uint64_t kDrawings = 12;
    std::uint64_t right = 0;
    for (std::uint64_t i = 0; i < kDrawings; ++i) {
        Random hand(Random::mix(7, i));
        const Interpretation r =
            interpret(drawByHand(linesOnPlane(c), kNormalHand, hand), shippedLibrary(), o);
        if (!r.accepted) continue;
        const Candidate& k = r.candidates[static_cast<std::size_t>(*r.accepted)];
        Vec3 middle = Vec3::Zero();
        for (const Vec3& v : k.spec.vertices) middle += v / 8.0;
        right += k.spec.vertices.size() == 8 && (middle - Vec3(200, 200, 68)).norm() < 5.0;
    }
    EXPECT_GE(right, kDrawings - 1);
}

}  // namespace
}  // namespace ew::test
