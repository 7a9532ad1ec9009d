// SPDX-License-Identifier: GPL-3.0-or-later
// Parts of the window that need no window.
#include <gtest/gtest.h>

#include <QPainter>
#include <QStyleOption>
#include <numbers>

#include "ui/theme/colours.h"
#include "ui/theme/outlined_style.h"
#include "ui/viewport/camera_moves.h"
#include "ui/viewport/ink_layer.h"
#include "ui/viewport/sketch_plane.h"
#include "ui/viewport/wireframe.h"

namespace ew::test {

namespace {

PolyhedronSpec box(const Vec3& low, const Vec3& high) {
    PolyhedronSpec spec;
    for (int i = 0; i < 8; ++i) {
        spec.vertices.emplace_back((i & 1) != 0 ? high.x() : low.x(),
                                   (i & 2) != 0 ? high.y() : low.y(),
                                   (i & 4) != 0 ? high.z() : low.z());
    }
    spec.faces = {{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4},
                  {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}};
    return spec;
}

/// An L standing on its side: its notch hides parts of edges from some sides.
PolyhedronSpec lPrism() {
    PolyhedronSpec spec;
    const std::vector<Vec2> outline{{0, 0}, {40, 0}, {40, 15}, {15, 15}, {15, 40}, {0, 40}};
    const int n = static_cast<int>(outline.size());
    for (const double z : {0.0, 20.0}) {
        for (const Vec2& p : outline) spec.vertices.emplace_back(p.x(), p.y(), z);
    }
    std::vector<int> top;
    std::vector<int> bottom;
    for (int i = 0; i < n; ++i) {
        top.push_back(n + i);
        bottom.push_back(n - 1 - i);
        const int j = (i + 1) % n;
        spec.faces.push_back({i, j, n + j, n + i});
    }
    spec.faces.push_back(top);
    spec.faces.push_back(bottom);
    return spec;
}

double lengthOf(const std::vector<WireSegment>& segments, bool hidden) {
    double sum = 0.0;
    for (const WireSegment& s : segments) {
        if (s.hidden == hidden) sum += (s.ends[1] - s.ends[0]).norm();
    }
    return sum;
}

}  // namespace

TEST(Wireframe, BoxShowsNineEdgesAndHidesThree) {
    const auto segments = wireSegments(box({0, 0, 0}, {3, 2, 1}), {}, OrthographicCamera());
    EXPECT_EQ(std::count_if(segments.begin(), segments.end(),
                            [](const WireSegment& s) { return s.hidden; }),
              3);
    EXPECT_EQ(segments.size(), 12U);
    EXPECT_EQ(seenFaces(box({0, 0, 0}, {3, 2, 1}), {}, OrthographicCamera()).size(), 3U);
}

TEST(Wireframe, NothingIsLostOrDoubledFromAnySide) {
    const PolyhedronSpec shape = lPrism();
    for (int i = 0; i < 60; ++i) {
        OrthographicCamera camera;
        const double a = 0.1 + i * 0.37;
        const double b = -1.3 + i * 0.043;
        camera.direction = Vec3(std::cos(a) * std::cos(b), std::sin(a) * std::cos(b), std::sin(b));
        const auto segments = wireSegments(shape, {}, camera);
        double all = 0.0;
        for (std::size_t f = 0; f < shape.faces.size(); ++f) {
            const auto& loop = shape.faces[f];
            for (std::size_t k = 0; k < loop.size(); ++k) {
                const Vec3& p = shape.vertices[static_cast<std::size_t>(loop[k])];
                const Vec3& q =
                    shape.vertices[static_cast<std::size_t>(loop[(k + 1) % loop.size()])];
                all += (camera.project(p) - camera.project(q)).norm() / 2;  // each edge twice
            }
        }
        EXPECT_NEAR(lengthOf(segments, false) + lengthOf(segments, true), all, 1e-6 * all);
        EXPECT_GT(lengthOf(segments, true), 0.0);
    }
}

TEST(Wireframe, TheNotchHidesPartOfAnEdge) {
    // The arm along y hides the foot of the notch's other side up to x = 30 and no farther.
    OrthographicCamera camera;
    camera.direction = Vec3(0.6, -1.0, -0.4).normalized();
    const auto segments = wireSegments(lPrism(), {}, camera);
    EXPECT_GT(segments.size(), 18U) << "an edge must be split into a seen and a hidden part";
    const Vec2 split = camera.project({30, 15, 0});
    const Vec2 end = camera.project({40, 15, 0});
    EXPECT_TRUE(std::any_of(segments.begin(), segments.end(),
                            [&](const WireSegment& s) {
                                return !s.hidden &&
                                       (s.ends[0] - split).norm() + (s.ends[1] - end).norm() < 1e-6;
                            }) ||
                std::any_of(segments.begin(), segments.end(), [&](const WireSegment& s) {
                    return !s.hidden &&
                           (s.ends[1] - split).norm() + (s.ends[0] - end).norm() < 1e-6;
                }));
}

TEST(Wireframe, BadIndicesGiveNothing) {
    PolyhedronSpec spec = box({0, 0, 0}, {1, 1, 1});
    spec.faces.push_back({0, 1, 99});
    EXPECT_TRUE(wireSegments(spec, {}, OrthographicCamera()).empty());
    EXPECT_TRUE(seenFaces(spec, {}, OrthographicCamera()).empty());
}

TEST(CameraMoves, OrbitKeepsThePivotInPlaceAndTheHorizonLevel) {
    OrthographicCamera camera;
    const Vec3 pivot(12, -7, 5);
    for (int i = 0; i < 50; ++i) {
        const Vec2 before = camera.project(pivot);
        camera = orbitCamera(camera, {17.0 * (i % 5 - 2), 13.0 * (i % 7 - 3)}, pivot);
        ASSERT_TRUE(camera.validate());
        EXPECT_NEAR((camera.project(pivot) - before).norm(), 0.0, 1e-6);
        EXPECT_NEAR(camera.right().z(), 0.0, 1e-9);
        EXPECT_GE(camera.trueUp().z(), -1e-9) << "never upside down";
    }
}

TEST(CameraMoves, OrbitStopsLookingStraightDown) {
    const OrthographicCamera down = orbitCamera(OrthographicCamera(), {0, 100000}, Vec3::Zero());
    const OrthographicCamera up = orbitCamera(OrthographicCamera(), {0, -100000}, Vec3::Zero());
    EXPECT_NEAR(std::abs(down.direction.z()), 1.0, 1e-9);
    EXPECT_NEAR(std::abs(up.direction.z()), 1.0, 1e-9);
    EXPECT_LT(down.direction.z() * up.direction.z(), 0.0);
}

TEST(CameraMoves, ZoomHoldsThePlaceAndStaysInRange) {
    OrthographicCamera camera;
    const Vec3 p = camera.unproject({200, 650});
    camera = zoomCamera(camera, {200, 650}, 3.7);
    EXPECT_NEAR((camera.project(p) - Vec2(200, 650)).norm(), 0.0, 1e-6);
    for (int i = 0; i < 200; ++i) camera = zoomCamera(camera, {0, 0}, 100.0);
    EXPECT_TRUE(camera.validate());
    for (int i = 0; i < 200; ++i) camera = zoomCamera(camera, {0, 0}, 0.01);
    EXPECT_TRUE(camera.validate());
    EXPECT_TRUE(zoomCamera(camera, {0, 0}, -1.0) == camera);
}

TEST(CameraMoves, FitShowsEveryPoint) {
    const std::vector<Vec3> points{{500, 20, 3}, {700, -40, 90}, {650, 0, -80}};
    const OrthographicCamera camera = fitCamera(OrthographicCamera(), points);
    for (const Vec3& p : points) {
        const Vec2 px = camera.project(p);
        EXPECT_GT(px.minCoeff(), 0.0);
        EXPECT_LT(px.x(), camera.width);
        EXPECT_LT(px.y(), camera.height);
    }
    EXPECT_TRUE(fitCamera(OrthographicCamera(), {}) == OrthographicCamera());
}

TEST(SketchPlane, MapsThroughTheWorldAndBack) {
    OrthographicCamera sketch;
    OrthographicCamera view = orbitCamera(sketch, {60, 25}, Vec3(3, 4, 5));
    view = zoomCamera(view, {100, 100}, 1.7);
    const QTransform there = sketchToView(sketch, view);
    const auto back = viewToSketch(view, sketch);
    ASSERT_TRUE(back);
    for (const Vec2& px : {Vec2(0, 0), Vec2(640, 400), Vec2(123.5, 777)}) {
        const Vec2 seen = toVec(there.map(toPoint(px)));
        EXPECT_NEAR((seen - view.project(sketch.unproject(px))).norm(), 0.0, 1e-6);
        EXPECT_NEAR((toVec(back->map(toPoint(seen))) - px).norm(), 0.0, 1e-6);
    }
    EXPECT_TRUE(sketchToView(sketch, sketch).isIdentity());
}

TEST(SketchPlane, SeenFromTheSideItCannotBeDrawnOn) {
    const OrthographicCamera front = standardView(OrthographicCamera(), StandardView::Front);
    const OrthographicCamera right = standardView(OrthographicCamera(), StandardView::Right);
    EXPECT_FALSE(viewToSketch(right, front));
    EXPECT_TRUE(viewToSketch(standardView(front, StandardView::Back), front));
}

/// What a layer puts on a white picture.
QImage shownBy(const Layer& layer, const QSize& size) {
    QImage picture(size, QImage::Format_ARGB32_Premultiplied);
    picture.fill(Qt::white);
    QPainter painter(&picture);
    layer.paintOn(painter);
    return picture;
}

TEST(Layer, ShowsWhatWasDrawnLast) {
    const QSize size(60, 40);
    Layer layer;
    layer.resize(size, 1.0);
    QImage expected(size, QImage::Format_ARGB32_Premultiplied);
    expected.fill(Qt::white);
    EXPECT_EQ(shownBy(layer, size), expected);
    const auto draw = [&](const QRect& area, const QColor& colour) {
        QPainter(&layer.image()).fillRect(area, colour);
        QPainter(&expected).fillRect(area, colour);
    };
    draw({5, 7, 3, 2}, Qt::red);
    layer.touch({5, 7, 3, 2});
    EXPECT_EQ(shownBy(layer, size), expected);
    // Beside what was shown, then over it.
    draw({50, 30, 4, 4}, Qt::blue);
    layer.touch({50, 30, 4, 4});
    EXPECT_EQ(shownBy(layer, size), expected);
    draw({6, 7, 1, 1}, Qt::green);
    layer.touch({6, 7, 1, 1});
    EXPECT_EQ(shownBy(layer, size), expected);
    layer.clear();
    expected.fill(Qt::white);
    EXPECT_EQ(shownBy(layer, size), expected);
    // Where it is not said, it is found: the corners too.
    for (const QRect& area : {QRect(20, 10, 1, 1), QRect(0, 39, 1, 1), QRect(59, 0, 1, 1)}) {
        draw(area, Qt::black);
        layer.touchContent();
        EXPECT_EQ(shownBy(layer, size), expected);
    }
}

TEST(Ink, DroppedAreDotsAndStraysButNotWhatIsRead) {
    Interpretation r;
    r.graph.noise.push_back({NoiseKind::Dot, 0, {}});
    r.graph.noise.push_back({NoiseKind::Stray, 1, {}});
    r.graph.noise.push_back({NoiseKind::Overshoot, 2, {}});
    r.graph.noise.push_back({NoiseKind::Stray, 3, {}});
    r.graph.noise.push_back({NoiseKind::ModelEdge, -1, {}});
    EXPECT_EQ(droppedStrokes(r, 4), (std::vector<bool>{true, false, false, false}))
        << "the first lines of a drawing are not stray";
    r.graph.junctions.resize(2);
    GraphEdge edge;
    edge.ends = {0, 1};
    edge.strokes = {3};
    r.graph.edges.push_back(edge);
    EXPECT_EQ(droppedStrokes(r, 4), (std::vector<bool>{true, true, false, false}));
}

TEST(Colours, LinesOnBodiesAreSeenInBothThemes) {
    for (const char* name : {"#000000", "#202228", "#2f5f9e", "#9a2b1f", "#8a6a1f"}) {
        const QColor ink(name);
        EXPECT_EQ(onBody(ink, lightColours()), ink) << name;
        const QColor shown = onBody(ink, darkColours());
        EXPECT_GE(contrastRatio(shown, darkColours().body), 3.0) << name;
        // No lighter than it must be.
        EXPECT_LT(contrastRatio(shown, darkColours().body), 3.6) << name;
    }
    EXPECT_EQ(onBody(Qt::yellow, darkColours()), QColor(Qt::yellow));
}

TEST(Colours, TextMeetsWcagAa) {
    for (const ThemeColours* c : {&lightColours(), &darkColours()}) {
        for (const QColor& back : {c->window, c->surface, c->raised}) {
            EXPECT_GE(contrastRatio(c->text, back), 7.0);
            EXPECT_GE(contrastRatio(c->mutedText, back), 4.5) << back.name().toStdString();
        }
        for (const QColor& back : {c->window, c->surface}) {
            EXPECT_GE(contrastRatio(c->warning, back), 4.5);
            EXPECT_GE(contrastRatio(c->ok, back), 4.5);
        }
        EXPECT_GE(contrastRatio(c->accentText, c->accent), 4.5);
        for (const QColor& mark :
             {c->ink, c->dropped, c->read, c->ghost, c->warning, c->hover, c->hiddenEdge}) {
            EXPECT_GE(contrastRatio(mark, c->background), 3.0) << mark.name().toStdString();
        }
        EXPECT_GE(contrastRatio(c->bodyEdge, c->body), 4.5);
    }
    EXPECT_NEAR(contrastRatio(Qt::black, Qt::white), 21.0, 1e-9);
}

TEST(Colours, InkIsSeenOnFacesInLightAndShade) {
    // Of the body's colour, as the lamps of the scene leave it on faces that are seen.
    constexpr double kShade = 0.56;
    constexpr double kLight = 1.05;
    for (const ThemeColours* c : {&lightColours(), &darkColours()}) {
        for (const double share : {kShade, 0.8, kLight}) {
            const auto lit = [&](float channel) { return std::min(1.0, share * channel); };
            const QColor face = QColor::fromRgbF(static_cast<float>(lit(c->body.redF())),
                                                 static_cast<float>(lit(c->body.greenF())),
                                                 static_cast<float>(lit(c->body.blueF())));
            for (const QColor& ink : {c->ink, c->dropped}) {
                EXPECT_GE(contrastRatio(ink, face), 3.0)
                    << ink.name().toStdString() << " on " << face.name().toStdString();
            }
        }
        EXPECT_GE(contrastRatio(c->dropped, c->background), 3.0);
        EXPECT_GE(contrastRatio(c->dropped, c->surface), 3.0);
    }
}

TEST(Colours, FieldsAreSeenInTheDark) {
    const OutlinedStyle style;
    QStyleOptionButton option;
    option.rect = QRect(2, 2, 16, 16);
    option.state = QStyle::State_Enabled | QStyle::State_Off;
    option.palette.setColor(QPalette::Window, darkColours().window);
    option.palette.setColor(QPalette::Base, darkColours().surface);
    option.palette.setColor(QPalette::WindowText, darkColours().text);
    QImage picture(20, 20, QImage::Format_RGB32);
    picture.fill(darkColours().window);
    QPainter painter(&picture);
    style.drawPrimitive(QStyle::PE_IndicatorCheckBox, &option, &painter, nullptr);
    painter.end();
    for (const QPoint& border : {QPoint(10, 2), QPoint(2, 10), QPoint(10, 17), QPoint(17, 10)}) {
        EXPECT_GE(contrastRatio(picture.pixelColor(border), darkColours().window), 3.0);
    }
}

}  // namespace ew::test
