// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <QTemporaryDir>
#include <QUndoStack>
#include <algorithm>
#include <array>
#include <memory>

#include "core/document/document.h"
#include "core/document/replay.h"
#include "tests/document/fixtures.h"
#include "tests/support/modification_cases.h"

namespace ew::test {
namespace {

/// The edges of the cases' box that the default camera sees.
std::vector<Line2> boxOutline(const OrthographicCamera& camera) {
    const auto p = [&](int x, int y, int z) {
        return camera.project(Vec3(80 * x, 60 * y, 40 * z));
    };
    return {{p(0, 0, 0), p(1, 0, 0)}, {p(1, 0, 0), p(1, 1, 0)}, {p(0, 0, 1), p(1, 0, 1)},
            {p(1, 0, 1), p(1, 1, 1)}, {p(1, 1, 1), p(0, 1, 1)}, {p(0, 1, 1), p(0, 0, 1)},
            {p(0, 0, 0), p(0, 0, 1)}, {p(1, 0, 0), p(1, 0, 1)}, {p(1, 1, 0), p(1, 1, 1)}};
}

void draw(Document& d, const std::vector<Line2>& lines) {
    for (Stroke& s : exactStrokes(lines)) ASSERT_TRUE(d.addStroke(std::move(s)));
}

ModificationCase onBox(const std::string& name) { return caseNamed(boxModifications(), name); }

/// A document with the box, drawn.
std::unique_ptr<Document> withBox() {
    auto d = std::make_unique<Document>(shippedLibrary());
    EXPECT_TRUE(d->setCamera(defaultBoxCamera()));
    draw(*d, boxOutline(d->camera()));
    EXPECT_TRUE(d->apply());
    return d;
}

ApplyRequest asking(Operation operation) {
    ApplyRequest request;
    request.operation = operation;
    return request;
}

TEST(DocumentModification, AddsAndCutsAreNamedStepsThatCanBeTakenBack) {
    const auto d = withBox();
    ASSERT_EQ(d->state().bodies.size(), 1u);
    EXPECT_NEAR(d->state().bodies[0].solid.volume(), 192000, 1);
    const Solid box = d->state().bodies[0].solid;

    draw(*d, linesOnPlane(onBox("edge notch by its outline")));
    const auto cut = d->apply();
    ASSERT_TRUE(cut) << cut.error().message;
    EXPECT_EQ(d->undoStack().undoText(), QStringLiteral("Cut cube"));
    ASSERT_EQ(d->state().bodies.size(), 1u);
    EXPECT_NEAR(d->state().bodies[0].solid.volume(), 183000, 1);
    EXPECT_TRUE(d->pendingStrokes().empty());
    const Solid notched = d->state().bodies[0].solid;

    ASSERT_TRUE(d->undo());
    EXPECT_TRUE(d->state().bodies[0].solid.identicalTo(box));
    EXPECT_EQ(d->pendingStrokes().size(), 6u) << "the ink is back";
    ASSERT_TRUE(d->redo());
    EXPECT_TRUE(d->state().bodies[0].solid.identicalTo(notched));

    draw(*d, linesOnPlane(onBox("box on a side face")));
    ASSERT_TRUE(d->apply(asking(Operation::Add)));
    EXPECT_EQ(d->undoStack().undoText(), QStringLiteral("Add cube"));
    EXPECT_NEAR(d->state().bodies[0].solid.volume(), 183000 + 25 * 30 * 20, 1);
}

Vec3 worldEnd(const Body& body, int edge, std::size_t end) {
    const int v = body.solid.edges()[static_cast<std::size_t>(edge)].ends[end];
    return body.pose.toWorld(body.solid.vertices()[static_cast<std::size_t>(v)]);
}

TEST(DocumentModification, FilletsOfTheEdgesThatSurviveStay) {
    const auto d = withBox();
    FilletRequest all;
    all.radius = 5;
    ASSERT_TRUE(d->fillet(all));
    const Body box = d->state().bodies[0];
    const EdgeRef one{0, 7};
    FilletRequest other;
    other.edges = {EdgeChoice::Which::Picked, {one}};
    other.radius = 2;
    ASSERT_TRUE(d->fillet(other));
    ASSERT_TRUE(d->crease({EdgeChoice::Which::Picked, {one}}, 4.0));

    draw(*d, linesOnPlane(onBox("edge notch by its outline")));
    ASSERT_TRUE(d->apply());
    const auto& bodies = d->state().bodies;
    ASSERT_EQ(bodies[0].solid.edges().size(), 24U);
    int kept = 0;
    int changed = 0;
    for (int e = 0; e < 24; ++e) {
        const std::array<Vec3, 2> ends{worldEnd(bodies[0], e, 0), worldEnd(bodies[0], e, 1)};
        int within = -1;  // the edge of the box that it is a part of
        for (int old = 0; old < 12; ++old) {
            const Vec3 from = worldEnd(box, old, 0);
            const Vec3 to = worldEnd(box, old, 1);
            const auto excess = [&](const Vec3& p) {
                return (p - from).norm() + (p - to).norm() - (to - from).norm();
            };
            if (excess(ends[0]) < 1e-6 && excess(ends[1]) < 1e-6) within = old;
        }
        const double radius = d->state().surface.radius({0, e});
        if (within < 0) {
            EXPECT_EQ(radius, 0) << "a new edge is sharp";
            continue;
        }
        ++kept;
        const bool isOther = within == one.edge;
        changed += isOther;
        EXPECT_EQ(radius, isOther ? 2 : 5);
        EXPECT_EQ(d->state().surface.sharpness({0, e}), isOther ? 4 : kAutomaticSharpness);
    }
    EXPECT_EQ(kept, 13) << "twelve, one of them in two parts";
    EXPECT_GE(changed, 1);
    EXPECT_TRUE(d->shape()->hasCage());
    EXPECT_FALSE(d->shape()->problem);
    ASSERT_TRUE(d->undo());
    EXPECT_EQ(d->state().surface.radius(one), 2);
}

TEST(DocumentModification, AnImpossibleOperationLeavesSolidAndInk) {
    const auto d = withBox();
    const auto state = &d->state();
    draw(*d, linesOnPlane(onBox("corner cut by a triangle")));
    const auto added = d->apply(asking(Operation::Add));
    ASSERT_FALSE(added);
    EXPECT_FALSE(added.error().message.empty());
    EXPECT_EQ(&d->state(), state);
    EXPECT_EQ(d->pendingStrokes().size(), 3u);
    EXPECT_TRUE(d->apply(asking(Operation::Cut)));
}

TEST(DocumentModification, TheRecordedScriptReplaysToTheSameSolid) {
    const auto d = withBox();
    for (const char* name : {"edge notch by its outline", "box on a side face"}) {
        draw(*d, linesOnPlane(onBox(name)));
        ASSERT_TRUE(d->apply()) << name;
    }
    Document again(shippedLibrary());
    const QTemporaryDir folder;
    const ReplayReport report =
        replay(again, d->recordedScript(), {folder.path(), folder.path(), false});
    EXPECT_EQ(report.firstFailure(), nullptr);
    ASSERT_EQ(again.state().bodies.size(), 1u);
    EXPECT_TRUE(again.state().bodies[0].solid.identicalTo(d->state().bodies[0].solid));
}

}  // namespace
}  // namespace ew::test
