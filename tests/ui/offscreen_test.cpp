// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewport/offscreen.h"

#include <gtest/gtest.h>

#include <QFile>
#include <QImage>
#include <QTemporaryDir>

#include "core/document/replay.h"
#include "core/document/sketch_script.h"
#include "ui/theme/colours.h"
#include "ui/viewport/camera_moves.h"
#include "ui/viewport/sketch_plane.h"

namespace ew::test {

namespace {

std::unique_ptr<Document> newDocument() {
    auto load = loadLibrary(std::string(EDGEWRIGHT_SOURCE_DIR) + "/resources/templates");
    EXPECT_TRUE(load);
    return std::make_unique<Document>(load->library);
}

void addLine(Document& document, const Vec2& from, const Vec2& to) {
    Stroke stroke;
    for (int i = 0; i <= 30; ++i)
        stroke.samples.push_back({from + (to - from) * (i / 30.0), 1.0, 0.0});
    ASSERT_TRUE(document.addStroke(std::move(stroke)));
}

void drawBox(Document& document) {
    const OrthographicCamera camera = document.camera();
    const auto at = [&](double x, double y, double z) {
        return camera.project({(x - 0.5) * 60, (y - 0.5) * 40, (z - 0.5) * 25});
    };
    const Vec2 c = at(1, 0, 1);
    const std::vector<std::array<Vec2, 2>> lines{
        {c, at(0, 0, 1)},           {c, at(1, 1, 1)},           {c, at(1, 0, 0)},
        {at(0, 0, 1), at(0, 1, 1)}, {at(0, 1, 1), at(1, 1, 1)}, {at(1, 1, 1), at(1, 1, 0)},
        {at(1, 1, 0), at(1, 0, 0)}, {at(1, 0, 0), at(0, 0, 0)}, {at(0, 0, 0), at(0, 0, 1)}};
    for (const auto& line : lines) addLine(document, line[0], line[1]);
}

double distanceOf(QRgb a, const QColor& b) {
    return std::hypot(qRed(a) - b.red(), std::hypot(qGreen(a) - b.green(), qBlue(a) - b.blue()));
}

class Offscreen : public testing::Test {
  protected:
    QImage picture(const Document& document, QSize size, const PictureLook& look = {}) {
        const QString path = folder_.filePath("picture.png");
        const auto done = renderScreenshot(document, path, size, look);
        EXPECT_TRUE(done) << done.error().message;
        return QImage(path);
    }
    QTemporaryDir folder_;
};

}  // namespace

TEST_F(Offscreen, InkIsWhereItWasDrawn) {
    auto document = newDocument();
    addLine(*document, {200, 300}, {500, 300});
    const QImage image = picture(*document, {1280, 800});
    ASSERT_EQ(image.size(), QSize(1280, 800));
    EXPECT_LT(distanceOf(image.pixel(350, 300), lightColours().ink), 60.0);
    EXPECT_GT(distanceOf(image.pixel(350, 320), lightColours().ink), 250.0);
}

TEST_F(Offscreen, SolidHasThreeTonesAndDarkEdges) {
    auto document = newDocument();
    drawBox(*document);
    ASSERT_TRUE(document->apply());
    const QImage image = picture(*document, {1280, 800});
    std::vector<QRgb> tones;
    const Body& body = document->state().bodies.front();
    for (const SolidFace& face : body.solid.faces()) {
        if (body.pose.directionToWorld(face.normal).dot(document->camera().direction) > -0.05)
            continue;
        Vec3 middle = Vec3::Zero();
        for (const int v : face.loops[0]) {
            middle += body.pose.toWorld(body.solid.vertices()[static_cast<std::size_t>(v)]) /
                      static_cast<double>(face.loops[0].size());
        }
        const QPoint px = toPoint(document->camera().project(middle)).toPoint();
        tones.push_back(image.pixel(px));
        EXPECT_GT(distanceOf(tones.back(), lightColours().background), 20.0);
    }
    ASSERT_EQ(tones.size(), 3U);
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_GT(distanceOf(tones[i], QColor(tones[(i + 1) % 3])), 6.0) << "faces look alike";
    }
    int dark = 0;
    for (const SolidEdge& e : body.solid.edges()) {
        const auto at = [&](int v) {
            return body.pose.toWorld(body.solid.vertices()[static_cast<std::size_t>(v)]);
        };
        const QPoint px =
            toPoint(document->camera().project((at(e.ends[0]) + at(e.ends[1])) / 2)).toPoint();
        int best = 1000;
        for (int dx = -1; dx <= 1; ++dx) {
            for (int dy = -1; dy <= 1; ++dy) {
                best = std::min(best, qGray(image.pixel(px + QPoint(dx, dy))));
            }
        }
        if (best < 110) ++dark;
    }
    EXPECT_EQ(dark, 9) << "the visible edges, and no hidden one";
}

TEST_F(Offscreen, ASmallerPictureShowsTheSameThings) {
    auto document = newDocument();
    addLine(*document, {200, 300}, {500, 300});
    const QImage image = picture(*document, {640, 400});
    EXPECT_LT(distanceOf(image.pixel(175, 150), lightColours().ink), 120.0);
}

TEST_F(Offscreen, LinesAndGridOfALargePictureAreAsMuchLarger) {
    auto document = newDocument();
    drawBox(*document);
    ASSERT_TRUE(document->apply());
    addLine(*document, {150, 120}, {450, 160});
    PictureLook look;
    look.hiddenEdges = true;
    const QImage image = picture(*document, {1280, 800}, look);
    // Not a whole multiple of the size of a tile, nor of the viewport.
    const QImage large = picture(*document, {2600, 1625}, look);
    ASSERT_EQ(large.size(), QSize(2600, 1625));
    const QImage back = large.scaled(image.size(), Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
    // What is not background, by how much it is not.
    const auto ink = [&](const QImage& of, const QRect& area) {
        double sum = 0.0;
        for (int y = area.top(); y <= area.bottom(); ++y) {
            for (int x = area.left(); x <= area.right(); ++x) {
                sum += distanceOf(of.pixel(x, y), lightColours().background);
            }
        }
        return sum;
    };
    const QRect stroke(140, 110, 320, 60);
    const QRect grid(900, 500, 300, 200);
    for (const QRect& area : {stroke, grid, image.rect()}) {
        const double wanted = ink(image, area);
        ASSERT_GT(wanted, 1000.0);
        EXPECT_NEAR(ink(back, area) / wanted, 1.0, 0.15) << area.x();
    }
    int differ = 0;
    for (int y = 0; y < image.height(); ++y) {
        for (int x = 0; x < image.width(); ++x) {
            differ += distanceOf(image.pixel(x, y), QColor(back.pixel(x, y))) > 120.0 ? 1 : 0;
        }
    }
    EXPECT_LT(differ, 200) << "px that look otherwise";
}

TEST_F(Offscreen, WhatCannotBeWrittenIsSaid) {
    auto document = newDocument();
    EXPECT_EQ(renderScreenshot(*document, "/nowhere/at/all.png", {200, 200}).error().code,
              Errc::CannotWrite);
    const QString path = folder_.filePath("none.png");
    EXPECT_EQ(renderScreenshot(*document, path, {0, 200}).error().code, Errc::BadValue);
    EXPECT_EQ(renderScreenshot(*document, path, {20000, 200}).error().code, Errc::BadValue);
    EXPECT_FALSE(QFile::exists(path));
}

}  // namespace ew::test
