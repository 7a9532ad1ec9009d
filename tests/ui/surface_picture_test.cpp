// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures of cages, surfaces and strokes on them.
#include <gtest/gtest.h>

#include <QImage>
#include <QTemporaryDir>
#include <cmath>

#include "core/document/replay.h"
#include "core/document/sketch_script.h"
#include "core/document/store.h"
#include "ui/theme/colours.h"
#include "ui/viewport/offscreen.h"
#include "ui/viewport/sketch_plane.h"

namespace ew::test {

namespace {

Stroke straight(const Vec2& from, const Vec2& to) {
    Stroke stroke;
    for (int i = 0; i <= 30; ++i)
        stroke.samples.push_back({from + (to - from) * (i / 30.0), 1.0, 0.0});
    return stroke;
}

/// A document with a box of 60 x 40 x 25 mm in the middle of the picture.
std::unique_ptr<Document> boxDocument() {
    auto load = loadLibrary(std::string(EDGEWRIGHT_SOURCE_DIR) + "/resources/templates");
    EXPECT_TRUE(load);
    auto document = std::make_unique<Document>(load->library);
    const OrthographicCamera camera = document->camera();
    const auto at = [&](double x, double y, double z) {
        return camera.project({(x - 0.5) * 60, (y - 0.5) * 40, (z - 0.5) * 25});
    };
    const Vec2 c = at(1, 0, 1);
    const std::vector<std::array<Vec2, 2>> lines{
        {c, at(0, 0, 1)},           {c, at(1, 1, 1)},           {c, at(1, 0, 0)},
        {at(0, 0, 1), at(0, 1, 1)}, {at(0, 1, 1), at(1, 1, 1)}, {at(1, 1, 1), at(1, 1, 0)},
        {at(1, 1, 0), at(1, 0, 0)}, {at(1, 0, 0), at(0, 0, 0)}, {at(0, 0, 0), at(0, 0, 1)}};
    for (const auto& line : lines) EXPECT_TRUE(document->addStroke(straight(line[0], line[1])));
    EXPECT_TRUE(document->apply());
    return document;
}

/// A document in which an example was replayed.
std::unique_ptr<Document> example(const std::string& name) {
    const std::string folder = std::string(EDGEWRIGHT_SOURCE_DIR) + "/resources/";
    auto load = loadLibrary(folder + "templates");
    EXPECT_TRUE(load);
    auto document = std::make_unique<Document>(load->library);
    const auto text = readFileBytes(QString::fromStdString(folder + "examples/" + name + ".json"),
                                    kMaxScriptBytes);
    EXPECT_TRUE(text);
    EXPECT_EQ(replay(*document, *readSketchScript(*text), {}).firstFailure(), nullptr);
    return document;
}

double distanceOf(QRgb a, const QColor& b) {
    return std::hypot(qRed(a) - b.red(), std::hypot(qGreen(a) - b.green(), qBlue(a) - b.blue()));
}

class SurfacePicture : public testing::Test {
  protected:
    QImage picture(QSize size = {1280, 800}, const PictureLook& look = {}) {
        const QString path = folder_.filePath("picture.png");
        const auto done = renderScreenshot(*document_, path, size, look);
        EXPECT_TRUE(done) << done.error().message;
        return QImage(path);
    }
    /// How many px are near a colour.
    static int count(const QImage& image, const QColor& colour, double reach = 40.0) {
        int n = 0;
        for (int y = 0; y < image.height(); ++y) {
            for (int x = 0; x < image.width(); ++x) {
                n += distanceOf(image.pixel(x, y), colour) < reach;
            }
        }
        return n;
    }
    void fillet(double radius, int segments) {
        FilletRequest request;
        request.radius = radius;
        request.segments = segments;
        ASSERT_TRUE(document_->fillet(request));
    }
    void smooth() {
        SubdivisionSettings s;
        s.on = true;
        s.tolerance = 0.05;
        ASSERT_TRUE(document_->subdivide(s));
    }

    std::unique_ptr<Document> document_ = boxDocument();
    QTemporaryDir folder_;
};

}  // namespace

TEST_F(SurfacePicture, ASolidHasDarkEdgesAndASurfaceHasNone) {
    const int solid = count(picture(), lightColours().bodyEdge);
    EXPECT_GT(solid, 400);
    fillet(8, 2);
    smooth();
    EXPECT_LT(count(picture(), lightColours().bodyEdge), solid / 10);
    // Edges that stay sharp are lines again.
    ASSERT_TRUE(document_->sharpen({EdgeChoice::Which::Picked, {{0, 0}, {0, 1}, {0, 2}, {0, 3}}}));
    EXPECT_GT(count(picture(), lightColours().bodyEdge), solid / 10);
}

TEST_F(SurfacePicture, OcclusionDarkensHollowsAndNothingElse) {
    PictureLook look;
    look.occlusion = true;
    const auto darker = [&](const QImage& plain, const QImage& shadowed, int by) {
        int n = 0;
        for (int y = 0; y < plain.height(); ++y) {
            for (int x = 0; x < plain.width(); ++x) {
                n += qGray(plain.pixel(x, y)) - qGray(shadowed.pixel(x, y)) >= by;
            }
        }
        return n;
    };
    document_ = example("mouse");
    const QSize size(640, 400);
    const QImage plain = picture(size);
    const QImage shadowed = picture(size, look);
    ASSERT_EQ(plain.size(), shadowed.size());
    // The slot of the wheel and the hollow for the finger, a small part of the picture.
    EXPECT_GT(darker(plain, shadowed, 12), 400);
    EXPECT_LT(darker(plain, shadowed, 12), plain.width() * plain.height() / 10);
    EXPECT_LT(darker(shadowed, plain, 12), plain.width() * plain.height() / 100);
    const auto large = renderScreenshot(*document_, folder_.filePath("l.png"), {4097, 100}, look);
    ASSERT_FALSE(large);
    EXPECT_EQ(large.error().code, Errc::BadValue);
    // What is outside of the bodies stays as it is.
    for (const QPoint& p : {QPoint(5, 5), QPoint(634, 5), QPoint(634, 394)}) {
        EXPECT_LT(std::abs(qGray(plain.pixel(p)) - qGray(shadowed.pixel(p))), 12);
    }
}

TEST_F(SurfacePicture, ASurfaceIsShadedSmoothly) {
    fillet(11, 2);
    smooth();
    const QImage image = picture();
    // Across the upper edge towards the eye no two neighbours differ by much.
    const Body& body = document_->state().bodies[0];
    const auto bounds = body.solid.bounds();
    const Vec2 middle =
        document_->camera().project(body.pose.toWorld(0.5 * (bounds[0] + bounds[1])));
    int largest = 0;
    int whole = 0;
    for (int y = static_cast<int>(middle.y()) - 60; y < static_cast<int>(middle.y()) + 60; ++y) {
        const int x = static_cast<int>(middle.x());
        const int step = std::abs(qGray(image.pixel(x, y + 1)) - qGray(image.pixel(x, y)));
        largest = std::max(largest, step);
        whole += step;
    }
    EXPECT_LE(largest, 12);
    EXPECT_GE(whole, 20) << "yet the light falls off";
}

TEST_F(SurfacePicture, TheCageIsShownOnDemand) {
    fillet(8, 2);
    smooth();
    PictureLook look;
    const int without = count(picture({1280, 800}, look), lightColours().accent);
    look.cage = true;
    EXPECT_GT(count(picture({1280, 800}, look), lightColours().accent), without + 400);
}

TEST_F(SurfacePicture, AMappedStrokeHasItsColourAndIsWhole) {
    fillet(8, 2);
    smooth();
    const OrthographicCamera camera = document_->camera();
    ASSERT_TRUE(document_->addStroke(straight({600, 380}, {680, 420})));
    ASSERT_TRUE(document_->mapStrokes({200, 20, 30}));
    const QColor red(200, 20, 30);
    const auto missing = [&](const OrthographicCamera& view, const QImage& image) {
        int gaps = 0;
        for (const MappedCurve& curve : document_->shape()->curves) {
            for (const MappedPoint& p : curve.points) {
                const QPoint px = toPoint(view.project(p.position)).toPoint();
                gaps += distanceOf(image.pixel(px), red) > 60.0;
            }
        }
        return gaps;
    };
    EXPECT_EQ(missing(camera, picture()), 0);
    // From another side too: it lies on the surface and does not flicker with it.
    OrthographicCamera other = camera;
    other.direction = Vec3(-1, 1, -2).normalized();
    ASSERT_TRUE(document_->setCamera(other));
    EXPECT_EQ(missing(other, picture()), 0);
}

TEST_F(SurfacePicture, ATransparentPictureHasNothingBehindTheBody) {
    PictureLook look;
    look.transparent = true;
    const QImage image = picture({1280, 800}, look);
    ASSERT_TRUE(image.hasAlphaChannel());
    EXPECT_EQ(qAlpha(image.pixel(3, 3)), 0);
    EXPECT_EQ(qAlpha(image.pixel(640, 400)), 255);
    int partly = 0;
    for (int x = 0; x < 1280; ++x) {
        const int alpha = qAlpha(image.pixel(x, 400));
        partly += alpha > 0 && alpha < 255;
    }
    EXPECT_GE(partly, 1) << "the outline is antialiased";
    // Over its own background it looks as the opaque one does on the body.
    const QRgb opaque = picture().pixel(640, 400);
    EXPECT_LT(distanceOf(image.pixel(640, 400), QColor(opaque)), 6.0);
}

TEST_F(SurfacePicture, LargePicturesHaveNoSeams) {
    const QImage small = picture({1500, 938});
    const QImage large =
        picture({3000, 1876}).scaled(1500, 938, Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
    int different = 0;
    for (int y = 1; y < small.height() - 1; ++y) {
        // Where two tiles of the large picture meet.
        for (const int x : {1023, 1024}) {
            different += distanceOf(small.pixel(x, y), QColor(large.pixel(x, y))) > 60.0;
        }
    }
    EXPECT_LE(different, 12);
}

}  // namespace ew::test
