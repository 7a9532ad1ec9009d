// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/solid/boolean.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "tests/solid/boolean_fixture.h"
#include "tests/solid/shapes.h"

namespace ew::test {
namespace {

// Every relation of two intervals, per axis ------------------------------------------------------

/// The target's interval is 3..7; the tool's stands in one of these ways to it. The other ways are
/// mirror images, which the rotations bring.
constexpr std::array<std::array<int, 2>, 8> kRelations{{
    {8, 10},  // beside
    {7, 9},   // touches
    {5, 9},   // overlaps
    {3, 5},   // starts
    {3, 7},   // equals
    {4, 6},   // inside
    {2, 8},   // contains
    {3, 8},   // contains, starting together
}};

TEST(BooleanTable, EveryRelationOfTwoBoxesUnderAllRotations) {
    int table = 0;
    for (std::size_t i = 0; i < kRelations.size(); ++i) {
        for (std::size_t j = i; j < kRelations.size(); ++j) {
            for (std::size_t k = j; k < kRelations.size(); ++k) {
                IntBox tool;
                const std::array<std::size_t, 3> pick{i, j, k};
                for (std::size_t a = 0; a < 3; ++a) {
                    tool.low[a] = kRelations[pick[a]][0];
                    tool.high[a] = kRelations[pick[a]][1];
                }
                ++table;
                for (const auto kind :
                     {BooleanKind::Add, BooleanKind::Cut, BooleanKind::Intersect}) {
                    checkUnderRotations({{{{3, 3, 3}, {7, 7, 7}}, BooleanKind::Add}, {tool, kind}});
                }
            }
        }
    }
    EXPECT_EQ(table, 120);
}

// Parts of several boxes -------------------------------------------------------------------------

constexpr auto kAdd = BooleanKind::Add;
constexpr auto kCut = BooleanKind::Cut;
constexpr auto kCommon = BooleanKind::Intersect;

struct Named {
    const char* name;
    std::vector<BoxStep> steps;
};

std::vector<Named> addedParts() {
    const BoxStep block{{{2, 2, 2}, {8, 8, 5}}, kAdd};
    const BoxStep wall{{{2, 2, 5}, {4, 8, 8}}, kAdd};
    return {
        {"boss inside a face", {block, {{{4, 4, 5}, {6, 6, 7}}, kAdd}}},
        {"boss flush with one edge", {block, {{{2, 4, 5}, {4, 6, 7}}, kAdd}}},
        {"boss flush with two edges", {block, {{{2, 2, 5}, {4, 4, 7}}, kAdd}}},
        {"boss over the whole face", {block, {{{2, 2, 5}, {8, 8, 7}}, kAdd}}},
        {"boss over half of the face", {block, {{{2, 2, 5}, {5, 8, 7}}, kAdd}}},
        {"boss hanging over an edge", {block, {{{1, 4, 5}, {4, 6, 7}}, kAdd}}},
        {"boss hanging over a corner", {block, {{{0, 0, 5}, {4, 4, 7}}, kAdd}}},
        {"boss hanging over all edges", {block, {{{1, 1, 5}, {9, 9, 7}}, kAdd}}},
        {"boss sunk into the face", {block, {{{4, 4, 3}, {6, 6, 7}}, kAdd}}},
        {"boss from the bottom through the top", {block, {{{4, 4, 2}, {6, 6, 7}}, kAdd}}},
        {"step, then level with it", {block, wall, {{{4, 2, 5}, {8, 8, 8}}, kAdd}}},
        {"step, then a box in the inner corner", {block, wall, {{{4, 4, 5}, {6, 6, 7}}, kAdd}}},
        {"step, then a box that is level with it", {block, wall, {{{4, 4, 5}, {6, 6, 8}}, kAdd}}},
        {"a bridge between two bosses",
         {block,
          {{{2, 3, 5}, {3, 5, 7}}, kAdd},
          {{{7, 3, 5}, {8, 5, 7}}, kAdd},
          {{{2, 3, 7}, {8, 5, 8}}, kAdd}}},
        {"a handle",
         {block,
          {{{3, 4, 5}, {4, 5, 8}}, kAdd},
          {{{6, 4, 5}, {7, 5, 8}}, kAdd},
          {{{4, 4, 7}, {6, 5, 8}}, kAdd}}},
        {"a handle that is filled again",
         {block,
          {{{3, 4, 5}, {4, 5, 8}}, kAdd},
          {{{6, 4, 5}, {7, 5, 8}}, kAdd},
          {{{4, 4, 7}, {6, 5, 8}}, kAdd},
          {{{4, 4, 5}, {6, 5, 7}}, kAdd}}},
        {"a second body joined later",
         {block, {{{2, 2, 7}, {8, 8, 9}}, kAdd}, {{{4, 4, 5}, {6, 6, 7}}, kAdd}}},
        {"a separate body, then one round both",
         {block, {{{2, 2, 7}, {8, 8, 9}}, kAdd}, {{{1, 1, 1}, {9, 9, 10}}, kAdd}}},
        {"two bosses that share an edge",
         {block, {{{3, 3, 5}, {5, 5, 7}}, kAdd}, {{{5, 5, 5}, {7, 7, 7}}, kAdd}}},
        {"two bosses that share a corner in the air",
         {block, {{{3, 3, 5}, {5, 5, 7}}, kAdd}, {{{5, 5, 7}, {7, 7, 9}}, kAdd}}},
        {"a box on an edge from outside", {block, {{{0, 0, 3}, {2, 2, 4}}, kAdd}}},
        {"a box that fills a cavity",
         {block, {{{4, 4, 3}, {6, 6, 4}}, kCut}, {{{4, 4, 3}, {6, 6, 4}}, kAdd}}},
        {"a box that fills half a cavity",
         {block, {{{4, 4, 3}, {6, 6, 4}}, kCut}, {{{4, 4, 3}, {5, 6, 4}}, kAdd}}},
        {"a box inside a cavity",
         {{{{1, 1, 1}, {9, 9, 9}}, kAdd},
          {{{2, 2, 2}, {8, 8, 8}}, kCut},
          {{{4, 4, 4}, {6, 6, 6}}, kAdd}}},
        {"a box inside a cavity inside a box",
         {{{{0, 0, 0}, {11, 11, 11}}, kAdd},
          {{{1, 1, 1}, {10, 10, 10}}, kCut},
          {{{2, 2, 2}, {9, 9, 9}}, kAdd},
          {{{3, 3, 3}, {8, 8, 8}}, kCut},
          {{{5, 5, 5}, {6, 6, 12}}, kAdd}}},
        {"a cavity opened by a face", {block, {{{4, 4, 3}, {6, 6, 5}}, kCut}}},
    };
}

std::vector<Named> cutParts() {
    const BoxStep block{{{2, 2, 2}, {8, 8, 8}}, kAdd};
    return {
        {"corner notch", {block, {{{6, 6, 6}, {9, 9, 9}}, kCut}}},
        {"corner notch, flush", {block, {{{6, 6, 6}, {8, 8, 8}}, kCut}}},
        {"edge notch", {block, {{{6, 4, 6}, {9, 6, 9}}, kCut}}},
        {"rabbet", {block, {{{6, 2, 6}, {8, 8, 8}}, kCut}}},
        {"slot", {block, {{{4, 1, 6}, {6, 9, 9}}, kCut}}},
        {"slot that leaves a thin wall", {block, {{{2, 2, 6}, {7, 8, 8}}, kCut}}},
        {"pocket", {block, {{{4, 4, 6}, {6, 6, 8}}, kCut}}},
        {"pocket with a wall of the outside", {block, {{{2, 4, 6}, {6, 6, 8}}, kCut}}},
        {"through-hole", {block, {{{4, 4, 2}, {6, 6, 8}}, kCut}}},
        {"through-hole and beyond", {block, {{{4, 4, 0}, {6, 6, 10}}, kCut}}},
        {"through-hole filled again",
         {block, {{{4, 4, 2}, {6, 6, 8}}, kCut}, {{{4, 4, 2}, {6, 6, 8}}, kAdd}}},
        {"hole plugged at one end",
         {block, {{{4, 4, 2}, {6, 6, 8}}, kCut}, {{{4, 4, 2}, {6, 6, 3}}, kAdd}}},
        {"hole with a lid over its border",
         {block, {{{4, 4, 2}, {6, 6, 8}}, kCut}, {{{3, 3, 8}, {7, 7, 9}}, kAdd}}},
        {"hole plugged at both ends: a cavity",
         {block,
          {{{4, 4, 2}, {6, 6, 8}}, kCut},
          {{{4, 4, 2}, {6, 6, 3}}, kAdd},
          {{{4, 4, 7}, {6, 6, 8}}, kAdd}}},
        {"cavity", {block, {{{4, 4, 4}, {6, 6, 6}}, kCut}}},
        {"cavity, then a bore into it",
         {block, {{{4, 4, 4}, {6, 6, 6}}, kCut}, {{{4, 4, 6}, {6, 6, 8}}, kCut}}},
        {"cavity, then a thin bore into it",
         {block, {{{3, 3, 3}, {7, 7, 6}}, kCut}, {{{4, 4, 5}, {5, 5, 9}}, kCut}}},
        {"two cavities", {block, {{{3, 3, 3}, {4, 4, 4}}, kCut}, {{{5, 5, 5}, {7, 7, 7}}, kCut}}},
        {"two cavities that share an edge",
         {block, {{{3, 3, 3}, {5, 5, 5}}, kCut}, {{{5, 5, 3}, {7, 7, 5}}, kCut}}},
        {"two cavities that share a corner",
         {block, {{{3, 3, 3}, {5, 5, 5}}, kCut}, {{{5, 5, 5}, {7, 7, 7}}, kCut}}},
        {"pocket whose corner reaches the outside's edge", {block, {{{6, 6, 4}, {8, 8, 6}}, kCut}}},
        {"pockets in two faces that share an edge",
         {block, {{{4, 4, 6}, {6, 6, 8}}, kCut}, {{{6, 4, 4}, {8, 6, 6}}, kCut}}},
        {"severed in the middle", {block, {{{4, 1, 1}, {6, 9, 9}}, kCut}}},
        {"severed, then joined",
         {block, {{{4, 1, 1}, {6, 9, 9}}, kCut}, {{{4, 4, 4}, {6, 6, 6}}, kAdd}}},
        {"severed into four",
         {block, {{{4, 1, 1}, {6, 9, 9}}, kCut}, {{{1, 4, 1}, {9, 6, 9}}, kCut}}},
        {"cut off at a plane", {block, {{{2, 2, 5}, {8, 8, 8}}, kCut}}},
        {"cut down to an edge: four corners left",
         {block,
          {{{4, 2, 2}, {6, 8, 8}}, kCut},
          {{{2, 4, 2}, {8, 6, 8}}, kCut},
          {{{2, 2, 4}, {8, 8, 6}}, kCut}}},
        {"two crossing slots of one depth",
         {block, {{{4, 2, 6}, {6, 8, 8}}, kCut}, {{{2, 4, 6}, {8, 6, 8}}, kCut}}},
        {"two crossing slots of different depth",
         {block, {{{4, 2, 6}, {6, 8, 8}}, kCut}, {{{2, 4, 5}, {8, 6, 8}}, kCut}}},
        {"notch whose wall runs into a groove",
         {block, {{{2, 4, 6}, {8, 5, 8}}, kCut}, {{{5, 4, 3}, {8, 8, 8}}, kCut}}},
        {"pocket into a pocket from another side",
         {block, {{{4, 4, 4}, {6, 6, 8}}, kCut}, {{{2, 4, 4}, {5, 6, 6}}, kCut}}},
        {"three crossing bores",
         {block,
          {{{4, 4, 1}, {6, 6, 9}}, kCut},
          {{{4, 1, 4}, {6, 9, 6}}, kCut},
          {{{1, 4, 4}, {9, 6, 6}}, kCut}}},
        {"three bores that miss each other",
         {block,
          {{{3, 3, 1}, {4, 4, 9}}, kCut},
          {{{5, 1, 3}, {6, 9, 4}}, kCut},
          {{{1, 5, 5}, {9, 6, 6}}, kCut}}},
        {"what is left is a frame, then common with a slab",
         {block, {{{3, 3, 2}, {7, 7, 8}}, kCut}, {{{0, 0, 4}, {10, 10, 6}}, kCommon}}},
        {"common with a box across a frame: two pieces",
         {block, {{{3, 3, 2}, {7, 7, 8}}, kCut}, {{{0, 4, 0}, {10, 6, 10}}, kCommon}}},
        {"the same pocket twice",
         {block, {{{4, 4, 6}, {6, 6, 8}}, kCut}, {{{4, 4, 6}, {6, 6, 8}}, kCut}}},
        {"a boss through a frame",
         {block, {{{3, 3, 2}, {7, 7, 8}}, kCut}, {{{4, 4, 0}, {6, 6, 10}}, kAdd}}},
    };
}

TEST(BooleanTable, AddedParts) {
    for (const Named& c : addedParts()) {
        SCOPED_TRACE(c.name);
        checkUnderRotations(c.steps);
    }
}

TEST(BooleanTable, CutParts) {
    for (const Named& c : cutParts()) {
        SCOPED_TRACE(c.name);
        checkUnderRotations(c.steps);
    }
}

// What is reported -------------------------------------------------------------------------------

const Eigen::Matrix3i kStill = Eigen::Matrix3i::Identity();

Solid block() { return movedBox({{2, 2, 2}, {8, 8, 8}}, kStill); }

TEST(Boolean, SeamsVanish) {
    const auto longer = combine(block(), movedBox({{8, 2, 2}, {11, 8, 8}}, kStill), kAdd);
    ASSERT_TRUE(longer);
    EXPECT_EQ(longer->solid.vertices().size(), 8U);
    EXPECT_EQ(longer->solid.edges().size(), 12U);
    EXPECT_EQ(longer->solid.faces().size(), 6U);
    EXPECT_EQ(longer->solid.volume(), 9.0 * 6 * 6);
}

TEST(Boolean, TellsWhereFacesComeFrom) {
    const Solid target = block();
    const Solid tool = movedBox({{4, 4, 6}, {6, 6, 9}}, kStill);
    for (const auto kind : {kAdd, kCut, kCommon}) {
        const auto out = combine(target, tool, kind);
        ASSERT_TRUE(out);
        ASSERT_EQ(out->report.faceOrigin.size(), out->solid.faces().size());
        for (std::size_t f = 0; f < out->solid.faces().size(); ++f) {
            const FaceOrigin& origin = out->report.faceOrigin[f];
            const Solid& from = origin.fromTool ? tool : target;
            const SolidFace& before = from.faces()[static_cast<std::size_t>(origin.face)];
            const SolidFace& after = out->solid.faces()[f];
            const double turned = origin.fromTool && kind == kCut ? -1.0 : 1.0;
            EXPECT_EQ(after.normal, Vec3(turned * before.normal));
            EXPECT_EQ(after.offset, turned * before.offset);
            if (out->report.faceUnchanged[f]) {
                EXPECT_FALSE(origin.fromTool);
                EXPECT_EQ(after.loops.size(), 1U);
            }
        }
        const auto unchanged =
            std::count(out->report.faceUnchanged.begin(), out->report.faceUnchanged.end(), true);
        EXPECT_EQ(unchanged, kind == kCommon ? 0 : 5);
    }
}

TEST(Boolean, TellsOfSeveredBodies) {
    const auto out = combine(block(), movedBox({{4, 1, 1}, {6, 9, 9}}, kStill), kCut);
    ASSERT_TRUE(out);
    EXPECT_EQ(out->report.shellsBefore, 1);
    EXPECT_EQ(out->report.shells, 2);
}

TEST(Boolean, FaceWithHolesIsOneFace) {
    const auto out = combine(block(), movedBox({{4, 4, 7}, {6, 6, 9}}, kStill), kAdd);
    ASSERT_TRUE(out);
    const auto& faces = out->solid.faces();
    EXPECT_EQ(std::count_if(faces.begin(), faces.end(),
                            [](const SolidFace& f) { return f.loops.size() == 2; }),
              1);
}

TEST(Boolean, NearMissesAreRefused) {
    for (const double gap : {1e-13, -1e-13, 1e-10, -1e-10}) {
        const auto tool = Solid::fromSpec(box(Vec3(4, 4, 8 + gap), Vec3(6, 6, 9)));
        ASSERT_TRUE(tool);
        const auto out = combine(block(), *tool, kAdd);
        ASSERT_FALSE(out) << gap;
        EXPECT_EQ(errcName(out.error().code), "sliver");
    }
    const auto tool = Solid::fromSpec(box(Vec3(4, 4, 8.001), Vec3(6, 6, 9)));
    const auto apart = combine(block(), *tool, kAdd);
    ASSERT_TRUE(apart);
    EXPECT_EQ(apart->report.shells, 2);
}

TEST(Boolean, AVertexInTheMiddleOfAFaceTouches) {
    PolyhedronSpec spike = pyramid(4);
    for (Vec3& p : spike.vertices) p = Vec3(5, 5, 9) - p;  // apex down, on the block's top
    for (auto& face : spike.faces) std::reverse(face.begin(), face.end());
    const auto tool = Solid::fromSpec(spike);
    ASSERT_TRUE(tool) << tool.error().message;
    const auto onto = combine(block(), *tool, kAdd);
    ASSERT_FALSE(onto);
    EXPECT_EQ(errcName(onto.error().code), "touches-in-point");
    const auto off = combine(block(), *tool, kCut);
    ASSERT_FALSE(off);
    EXPECT_EQ(errcName(off.error().code), "no-change");
}

TEST(Boolean, AnEdgeInTheMiddleOfAFaceTouches) {
    PolyhedronSpec roof;  // ridge down, on the block's top
    roof.vertices = {{4, 4, 9}, {4, 6, 9}, {4, 5, 8}, {6, 4, 9}, {6, 6, 9}, {6, 5, 8}};
    roof.faces = {{0, 1, 2}, {3, 5, 4}, {0, 3, 4, 1}, {1, 4, 5, 2}, {2, 5, 3, 0}};
    auto tool = Solid::fromSpec(roof);
    if (!tool) tool = Solid::fromSpec(insideOut(roof));
    ASSERT_TRUE(tool) << tool.error().message;
    const auto out = combine(block(), *tool, kAdd);
    ASSERT_FALSE(out);
    EXPECT_EQ(errcName(out.error().code), "touches-in-edge");
}

TEST(Boolean, TheSameInputGivesTheSameBits) {
    const Solid tool = movedBox({{3, 3, 6}, {6, 9, 9}}, kStill);
    const auto a = combine(block(), tool, kCut);
    const auto b = combine(block(), tool, kCut);
    ASSERT_TRUE(a && b);
    EXPECT_TRUE(a->solid.identicalTo(b->solid));
    EXPECT_EQ(a->solid.serialize(), b->solid.serialize());
}

}  // namespace
}  // namespace ew::test
