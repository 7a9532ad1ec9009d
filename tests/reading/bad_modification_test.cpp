// SPDX-License-Identifier: GPL-3.0-or-later
// Drawings on a solid that mean nothing, or less than they seem to: a clear reason or a right
// result, never a crash or a broken solid.
#include <gtest/gtest.h>

#include <cmath>

#include "core/reading/interpret.h"
#include "core/solid/validity.h"
#include "core/solid/visibility.h"
#include "tests/reading/reading_fixture.h"
#include "tests/support/modification_cases.h"
#include "tests/support/random.h"

namespace ew::test {
namespace {

Body theBox() { return boxModifications().front().target; }

Interpretation readOn(const Body& body, const OrthographicCamera& camera, const Lines3& lines) {
    ModificationCase c{"", "", 0, body, camera, Operation::Auto, "", lines};
    InterpretOptions o;
    o.camera = camera;
    o.bodies = {body};
    return interpret(exactStrokes(linesOnPlane(c)), shippedLibrary(), o);
}

/// A reason with a sentence and a place, or a solid that can be.
void expectReasonOrSolid(const Interpretation& r) {
    if (r.accepted) {
        const Candidate& c = r.candidates[static_cast<std::size_t>(*r.accepted)];
        if (c.result) {
            EXPECT_GT(c.result->volume(), 0.0);
            EXPECT_GE(c.result->faces().size(), 4u);
        }
        return;
    }
    ASSERT_TRUE(r.problem);
    EXPECT_NE(r.problem->code, Errc::Internal);
    EXPECT_GT(r.problem->message.size(), 10u);
    EXPECT_FALSE(r.problem->where.empty());
}

TEST(BadModification, ALineAlongAnEdgeOnlyIsNoChange) {
    const auto r = readOn(theBox(), defaultBoxCamera(), {{Vec3(5, 0, 40), Vec3(75, 0, 40)}});
    EXPECT_FALSE(r.accepted);
    expectReasonOrSolid(r);
    EXPECT_EQ(r.problem->code, Errc::NoChange);
}

TEST(BadModification, TheWholeSolidDrawnAgainIsNoChange) {
    const Body box = theBox();
    const OrthographicCamera camera = defaultBoxCamera();
    Lines3 visible;
    for (const VisiblePiece& p : SolidView::make(box.solid, box.pose, camera)->visiblePieces()) {
        if (p.point) continue;
        const auto& ends = box.solid.edges()[static_cast<std::size_t>(p.edge)].ends;
        visible.push_back({box.solid.vertices()[static_cast<std::size_t>(ends[0])],
                           box.solid.vertices()[static_cast<std::size_t>(ends[1])]});
    }
    ASSERT_EQ(visible.size(), 9U);
    const auto r = readOn(box, camera, visible);
    EXPECT_FALSE(r.accepted);
    expectReasonOrSolid(r);
    EXPECT_EQ(r.problem->code, Errc::NoChange);
}

TEST(BadModification, ADrawingOverTheSolidIsNoNewBodyByItself) {
    // Pockets drawn so roughly that not all of them can be read.
    const std::vector<ModificationCase> cases = boxModifications();
    for (const ModificationCase& c : cases) {
        if (c.name != "pocket in the front") continue;
        InterpretOptions o;
        o.camera = c.camera;
        o.bodies = {c.target};
        for (const std::uint64_t seed : {12u, 13u, 16u, 23u}) {
            Random hand(Random::mix(17, seed));
            const Interpretation r =
                interpret(drawByHand(linesOnPlane(c), kRoughHand, hand), shippedLibrary(), o);
            if (!r.accepted) continue;
            EXPECT_NE(r.candidates[static_cast<std::size_t>(*r.accepted)].operation,
                      Operation::Create)
                << c.name << " " << seed;
        }
    }
}

TEST(BadModification, ASketchBesideTheSolidIsANewBody) {
    const auto r = readOn(
        theBox(), defaultBoxCamera(),
        newVisibleLines({solidOf(boxSpec(Vec3(500, 500, 0), Vec3(501, 501, 1))), {}},
                        solidOf(boxSpec(Vec3(150, 0, 0), Vec3(190, 30, 20))), defaultBoxCamera()));
    ASSERT_TRUE(r.accepted) << r.problem->message;
    const Candidate& c = r.candidates[static_cast<std::size_t>(*r.accepted)];
    EXPECT_EQ(c.operation, Operation::Create);
    EXPECT_EQ(c.templateId, "cube");
    const auto solid = Solid::fromSpec(c.spec);
    ASSERT_TRUE(solid);
    EXPECT_NEAR(solid->volume(), 40 * 30 * 20, 0.1);
}

TEST(BadModification, ABossSeenStraightAlongItsSidesIsNotTakenForAFrustum) {
    // Two rectangles: what tapers in a frustum would have to be seen.
    OrthographicCamera steep = defaultBoxCamera();
    steep.direction = Vec3(0, 1, -1).normalized();
    steep.up = Vec3::UnitZ();
    const Lines3 lines =
        joined(polyline({Vec3(20, 15, 40), Vec3(50, 15, 40), Vec3(50, 15, 55), Vec3(20, 15, 55),
                         Vec3(20, 15, 40)}),
               polyline({Vec3(20, 15, 55), Vec3(20, 40, 55), Vec3(50, 40, 55), Vec3(50, 15, 55)}));
    const auto on = readOn(theBox(), steep, lines);
    EXPECT_FALSE(on.accepted);
    expectReasonOrSolid(on);
    InterpretOptions o;
    o.camera = steep;
    ModificationCase c{"", "", 0, theBox(), steep, Operation::Auto, "", lines};
    const Interpretation free = interpret(exactStrokes(linesOnPlane(c)), shippedLibrary(), o);
    EXPECT_FALSE(free.accepted);
    ASSERT_TRUE(free.problem);
    EXPECT_EQ(free.problem->code, Errc::Ambiguous);
    EXPECT_FALSE(free.candidates.empty()) << "it is one choice all the same";
}

TEST(BadModification, ANotchWithoutDepthIsNoChange) {
    // There and back on the same line across the upper face.
    const auto r = readOn(theBox(), defaultBoxCamera(),
                          polyline({Vec3(20, 0, 40), Vec3(20, 20, 40), Vec3(20, 0, 40)}));
    EXPECT_FALSE(r.accepted);
    expectReasonOrSolid(r);
}

TEST(BadModification, ARectangleHalfOnAndHalfOffHasNoThirdDimension) {
    const auto r = readOn(theBox(), defaultBoxCamera(),
                          polyline({Vec3(60, 20, 40), Vec3(110, 20, 40), Vec3(110, 45, 40),
                                    Vec3(60, 45, 40), Vec3(60, 20, 40)}));
    EXPECT_FALSE(r.accepted);
    expectReasonOrSolid(r);
}

TEST(BadModification, SeenStraightFromAboveARectangleTellsNoDepth) {
    OrthographicCamera above = defaultBoxCamera();
    above.direction = -Vec3::UnitZ();
    above.up = Vec3::UnitY();
    const auto r = readOn(theBox(), above,
                          polyline({Vec3(20, 15, 40), Vec3(60, 15, 40), Vec3(60, 45, 40),
                                    Vec3(20, 45, 40), Vec3(20, 15, 40)}));
    EXPECT_FALSE(r.accepted);
    expectReasonOrSolid(r);
}

TEST(BadModification, SeenAlongAFaceWithEdgesEndOnNothingBreaks) {
    // The camera looks along y: the upper face is a line, edges along y are points.
    OrthographicCamera along = defaultBoxCamera();
    along.direction = Vec3::UnitY();
    along.up = Vec3::UnitZ();
    expectReasonOrSolid(
        readOn(theBox(), along,
               polyline({Vec3(20, 0, 40), Vec3(20, 0, 60), Vec3(50, 0, 60), Vec3(50, 0, 40)})));
    expectReasonOrSolid(
        readOn(theBox(), along, polyline({Vec3(0, 0, 25), Vec3(30, 0, 25), Vec3(30, 0, 40)})));
}

TEST(BadModification, APrismWhoseTriangleIsSeenEdgeOnIsNotGuessed) {
    OrthographicCamera front = defaultBoxCamera();
    front.direction = Vec3(0, 1, -0.5).normalized();
    front.up = Vec3::UnitZ();
    // A roof along x: its triangles lie along the view.
    const PolyhedronSpec roof =
        prismSpec({Vec3(20, 15, 40), Vec3(20, 45, 40), Vec3(20, 30, 60)}, Vec3(40, 0, 0));
    expectReasonOrSolid(readOn(
        theBox(), front,
        joined(polyline({roof.vertices[0], roof.vertices[2], roof.vertices[5], roof.vertices[3]}),
               polyline({roof.vertices[0], roof.vertices[3]}))));
}

TEST(BadModification, AScribbleOnTheSolidChangesNothing) {
    Lines3 scribble;
    for (int i = 0; i < 30; ++i) {
        scribble.push_back(
            {Vec3(20 + i, 15 + 20 * (i % 2), 40), Vec3(21 + i, 15 + 20 * ((i + 1) % 2), 40)});
    }
    const auto r = readOn(theBox(), defaultBoxCamera(), scribble);
    EXPECT_FALSE(r.accepted);
    expectReasonOrSolid(r);
}

TEST(BadModification, ACutThatWouldLeaveNothingIsRefused) {
    InterpretOptions o;
    o.camera = defaultBoxCamera();
    o.bodies = {theBox()};
    o.operation = Operation::Cut;
    // The outline of the whole box.
    ModificationCase c{"", "", 0, theBox(), o.camera, Operation::Cut, "", {}};
    c.lines = joined(polyline({Vec3(0, 0, 0), Vec3(80, 0, 0), Vec3(80, 60, 0), Vec3(80, 60, 40),
                               Vec3(0, 60, 40), Vec3(0, 0, 40), Vec3(0, 0, 0)}),
                     {{Vec3(80, 0, 40), Vec3(80, 0, 0)},
                      {Vec3(80, 0, 40), Vec3(80, 60, 40)},
                      {Vec3(80, 0, 40), Vec3(0, 0, 40)}});
    const Interpretation r = interpret(exactStrokes(linesOnPlane(c)), shippedLibrary(), o);
    for (const Candidate& k : r.candidates) {
        EXPECT_TRUE(!k.result || k.result->volume() > 0.0);
    }
    expectReasonOrSolid(r);
}

}  // namespace
}  // namespace ew::test
