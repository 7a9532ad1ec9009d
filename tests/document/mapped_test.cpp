// SPDX-License-Identifier: GPL-3.0-or-later
// Strokes on the surface as the document keeps them.
#include <gtest/gtest.h>

#include <QFile>
#include <QTemporaryDir>
#include <QUndoStack>

#include "core/document/document.h"
#include "tests/document/fixtures.h"

namespace ew {
namespace {

using test::fakeDocument;
using test::line;

/// A box of 40 x 30 x 2 mm at (10, 20, 30), seen from above, one pixel a millimetre: its corner is
/// at (10, -20) from the middle of the picture.
std::unique_ptr<Document> seenFromAbove() {
    auto d = fakeDocument();
    EXPECT_TRUE(d->addStroke(line({100, 100}, {139, 129})));
    EXPECT_TRUE(d->apply());
    OrthographicCamera camera;
    camera.direction = Vec3(0, 0, -1);
    camera.up = Vec3(0, 1, 0);
    camera.worldPerPixel = 1.0;
    EXPECT_TRUE(d->setCamera(camera));
    return d;
}

Vec2 px(const Document& d, double x, double y) { return d.camera().project(Vec3(x, y, 32)); }

TEST(DocumentMapped, StrokesLieOnTheSurfaceAndCanBeTakenBack) {
    const auto d = seenFromAbove();
    ASSERT_TRUE(d->addStroke(line(px(*d, 15, 30), px(*d, 45, 40))));
    ASSERT_TRUE(d->addStroke(line(px(*d, -90, 30), px(*d, -70, 30))));  // beside the box
    const auto outcome = d->mapStrokes({200, 30, 40});
    ASSERT_TRUE(outcome) << outcome.error().message;
    EXPECT_EQ(outcome->mapped, 1);
    EXPECT_EQ(outcome->missed, 1);
    EXPECT_EQ(d->pendingStrokes().size(), 1U) << "the one beside the box stays";
    EXPECT_EQ(d->undoStack().undoText(), QStringLiteral("Map 1 stroke"));
    ASSERT_EQ(d->shape()->curves.size(), 1U);
    for (const MappedPoint& p : d->shape()->curves[0].points) {
        EXPECT_NEAR(p.position.z(), 32, 1e-9) << "on the upper face";
    }
    EXPECT_NEAR((d->shape()->curves[0].points.back().position - Vec3(45, 40, 32)).norm(), 0, 1e-9);
    EXPECT_EQ(d->mapStrokes().error().code, Errc::NoSurface);

    ASSERT_TRUE(d->undo());
    EXPECT_TRUE(d->shape()->curves.empty());
    EXPECT_EQ(d->pendingStrokes().size(), 2U) << "the ink is back";
    ASSERT_TRUE(d->redo());
    EXPECT_EQ(d->shape()->curves.size(), 1U);
    ASSERT_TRUE(d->unmapStrokes());
    EXPECT_TRUE(d->state().mapped.empty());
    EXPECT_EQ(d->unmapStrokes().error().code, Errc::NoStroke);
}

TEST(DocumentMapped, StrokesFollowTheSurfaceWhenItsSettingsChange) {
    const auto d = seenFromAbove();
    // Right across the box, over both long edges.
    ASSERT_TRUE(d->addStroke(line(px(*d, 30, 21), px(*d, 30, 49))));
    ASSERT_TRUE(d->mapStrokes());
    const auto lowest = [&] {
        double z = 1e9;
        for (const MappedCurve& c : d->shape()->curves) {
            for (const MappedPoint& p : c.points) z = std::min(z, p.position.z());
        }
        return z;
    };
    EXPECT_NEAR(lowest(), 32, 1e-9);
    FilletRequest r;
    r.radius = 1.5;
    EdgeChoice& edges = r.edges;
    edges.which = EdgeChoice::Which::Picked;
    edges.picked = {*nearestEdge(d->state().bodies, Vec3(30, 20, 32))};
    ASSERT_TRUE(d->fillet(r));
    EXPECT_NEAR(lowest(), 31.5, 1e-9) << "half a millimetre down the chamfer of 1.5 mm";
    ASSERT_TRUE(d->undo());
    EXPECT_NEAR(lowest(), 32, 1e-9);
    // Another view changes nothing.
    OrthographicCamera camera = d->camera();
    camera.direction = Vec3(1, 1, -1).normalized();
    ASSERT_TRUE(d->setCamera(camera));
    EXPECT_NEAR(lowest(), 32, 1e-9);
    ASSERT_TRUE(d->deleteBodies());
    EXPECT_TRUE(d->state().mapped.empty());
}

TEST(DocumentMapped, ExportsHoldTheOutermostShapeAndTheStrokes) {
    const auto d = seenFromAbove();
    const QTemporaryDir folder;
    const auto bytes = [&](const char* name) {
        const QString path = folder.filePath(name);
        const auto ok = d->exportTo(path);
        EXPECT_TRUE(ok) << name << ok.error().message;
        QFile file(path);
        EXPECT_TRUE(file.open(QIODevice::ReadOnly));
        return file.readAll();
    };
    const auto count = [](const QByteArray& text, const char* start) {
        int n = 0;
        for (const QByteArray& l : text.split('\n')) n += l.startsWith(start);
        return n;
    };
    EXPECT_EQ(count(bytes("a.obj"), "f "), 6);
    FilletRequest r;
    r.radius = 0.5;
    ASSERT_TRUE(d->fillet(r));
    EXPECT_EQ(count(bytes("a.obj"), "f "), 6 + 12 + 8) << "faces, strips, corners";
    ASSERT_TRUE(d->addStroke(line(px(*d, 15, 30), px(*d, 45, 40))));
    ASSERT_TRUE(d->mapStrokes());
    SubdivisionSettings s;
    s.on = true;
    s.levels = 2;
    ASSERT_TRUE(d->subdivide(s));
    const auto& surface = *d->shape()->bodies[0].surface;
    const QByteArray obj = bytes("a.obj");
    EXPECT_EQ(count(obj, "f "), static_cast<int>(surface.triangles.size()));
    EXPECT_EQ(count(obj, "vn "), static_cast<int>(surface.normals.size()));
    EXPECT_EQ(count(obj, "l "), static_cast<int>(d->shape()->curves.size()));
    EXPECT_GE(count(obj, "o stroke"), 1);
    EXPECT_EQ(bytes("a.stl").size(), 84 + 50 * static_cast<int>(surface.triangles.size()));
    EXPECT_TRUE(bytes("a.ply").startsWith("ply\n"));
    const QByteArray glb = bytes("a.glb");
    EXPECT_TRUE(glb.startsWith("glTF"));
    EXPECT_TRUE(glb.contains("\"mode\":3")) << "the strokes are line strips";
    EXPECT_TRUE(bytes("a.3mf").startsWith("PK"));
    EXPECT_EQ(d->exportTo(folder.filePath("a.step")).error().code, Errc::UnknownExtension);
}

}  // namespace
}  // namespace ew
