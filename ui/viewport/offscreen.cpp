// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewport/offscreen.h"

#include <QGuiApplication>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLFramebufferObject>
#include <QPainter>
#include <QSaveFile>

#include "ui/viewport/camera_moves.h"
#include "ui/viewport/frame_renderer.h"
#include "ui/viewport/ink_layer.h"
#include "ui/viewport/reading_overlay.h"
#include "ui/viewport/scene.h"
#include "ui/viewport/sketch_plane.h"

namespace ew {

namespace {

constexpr int kSmallest = 16;
constexpr int kLargest = 16384;

Result<QImage> renderScene(const Document& document, const OrthographicCamera& camera, QSize size) {
    QOffscreenSurface surface;
    surface.create();
    QOpenGLContext context;
    if (!context.create() || !context.makeCurrent(&surface)) {
        return fail(Errc::NotAvailable, "There is no OpenGL here, so no picture can be made.");
    }
    Scene scene;
    scene.setBodies(document.state().bodies);
    scene.setCamera(camera);
    FrameRenderer renderer(
        scene,
        [&] {
            if (QOpenGLContext::currentContext() != &context) context.makeCurrent(&surface);
        },
        [&] { return QOpenGLContext::currentContext() == &context; }, [] {});
    renderer.initialise();
    renderer.resize(size, 1.0);
    QImage image;
    {
        QOpenGLFramebufferObject target(size, QOpenGLFramebufferObject::CombinedDepthStencil);
        if (target.isValid()) {
            renderer.render(target.handle());
            image = target.toImage();
        }
    }
    renderer.finish();
    context.doneCurrent();
    if (image.isNull()) {
        return fail(Errc::NotAvailable, "OpenGL could not make a picture of this size.");
    }
    return image.convertToFormat(QImage::Format_RGB32);
}

void paintInk(QPainter& painter, const Document& document, const OrthographicCamera& camera,
              QSize size) {
    const ThemeColours& colours = lightColours();
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

Result<void> renderScreenshot(const Document& document, const QString& path, QSize size) {
    if (size.width() < kSmallest || size.height() < kSmallest || size.width() > kLargest ||
        size.height() > kLargest) {
        return fail(Errc::BadValue, "A picture must be 16 to 16384 pixels wide and high.");
    }
    if (qobject_cast<QGuiApplication*>(QCoreApplication::instance()) == nullptr) {
        return fail(Errc::NotAvailable, "A picture needs a display.");
    }
    const OrthographicCamera camera = scaleCamera(document.camera(), size.width(), size.height());
    auto image = renderScene(document, camera, size);
    if (!image) return fail(image.error());
    QPainter painter(&*image);
    paintInk(painter, document, camera, size);
    painter.end();
    QSaveFile file(path);
    if (!file.open(QIODevice::WriteOnly) || !image->save(&file, "PNG") || !file.commit()) {
        return fail(Errc::CannotWrite, "The picture could not be written to " + path.toStdString() +
                                           ": " + file.errorString().toStdString());
    }
    return {};
}

}  // namespace ew
