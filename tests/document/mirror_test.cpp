// SPDX-License-Identifier: GPL-3.0-or-later
// What is done on one side of the mirror plane is done on the other.
#include <gtest/gtest.h>

#include <QTemporaryDir>
#include <algorithm>
#include <limits>

#include "core/document/document_compare.h"
#include "core/document/replay.h"
#include "core/document/report.h"
#include "core/reading/interpret.h"
#include "tests/document/fixtures.h"
#include "tests/reading/reading_fixture.h"

namespace ew {
namespace {

using test::boxStrokes;

std::unique_ptr<Document> readingDocument() {
    return std::make_unique<Document>(test::shippedLibrary(), interpret);
}

void draw(Document& d, const Vec3& size, const Vec3& corner) {
    for (const Stroke& s : boxStrokes(d.camera(), size, corner)) ASSERT_TRUE(d.addStroke(s));
    const auto applied = d.apply();
    ASSERT_TRUE(applied) << applied.error().message;
}

/// Is every corner's mirror image a corner?
bool isSymmetric(const std::vector<Body>& bodies, const MirrorPlane& plane) {
    std::vector<Vec3> all;
    for (const Body& b : bodies) {
        for (const Vec3& v : b.solid.vertices()) all.push_back(b.pose.toWorld(v));
    }
    return std::all_of(all.begin(), all.end(), [&](const Vec3& p) {
        const Vec3 image = plane.image(p);
        return std::any_of(all.begin(), all.end(),
                           [&](const Vec3& q) { return (image - q).norm() < 1e-6; });
    });
}

const MirrorPlane kAcrossX{Vec3::Zero(), Vec3::UnitX()};

// The default camera puts the nearest corner of a new solid into the Sketch Plane, so what is drawn
// at a place does not come out there: a plane is put where the body came out.
MirrorPlane besideBody(const Document& d, double share) {
    const auto [low, high] = worldBounds(d.state().bodies.front());
    return {Vec3(low.x() + share * (high.x() - low.x()), 0, 0), Vec3::UnitX()};
}

TEST(Mirror, ANewSolidAcrossThePlaneBecomesOneWithItsImage) {
    const auto where = readingDocument();
    draw(*where, Vec3(60, 40, 30), Vec3(0, 0, 0));
    const double single = where->state().bodies[0].solid.volume();
    for (const double share : {-0.01, 0.0, 0.25, 0.5}) {
        const MirrorPlane plane = besideBody(*where, share);
        const auto d = readingDocument();
        ASSERT_TRUE(d->setMirror(plane));
        draw(*d, Vec3(60, 40, 30), Vec3(0, 0, 0));
        ASSERT_EQ(d->state().bodies.size(), 1U) << share;
        const Solid& both = d->state().bodies[0].solid;
        EXPECT_TRUE(isSymmetric(d->state().bodies, plane)) << share;
        EXPECT_EQ(both.faces().size(), 6U) << share;  // edges across the plane are one edge
        EXPECT_EQ(both.edges().size(), 12U) << share;
        // A face that lies nearly in the plane is put into it.
        const double wanted = 2.0 * single * (1.0 - share);
        EXPECT_NEAR(both.volume(), wanted, 1e-6 * single) << share;
    }
}

TEST(Mirror, ANewSolidAwayFromThePlaneGetsATwin) {
    const auto where = readingDocument();
    draw(*where, Vec3(60, 40, 30), Vec3(0, 0, 0));
    const auto d = readingDocument();
    const MirrorPlane plane = besideBody(*where, -1.0);
    ASSERT_TRUE(d->setMirror(plane));
    draw(*d, Vec3(60, 40, 30), Vec3(0, 0, 0));
    ASSERT_EQ(d->state().bodies.size(), 2U);
    EXPECT_TRUE(isSymmetric(d->state().bodies, plane));
    ASSERT_TRUE(d->undo());
    EXPECT_TRUE(d->state().bodies.empty());
    EXPECT_TRUE(d->state().mirror);
    ASSERT_TRUE(d->undo());
    EXPECT_FALSE(d->state().mirror);
}

/// A box with a mirror plane through its middle.
std::unique_ptr<Document> boxWithPlane() {
    auto d = readingDocument();
    draw(*d, Vec3(60, 40, 30), Vec3(0, 0, 0));
    const auto plane = besideBody(*d, 0.5);
    EXPECT_TRUE(d->setMirror(plane));
    return d;
}

/// The face whose outward normal is nearest to a direction.
FaceRef faceTowards(const Document& d, const Vec3& direction) {
    const Body& body = d.state().bodies.front();
    FaceRef best{0, -1};
    double most = -2.0;
    for (std::size_t f = 0; f < body.solid.faces().size(); ++f) {
        const double along = (body.pose.rotation * body.solid.faces()[f].normal).dot(direction);
        if (along <= most) continue;
        most = along;
        best.face = static_cast<int>(f);
    }
    return best;
}

TEST(Mirror, PullingAFacePullsItsImage) {
    const auto d = boxWithPlane();
    const double before = d->state().bodies[0].solid.volume();
    ASSERT_TRUE(d->pull({faceTowards(*d, Vec3::UnitX()), 5.0, PullWalls::Follow}));
    EXPECT_NEAR(d->state().bodies[0].solid.volume(), before * 70.0 / 60.0, 1e-6 * before);
    EXPECT_TRUE(isSymmetric(d->state().bodies, *d->state().mirror));
    // A face across the plane is its own image: it is pulled once.
    const double wide = d->state().bodies[0].solid.volume();
    ASSERT_TRUE(d->pull({faceTowards(*d, Vec3::UnitZ()), 30.0, PullWalls::Follow}));
    EXPECT_NEAR(d->state().bodies[0].solid.volume(), 2.0 * wide, 1e-6 * wide);
}

TEST(Mirror, WhatIsCutOnOneSideIsCutOnTheOther) {
    const auto d = boxWithPlane();
    const double before = d->state().bodies[0].solid.volume();
    // A corner of the top, cut away: a smaller box that shares the near upper corner.
    const Body& body = d->state().bodies.front();
    const auto [low, high] = worldBounds(body);
    const auto p = [&](double x, double y, double z) {
        return d->camera().project(Vec3(high.x() - x, low.y() + y, high.z() - z));
    };
    const Vec2 inner = p(15, 10, 8);
    for (const auto& [a, b] :
         {std::pair{p(15, 0, 0), p(15, 10, 0)}, std::pair{p(15, 10, 0), p(0, 10, 0)},
          std::pair{p(15, 0, 0), p(15, 0, 8)}, std::pair{p(0, 10, 0), p(0, 10, 8)},
          std::pair{p(15, 0, 8), p(0, 0, 8)}, std::pair{p(0, 0, 8), p(0, 10, 8)},
          std::pair{inner, p(15, 10, 0)}, std::pair{inner, p(15, 0, 8)},
          std::pair{inner, p(0, 10, 8)}}) {
        ASSERT_TRUE(d->addStroke(test::line(a, b)));
    }
    const auto applied = d->apply();
    ASSERT_TRUE(applied) << applied.error().message;
    EXPECT_NEAR(d->state().bodies[0].solid.volume(), before - 2.0 * 15 * 10 * 8, 1e-3 * before);
    EXPECT_TRUE(isSymmetric(d->state().bodies, *d->state().mirror));
    EXPECT_EQ(d->state().bodies[0].solid.faces().size(), 12U);
}

TEST(Mirror, FilletsArePutOnBothSides) {
    const auto d = boxWithPlane();
    const Body& body = d->state().bodies.front();
    const FaceRef right = faceTowards(*d, Vec3::UnitX());
    int edge = -1;
    for (std::size_t e = 0; e < body.solid.edges().size(); ++e) {
        const auto& faces = body.solid.edges()[e].faces;
        if (faces[0] == right.face || faces[1] == right.face) edge = static_cast<int>(e);
    }
    FilletRequest request;
    request.edges = {EdgeChoice::Which::Picked, {{0, edge}}};
    request.radius = 3.0;
    const auto done = d->fillet(request);
    ASSERT_TRUE(done) << done.error().message;
    EXPECT_EQ(done->edges, 2);
}

TEST(Mirror, IsKeptInScriptsAndFiles) {
    const auto d = boxWithPlane();
    ASSERT_TRUE(d->pull({faceTowards(*d, Vec3::UnitX()), 5.0, PullWalls::Follow}));
    const auto script = readSketchScript(writeSketchScript(d->recordedScript()));
    ASSERT_TRUE(script) << script.error().message;
    const auto again = readingDocument();
    ASSERT_EQ(replay(*again, *script, {}).firstFailure(), nullptr);
    EXPECT_TRUE(identicalDocuments(*d, *again));
    const QTemporaryDir folder;
    const QString path = folder.filePath(QStringLiteral("m.edgewright"));
    ASSERT_TRUE(d->save(path));
    const auto opened = readingDocument();
    const auto ok = opened->open(path);
    ASSERT_TRUE(ok) << ok.error().message;
    EXPECT_TRUE(opened->state().mirror == d->state().mirror);
    EXPECT_TRUE(identicalDocuments(*d, *opened));
}

TEST(Mirror, RefusesWhatIsNoPlane) {
    const auto d = readingDocument();
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const MirrorPlane& plane :
         {MirrorPlane{Vec3::Zero(), Vec3::Zero()}, MirrorPlane{Vec3(nan, 0, 0), Vec3::UnitX()},
          MirrorPlane{Vec3(1e13, 0, 0), Vec3::UnitX()}}) {
        const auto set = d->setMirror(plane);
        ASSERT_FALSE(set);
        EXPECT_EQ(set.error().code, Errc::BadValue);
    }
    EXPECT_EQ(d->setMirror(std::nullopt).error().code, Errc::NoChange);
    ASSERT_TRUE(d->setMirror(kAcrossX));
    EXPECT_EQ(d->setMirror(kAcrossX).error().code, Errc::NoChange);
    for (const char* step :
         {R"({"do": "mirror_plane"})", R"({"do": "mirror_plane", "point": [0, 0, 0]})",
          R"({"do": "mirror_plane", "point": [0, 0, 0], "normal": [0, 0, 0]})",
          R"({"do": "mirror_plane", "off": true, "point": [0, 0, 0]})"}) {
        EXPECT_FALSE(readScriptStep(step)) << step;
    }
    EXPECT_TRUE(readScriptStep(R"({"do": "mirror_plane", "off": true})"));
}

}  // namespace
}  // namespace ew
