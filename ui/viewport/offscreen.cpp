// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewport/offscreen.h"

#include <QGuiApplication>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLFramebufferObject>
#include <QPainter>
#include <algorithm>

#include "ui/viewport/camera_moves.h"
#include "ui/viewport/frame_renderer.h"
#include "ui/viewport/ink_layer.h"
#include "ui/viewport/picture_file.h"
#include "ui/viewport/reading_overlay.h"
#include "ui/viewport/scene.h"
#include "ui/viewport/sketch_plane.h"

namespace ew {

namespace {

constexpr int kSmallest = 16;
constexpr int kLargest = 16384;
constexpr int kTilePx = 2048;
constexpr int kOcclusionSamples = 128;
constexpr int kOcclusionLargest = 4096;  // drawn in one piece

const ThemeColours& coloursOf(const PictureLook& look) {
    return look.dark ? darkColours() : lightColours();
}

/// How many px are drawn for one of a picture with occlusion, each way: the more the smoother.
int finerBy(int mostPx) {
    if (3 * mostPx <= kOcclusionLargest / 2) return 3;
    return 2 * mostPx <= kOcclusionLargest ? 2 : 1;
}

/// How the px of a picture relate to those of the viewport that it shows.
struct Weight {
    double pxPerViewPx = 1.0;  ///< lines, dashes and grid grow with it, so that they look the same
    int finer = 1;             ///< px that are drawn for one of the picture, each way
};

/// Where the picture is larger than the viewport, all that is measured in px grows with it; in a
/// smaller one it would be too thin to be seen.
double weightOf(const OrthographicCamera& viewport, const QSize& size) {
    const OrthographicCamera scaled = scaleCamera(viewport, size.width(), size.height());
    return std::max(1.0, viewport.worldPerPixel / scaled.worldPerPixel);
}

/// Draws a part of the picture.
/// \return false where OpenGL cannot.
bool drawTile(FrameRenderer& renderer, const QRect& tile, const Weight& weight,
              const PictureLook& look, QImage& image) {
    const QSize size = tile.size() * weight.finer;
    renderer.resize(size, weight.finer * weight.pxPerViewPx);
    QOpenGLFramebufferObject target(size, QOpenGLFramebufferObject::CombinedDepthStencil);
    if (!target.isValid()) return false;
    renderer.render(target.handle(), look.transparent);
    QImage drawn = target.toImage();
    if (drawn.isNull()) return false;
    if (weight.finer > 1) {
        drawn = drawn.scaled(tile.size(), Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
    }
    QPainter painter(&image);
    painter.setCompositionMode(QPainter::CompositionMode_Source);
    painter.drawImage(tile.topLeft(), drawn);
    return true;
}

/// \param camera  of the viewport as the picture shows it; a px of it is `pxPerViewPx` of the
/// picture.
Result<QImage> renderScene(const Document& document, const OrthographicCamera& camera, QSize size,
                           double pxPerViewPx, const PictureLook& look) {
    QOffscreenSurface surface;
    surface.create();
    QOpenGLContext context;
    if (!context.create() || !context.makeCurrent(&surface)) {
        return fail(Errc::NotAvailable, "There is no OpenGL here, so no picture can be made.");
    }
    Scene scene;
    scene.setColours(coloursOf(look));
    scene.setTransparent(look.transparent);
    scene.setCageVisible(look.cage);
    scene.setHiddenEdgesVisible(look.hiddenEdges);
    scene.setOcclusion(look.occlusion ? kOcclusionSamples : 0);
    scene.setShape(document.state().bodies, document.shape(), document.state().mapped);
    scene.setCamera(camera);
    FrameRenderer renderer(
        scene,
        [&] {
            if (QOpenGLContext::currentContext() != &context) context.makeCurrent(&surface);
        },
        [&] { return QOpenGLContext::currentContext() == &context; }, [] {});
    renderer.initialise();
    QImage image(size,
                 look.transparent ? QImage::Format_ARGB32_Premultiplied : QImage::Format_RGB32);
    bool drawn = !image.isNull();
    // Piece by piece: a large picture with several samples a pixel would not fit the card.
    const QRect all(QPoint(0, 0), size);
    // Occlusion has no samples within a px, and comes from everything around.
    const int most = std::max(size.width(), size.height());
    const int step = look.occlusion ? most : kTilePx;
    const Weight weight{pxPerViewPx, look.occlusion ? finerBy(most) : 1};
    for (int y = 0; drawn && y < size.height(); y += step) {
        for (int x = 0; drawn && x < size.width(); x += step) {
            const QRect tile = all & QRect(x, y, step, step);
            scene.setTile(
                QRectF(QPointF(tile.topLeft()) / pxPerViewPx, QSizeF(tile.size()) / pxPerViewPx));
            drawn = drawTile(renderer, tile, weight, look, image);
        }
    }
    renderer.finish();
    context.doneCurrent();
    if (!drawn) {
        return fail(Errc::NotAvailable, "OpenGL could not make a picture of this size.");
    }
    return image;
}

void paintInk(QPainter& painter, const Document& document, const OrthographicCamera& camera,
              const ThemeColours& colours, const QSizeF& size) {
    const auto& strokes = document.pendingStrokes();
    if (strokes.empty()) return;
    const Interpretation& reading = document.interpretation();
    const std::vector<bool> dropped = droppedStrokes(reading, strokes.size());
    painter.setRenderHint(QPainter::Antialiasing);
    for (std::size_t i = 0; i < strokes.size(); ++i) {
        paintStroke(painter, strokes[i].stroke, sketchToView(strokes[i].camera, camera),
                    {dropped[i] ? colours.dropped : colours.ink, dropped[i]});
    }
    ReadingOverlay overlay{&reading,
                           strokes.back().camera,
                           camera,
                           document.thresholds(),
                           reading.accepted.value_or(-1),
                           true};
    paintReading(painter, overlay, colours, QRectF(QPointF(0, 0), size));
}

}  // namespace

Result<void> renderScreenshot(const Document& document, const QString& path, QSize size,
                              const PictureLook& look) {
    if (size.width() < kSmallest || size.height() < kSmallest || size.width() > kLargest ||
        size.height() > kLargest) {
        return fail(Errc::BadValue, "A picture must be 16 to 16384 pixels wide and high.");
    }
    if (auto ok = checkPictureName(path); !ok) return ok;
    if (look.occlusion && std::max(size.width(), size.height()) > kOcclusionLargest) {
        return fail(Errc::BadValue,
                    "A picture with occlusion must be at most 4096 pixels wide and high.");
    }
    if (qobject_cast<QGuiApplication*>(QCoreApplication::instance()) == nullptr) {
        return fail(Errc::NotAvailable, "A picture needs a display.");
    }
    const double weight = weightOf(document.camera(), size);
    const QSizeF seen = QSizeF(size) / weight;
    const OrthographicCamera camera = scaleCamera(document.camera(), seen.width(), seen.height());
    auto image = renderScene(document, camera, size, weight, look);
    if (!image) return fail(image.error());
    QPainter painter(&*image);
    painter.scale(weight, weight);
    paintInk(painter, document, camera, coloursOf(look), seen);
    painter.end();
    return writePicture(*image, path);
}

}  // namespace ew
