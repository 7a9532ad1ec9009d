// SPDX-License-Identifier: GPL-3.0-or-later
// Commands on whole bodies, by hand and in scripts.
#include <gtest/gtest.h>

#include <QTemporaryDir>
#include <cmath>
#include <limits>
#include <nlohmann/json.hpp>

#include "core/document/document_compare.h"
#include "core/document/replay.h"
#include "core/document/report.h"
#include "core/document/store.h"
#include "tests/document/fixtures.h"

namespace ew {
namespace {

using test::fakeDocument;
using test::line;

/// So many boxes of 11 x 21 x 5, one over the other.
std::unique_ptr<Document> boxes(int count) {
    auto d = fakeDocument();
    for (int i = 0; i < count; ++i) {
        for (int k = 0; k < 4; ++k) EXPECT_TRUE(d->addStroke(line({0, 0}, {10, 20})));
        EXPECT_TRUE(d->apply(ApplyRequest{.candidate = 0, .templateId = {}, .obliqueFactor = {}}));
    }
    return d;
}

std::array<Vec3, 2> boundsOf(const Document& d, std::size_t body) {
    return summarize({d.state().bodies[body]}).bounds;
}

void expectNear(const Vec3& a, const Vec3& b) { EXPECT_LT((a - b).norm(), 1e-9) << a << "\n" << b; }

TEST(Bodies, MoveTurnScaleMirrorAndCopy) {
    const auto d = boxes(1);
    const auto before = boundsOf(*d, 0);
    const double volume = d->state().bodies[0].solid.volume();
    BodyMove by;
    by.translate = Vec3(1, 2, 3);
    ASSERT_TRUE(d->moveBody(0, by));
    expectNear(boundsOf(*d, 0)[0], before[0] + by.translate);

    BodyMove quarter;
    quarter.degrees = 90;
    ASSERT_TRUE(d->moveBody(0, quarter));
    const Vec3 size = boundsOf(*d, 0)[1] - boundsOf(*d, 0)[0];
    expectNear(size, Vec3(21, 11, 5));
    // Four of them leave no trace.
    const Pose turned = d->state().bodies[0].pose;
    for (int i = 0; i < 4; ++i) ASSERT_TRUE(d->moveBody(0, quarter));
    EXPECT_EQ(d->state().bodies[0].pose.rotation, turned.rotation);

    BodyMove twice;
    twice.scale = Vec3(2, 2, 2);
    ASSERT_TRUE(d->moveBody(0, twice));
    EXPECT_NEAR(d->state().bodies[0].solid.volume(), 8 * volume, 1e-9);
    BodyMove flat;
    flat.scale = Vec3(0.5, 1, 1);
    ASSERT_TRUE(d->moveBody(0, flat));
    expectNear(boundsOf(*d, 0)[1] - boundsOf(*d, 0)[0], Vec3(21, 22, 10));

    BodyMove mirror;
    mirror.mirror = BodyMove::Mirror{Vec3(100, 0, 0), Vec3(3, 0, 0)};
    mirror.copy = true;
    const auto copy = d->moveBody(0, mirror);
    ASSERT_TRUE(copy);
    EXPECT_EQ(*copy, 1);
    EXPECT_NEAR(boundsOf(*d, 1)[0].x(), 200 - boundsOf(*d, 0)[1].x(), 1e-9);
    EXPECT_EQ(d->state().bodies[1].solid.volume(), d->state().bodies[0].solid.volume());
    EXPECT_GT(d->state().bodies[1].pose.rotation.determinant(), 0.99);
}

TEST(Bodies, FilletsGoWithTheSolid) {
    const auto d = boxes(1);
    EdgeChoice edges;
    edges.which = EdgeChoice::Which::Picked;
    edges.picked = {{0, 3}};
    ASSERT_TRUE(d->fillet({edges, 1.0, std::nullopt, false}));
    const auto ends = d->state().bodies[0].solid.edges()[3].ends;
    BodyMove move;
    move.scale = Vec3(2, 2, 2);
    move.mirror = BodyMove::Mirror{};
    ASSERT_TRUE(d->moveBody(0, move));
    const auto& after = d->state().bodies[0].solid.edges();
    for (std::size_t e = 0; e < after.size(); ++e) {
        const bool same =
            std::minmax(after[e].ends[0], after[e].ends[1]) == std::minmax(ends[0], ends[1]);
        EXPECT_EQ(d->state().surface.radius({0, static_cast<int>(e)}), same ? 2.0 : 0.0);
    }
    ASSERT_TRUE(d->pull({{0, 0}, 3.0, PullWalls::Follow}));
    EXPECT_TRUE(d->state().surface.hasFillet());
}

TEST(Bodies, AreFoundByTheirNames) {
    const auto d = boxes(3);
    ASSERT_TRUE(d->nameBody(1, "Deckel"));
    EXPECT_EQ(d->nameBody(2, "Deckel").error().code, Errc::DuplicateId);
    EXPECT_EQ(d->nameBody(2, "Solid 1").error().code, Errc::DuplicateId);
    EXPECT_EQ(d->nameBody(2, std::string(300, 'x')).error().code, Errc::BadValue);
    EXPECT_EQ(d->nameBody(2, "two\nlines").error().code, Errc::BadValue);
    EXPECT_EQ(*findBody(d->state().bodies, "Deckel"), 1);
    EXPECT_EQ(*findBody(d->state().bodies, "Solid 3"), 2);
    EXPECT_FALSE(findBody(d->state().bodies, "Solid 2"));
    ASSERT_TRUE(d->deleteBody(0));
    EXPECT_EQ(*findBody(d->state().bodies, "Deckel"), 0);
    ASSERT_TRUE(d->undo());
    EXPECT_EQ(*findBody(d->state().bodies, "Deckel"), 1);
}

TEST(Bodies, AHiddenOneIsNeitherReadNorExportedNorCounted) {
    const auto d = boxes(2);
    ASSERT_TRUE(d->showBody(1, false));
    EXPECT_EQ(d->showBody(1, false).error().code, Errc::NoChange);
    const auto report = nlohmann::json::parse(writeReport(*d, {}, "s"));
    EXPECT_EQ(report["bodies"].size(), 2U);
    EXPECT_EQ(report["bodies"][1]["visible"], false);
    EXPECT_EQ(report["solid"]["volume"], report["bodies"][0]["volume"]);
    const QTemporaryDir folder;
    ASSERT_TRUE(d->exportTo(folder.filePath("one.stl")));
    const auto one = readFileBytes(folder.filePath("one.stl"), 1U << 20U);
    EXPECT_EQ(one->size(), 84U + 12U * 50U);
    ASSERT_TRUE(d->showBody(0, false));
    EXPECT_EQ(d->exportTo(folder.filePath("none.stl")).error().code, Errc::NoSolid);
    EXPECT_EQ(nearestFace(d->state().bodies, Vec3::Zero()).error().code, Errc::NoSolid);
    EXPECT_TRUE(nearestFace(d->state().bodies, Vec3::Zero(), 1));
    // Opened again it is as it was.
    ASSERT_TRUE(d->save(folder.filePath("d.edgewright")));
    const auto e = fakeDocument();
    ASSERT_TRUE(e->open(folder.filePath("d.edgewright")));
    EXPECT_TRUE(identicalDocuments(*d, *e));
    EXPECT_TRUE(e->state().bodies[0].hidden);
}

TEST(Bodies, AreJoinedAndSubtracted) {
    const auto d = boxes(2);
    const double volume = d->state().bodies[0].solid.volume();
    BodyMove beside;
    beside.translate = Vec3(11, 0, 0);
    ASSERT_TRUE(d->moveBody(1, beside));
    ASSERT_TRUE(d->combineBodies(0, 1, BooleanKind::Add));
    ASSERT_EQ(d->state().bodies.size(), 1U);
    EXPECT_NEAR(d->state().bodies[0].solid.volume(), 2 * volume, 1e-9);
    EXPECT_EQ(d->state().bodies[0].solid.faces().size(), 6U);
    ASSERT_TRUE(d->undo());

    BodyMove apart;
    apart.translate = Vec3(1, 0, 0);
    ASSERT_TRUE(d->moveBody(1, apart));
    EXPECT_EQ(d->combineBodies(0, 1, BooleanKind::Add).error().code, Errc::OperationImpossible);
    EXPECT_EQ(d->combineBodies(0, 1, BooleanKind::Cut).error().code, Errc::NoChange);
    EXPECT_EQ(d->combineBodies(0, 0, BooleanKind::Add).error().code, Errc::BadValue);
    BodyMove into;
    into.translate = Vec3(-7, 0, 0);
    ASSERT_TRUE(d->moveBody(1, into));
    ASSERT_TRUE(d->combineBodies(0, 1, BooleanKind::Cut));
    EXPECT_NEAR(d->state().bodies[0].solid.volume(), volume * 5 / 11, 1e-9);
}

TEST(Bodies, TurnedOnesThatTouchAreJoinedToo) {
    const auto d = boxes(2);
    const double volume = d->state().bodies[0].solid.volume();
    // Both turned by the same odd angle, one after the other, and put side by side.
    BodyMove turn;
    turn.axis = Vec3(0.3, -0.5, 0.8);
    turn.degrees = 37.3;
    turn.center = Vec3(10, 20, 30);
    for (const int body : {0, 1}) ASSERT_TRUE(d->moveBody(body, turn));
    BodyMove more = turn;
    more.degrees = 0.001;
    ASSERT_TRUE(d->moveBody(1, more));
    more.degrees = -0.001;
    ASSERT_TRUE(d->moveBody(1, more));
    BodyMove beside;
    beside.translate = d->state().bodies[0].pose.directionToWorld(Vec3(11, 0, 0));
    ASSERT_TRUE(d->moveBody(1, beside));
    const auto joined = d->combineBodies(0, 1, BooleanKind::Add);
    ASSERT_TRUE(joined) << joined.error().message;
    EXPECT_NEAR(d->state().bodies[0].solid.volume(), 2 * volume, 1e-6);
}

TEST(Bodies, AThousandMovesComeBack) {
    const auto d = boxes(1);
    const auto start = d->state().bodies;
    for (int i = 0; i < 200; ++i) {
        BodyMove move;
        move.degrees = 17.0 * i;
        move.axis = Vec3(1, i, 2);
        if (i % 3 == 0) move.mirror = BodyMove::Mirror{Vec3(i, 2, 3), Vec3(1, 2, i)};
        ASSERT_TRUE(d->moveBody(0, move)) << i;
        const Mat3& r = d->state().bodies[0].pose.rotation;
        ASSERT_LT((r * r.transpose() - Mat3::Identity()).norm(), 1e-12);
    }
    const auto script = writeSketchScript(d->recordedScript());
    const auto e = fakeDocument();
    ASSERT_EQ(replay(*e, *readSketchScript(script), {}).firstFailure(), nullptr);
    EXPECT_TRUE(test::sameState(d->state(), e->state()));
    ASSERT_TRUE(d->undo(200));
    EXPECT_TRUE(d->state().bodies[0].solid.identicalTo(start[0].solid));
    EXPECT_EQ(d->state().bodies[0].pose.rotation, start[0].pose.rotation);
}

TEST(Bodies, ScriptsNameThemByNumberOrName) {
    const std::string script = R"({"format": "edgewright-sketch", "version": 1, "steps": [
        {"do": "stroke", "points": [[0, 0], [10, 20]]}, {"do": "apply"},
        {"do": "name_body", "body": 0, "name": "Base"},
        {"do": "move_body", "body": "Base", "copy": true, "translate": [0, 0, 40]},
        {"do": "name_body", "body": "Solid 2", "name": "Lid"},
        {"do": "move_body", "body": "Lid", "rotate": {"axis": [0, 0, 1], "degrees": 90}},
        {"do": "move_body", "body": 1, "scale": 2},
        {"do": "move_body", "body": 1, "mirror": {"point": [0, 0, 0], "normal": [1, 0, 0]}},
        {"do": "pull", "at": [15, 30, 32], "distance": 5},
        {"do": "pull", "at": [15, 30, 37], "distance": -2.5, "body": "Base", "walls": "straight"},
        {"do": "show_body", "body": "Lid", "visible": false},
        {"do": "delete_body", "body": "Lid"}]})";
    const auto read = readSketchScript(script);
    ASSERT_TRUE(read) << read.error().message;
    const auto d = fakeDocument();
    const ReplayReport report = replay(*d, *read, {});
    ASSERT_EQ(report.firstFailure(), nullptr) << report.firstFailure()->error->message;
    ASSERT_EQ(d->state().bodies.size(), 1U);
    // 11 x 21 x 2, pulled up by 2.5.
    EXPECT_NEAR(d->state().bodies[0].solid.volume(), 11 * 21 * 4.5, 1e-9);
    EXPECT_TRUE(readSketchScript(writeSketchScript(d->recordedScript())));
}

TEST(Bodies, ALineCutsOneInTwo) {
    // A box of 100 mm drawn by its corners, and a line across its top and down its side.
    Document d(test::shippedLibrary());
    OrthographicCamera camera = d.camera();
    ASSERT_TRUE(d.setCamera(camera));
    const auto draw = [&](const Vec3& a, const Vec3& b) {
        Stroke s;
        for (int i = 0; i <= 20; ++i) {
            s.samples.push_back({camera.project(a + (b - a) * i / 20.0), 1.0, 0.0});
        }
        ASSERT_TRUE(d.addStroke(s));
    };
    const auto corner = [](int i) {
        return Vec3((i & 1) != 0 ? 100 : 0, (i & 2) != 0 ? 80 : 0, (i & 4) != 0 ? 60 : 0);
    };
    // The nine edges that are seen along (-1, 1, -1).
    for (const auto& [a, b] : std::vector<std::pair<int, int>>{
             {0, 1}, {1, 3}, {0, 4}, {1, 5}, {3, 7}, {4, 5}, {5, 7}, {7, 6}, {6, 4}}) {
        draw(corner(a), corner(b));
    }
    ASSERT_TRUE(d.apply());
    ASSERT_EQ(d.state().bodies.size(), 1U);
    const double volume = d.state().bodies[0].solid.volume();
    for (const SplitKeep keep : {SplitKeep::Larger, SplitKeep::Smaller, SplitKeep::Both}) {
        // Where the solid came to lie: its nearest corner is in the Sketch Plane.
        const Vec3 shift = [&] {
            const auto [low, high] = summarize(d.state().bodies).bounds;
            return Vec3(low);
        }();
        draw(shift + Vec3(25, 80, 60), shift + Vec3(25, 0, 60));
        draw(shift + Vec3(25, 0, 60), shift + Vec3(25, 0, 0));
        ApplyRequest request;
        request.operation = Operation::Split;
        request.keep = keep;
        const auto done = d.apply(request);
        ASSERT_TRUE(done) << done.error().message;
        const double first = d.state().bodies[0].solid.volume() / volume;
        EXPECT_NEAR(first, keep == SplitKeep::Smaller ? 0.25 : 0.75, 0.01);
        EXPECT_EQ(d.state().bodies.size(), keep == SplitKeep::Both ? 2U : 1U);
        if (keep == SplitKeep::Both) break;
        ASSERT_TRUE(d.undo());
        d.clearStrokes();
    }
    const auto read = readSketchScript(writeSketchScript(d.recordedScript()));
    ASSERT_TRUE(read) << read.error().message;
    Document e(test::shippedLibrary());
    ASSERT_EQ(replay(e, *read, {}).firstFailure(), nullptr);
    EXPECT_TRUE(test::sameState(d.state(), e.state()));
}

TEST(Bodies, AnOutlineOnAFaceIsPulledByItselfOnce) {
    const auto d = boxes(1);  // from (10, 20, 30), 11 x 21 x 5
    const double volume = d->state().bodies[0].solid.volume();
    const auto draw = [](Document& to, const std::vector<Vec3>& through) {
        Stroke s;
        for (std::size_t i = 0; i + 1 < through.size(); ++i) {
            for (int k = 0; k <= 10; ++k) {
                const Vec3 p = through[i] + (through[i + 1] - through[i]) * k / 10.0;
                s.samples.push_back({to.camera().project(p), 1.0, 0.0});
            }
        }
        return to.addStroke(s);
    };
    OrthographicCamera near = d->camera();
    near.center = Vec3(15, 30, 33);
    near.worldPerPixel = 0.02;
    ASSERT_TRUE(d->setCamera(near));
    ASSERT_TRUE(draw(*d, {{12, 24, 35}, {18, 24, 35}, {18, 34, 35}, {12, 34, 35}, {12, 24, 35}}));
    const auto outline = d->outlineAt({15, 30, 35});
    ASSERT_TRUE(outline) << outline.error().message;
    EXPECT_EQ(d->outlineAt({20.5, 40, 35}).error().code, Errc::NoRegion);
    PullRequest request{{0, outline->profile.face}, -2.0};
    request.outline = *outline;
    ASSERT_TRUE(d->pull(request));
    EXPECT_NEAR(d->state().bodies[0].solid.volume(), volume - 2 * 60, 0.5);
    EXPECT_TRUE(d->pendingStrokes().empty());
    // Ink comes back with undo, and the whole face can be pulled although there is an outline.
    ASSERT_TRUE(d->undo());
    EXPECT_EQ(d->pendingStrokes().size(), 1U);
    request.outline.reset();
    ASSERT_TRUE(d->pull(request));
    EXPECT_NEAR(d->state().bodies[0].solid.volume(), volume - 2 * 11 * 21, 1e-9);
    ASSERT_TRUE(d->undo());
    request.outline = *outline;
    request.distance = 3.0;
    ASSERT_TRUE(d->pull(request));
    EXPECT_NEAR(d->state().bodies[0].solid.volume(), volume + 3 * 60, 0.5);
    const auto read = readSketchScript(writeSketchScript(d->recordedScript()));
    ASSERT_TRUE(read) << read.error().message;
    const auto e = fakeDocument();
    const ReplayReport report = replay(*e, *read, {});
    ASSERT_EQ(report.firstFailure(), nullptr) << report.firstFailure()->error->message;
    EXPECT_TRUE(test::sameState(d->state(), e->state()));
}

TEST(Bodies, ScriptsWithBadBodiesAreRefused) {
    const std::vector<std::pair<const char*, Errc>> table{
        {R"({"do": "pull", "distance": 5})", Errc::MissingKey},
        {R"({"do": "pull", "at": [0, 0, 0]})", Errc::MissingKey},
        {R"({"do": "pull", "at": [0, 0], "distance": 5})", Errc::BadValue},
        {R"({"do": "pull", "at": [0, 0, 0], "distance": "5"})", Errc::WrongType},
        {R"({"do": "pull", "at": [0, 0, 0], "distance": 5, "walls": "round"})", Errc::BadValue},
        {R"({"do": "pull", "at": [0, 0, 0], "distance": 5, "body": -1})", Errc::BadValue},
        {R"({"do": "move_body", "translate": [1, 2, 3]})", Errc::MissingKey},
        {R"({"do": "move_body", "body": "", "translate": [1, 2, 3]})", Errc::BadValue},
        {R"({"do": "move_body", "body": 0, "turn": 5})", Errc::UnknownKey},
        {R"({"do": "move_body", "body": 0, "rotate": {"axis": [0, 0, 1]}})", Errc::MissingKey},
        {R"({"do": "move_body", "body": 0, "copy": 1})", Errc::WrongType},
        {R"({"do": "combine_bodies", "body": 0, "with": 1, "how": "glue"})", Errc::BadValue},
        {R"({"do": "show_body", "body": 0, "visible": 1})", Errc::WrongType}};
    for (const auto& [step, code] : table) {
        const auto read = readScriptStep(step);
        ASSERT_FALSE(read) << step;
        EXPECT_EQ(read.error().code, code) << step << "\n" << read.error().message;
    }
    const auto d = boxes(1);
    const double nan = std::numeric_limits<double>::quiet_NaN();
    std::vector<BodyMove> bad(6);
    bad[0].scale = Vec3::Zero();
    bad[1].scale = Vec3(1, -1, 1);
    bad[2].translate = Vec3(nan, 0, 0);
    bad[3].translate = Vec3(1e15, 0, 0);
    bad[4].degrees = nan;
    bad[5].axis = Vec3::Zero();
    for (std::size_t i = 0; i < bad.size(); ++i) {
        EXPECT_EQ(d->moveBody(0, bad[i]).error().code, Errc::BadValue) << i;
    }
    EXPECT_EQ(d->moveBody(7, {}).error().code, Errc::BadValue);
    EXPECT_EQ(d->pull({{7, 0}, 1.0}).error().code, Errc::BadValue);
    EXPECT_EQ(fakeDocument()->deleteBody(0).error().code, Errc::NoSolid);
}

TEST(Bodies, AFaceOfAHiddenSolidIsPulledByAScriptToo) {
    const auto d = boxes(1);
    ASSERT_TRUE(d->showBody(0, false));
    ASSERT_TRUE(d->pull({FaceRef{0, 0}, 2.0, PullWalls::Follow}));
    const auto again = fakeDocument();
    const ReplayReport report = replay(*again, d->recordedScript(), {});
    ASSERT_EQ(report.firstFailure(), nullptr) << report.firstFailure()->error->message;
    EXPECT_TRUE(identicalStates(d->state(), again->state()));
}

}  // namespace
}  // namespace ew
