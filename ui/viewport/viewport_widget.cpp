// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewport/viewport_widget.h"

#include <QElapsedTimer>
#include <QOpenGLContext>
#include <QOpenGLExtraFunctions>
#include <QOpenGLFramebufferObject>
#include <QOpenGLPaintDevice>
#include <QPainter>
#include <QResizeEvent>
#include <cmath>

#include "ui/live_reading.h"
#include "ui/theme/appearance.h"
#include "ui/viewport/camera_moves.h"
#include "ui/viewport/frame_renderer.h"
#include "ui/viewport/ink_layer.h"
#include "ui/viewport/mirror_overlay.h"
#include "ui/viewport/reading_overlay.h"
#include "ui/viewport/scene.h"
#include "ui/viewport/sketch_plane.h"

namespace ew {

namespace {

/// Drawn as a picture: lines of the OpenGL painter are not antialiased without multisampling.
void paintRing(QPainter& painter, const QPointF& centre, double radius, const QColor& colour,
               double devicePixelRatio) {
    const int half = static_cast<int>(std::ceil(radius)) + 2;
    QImage ring(QSize(2 * half, 2 * half) * devicePixelRatio, QImage::Format_ARGB32_Premultiplied);
    ring.setDevicePixelRatio(devicePixelRatio);
    ring.fill(Qt::transparent);
    QPainter onRing(&ring);
    onRing.setRenderHint(QPainter::Antialiasing);
    onRing.setPen(QPen(colour, 1.2));
    onRing.drawEllipse(QPointF(half, half), radius, radius);
    onRing.end();
    painter.drawImage(QPointF(centre.x() - half, centre.y() - half), ring);
}

}  // namespace

struct ViewportWidget::Private {
    Document& document;
    LiveReading& reading;
    Appearance& appearance;
    Scene scene;
    std::unique_ptr<FrameRenderer> renderer;
    /// Scene, ink and reading as they were last: what moves with the pen is drawn over it.
    std::unique_ptr<QOpenGLFramebufferObject> still;
    QOpenGLContext* context = nullptr;
    QSurface* surface = nullptr;
    InkLayer ink;
    WetInkLayer wet;
    Layer overlay;
    const Stroke* wetStroke = nullptr;
    std::optional<Vec2> hover;
    bool hoverErases = false;
    bool grid = true;
    bool hidden = false;
    bool occlusion = false;
    bool readingShown = true;
    bool overlayStale = true;
    std::optional<Ghost> ghost;  ///< strokes to trace
    bool shapeStale = true;
    bool cage = false;
    std::vector<EdgeRef> chosen;
    std::optional<ShapePreview> preview;
    bool moving = false;
    bool shownOnce = false;
    double frameMs = 0.0;

    Private(Document& doc, LiveReading& live, Appearance& look)
        : document(doc), reading(live), appearance(look) {}
};

ViewportWidget::ViewportWidget(Document& document, LiveReading& reading, Appearance& appearance,
                               QWidget* parent)
    : QOpenGLWidget(parent), d_(std::make_unique<Private>(document, reading, appearance)) {
    setObjectName(QStringLiteral("viewport"));
    setAccessibleName(tr("Drawing surface"));
    setAccessibleDescription(
        tr("Draw with the pen or the left mouse button. The middle or right button orbits."));
    setFocusPolicy(Qt::StrongFocus);
    setMinimumSize(320, 240);
    setCursor(Qt::CrossCursor);
    d_->renderer = std::make_unique<FrameRenderer>(
        d_->scene,
        [this] {
            // Not QOpenGLWidget::makeCurrent: it would bind the widget's framebuffer behind the
            // back of VTK's state cache.
            if (QOpenGLContext::currentContext() != d_->context) {
                d_->context->makeCurrent(d_->surface);
            }
        },
        [this] { return QOpenGLContext::currentContext() == d_->context; }, [this] { update(); });
    connect(&document, &Document::changed, this, &ViewportWidget::onDocumentChanged);
    connect(&reading, &LiveReading::changed, this, [this] {
        d_->overlayStale = true;
        update();
    });
    connect(&appearance, &Appearance::changed, this, [this] {
        d_->overlayStale = true;
        d_->scene.setColours(d_->appearance.colours());
        update();
    });
    d_->scene.setColours(appearance.colours());
}

ViewportWidget::~ViewportWidget() { releaseGL(); }

void ViewportWidget::releaseGL() {
    if (d_->context == nullptr) return;
    disconnect(d_->context, nullptr, this, nullptr);
    makeCurrent();
    d_->still.reset();
    d_->renderer->finish();
    doneCurrent();
    d_->context = nullptr;
    d_->surface = nullptr;
}

void ViewportWidget::setWetStroke(const Stroke* stroke) {
    d_->wetStroke = stroke;
    update();
}

std::optional<Vec2> ViewportWidget::hover() const { return d_->hover; }

void ViewportWidget::setHover(std::optional<Vec2> position, bool eraser) {
    if (!position && !d_->hover) return;
    d_->hover = position;
    d_->hoverErases = eraser;
    update();
}

bool ViewportWidget::gridVisible() const { return d_->grid; }
bool ViewportWidget::hiddenEdgesVisible() const { return d_->hidden; }
bool ViewportWidget::readingVisible() const { return d_->readingShown; }
double ViewportWidget::lastFrameMs() const { return d_->frameMs; }

void ViewportWidget::setGridVisible(bool on) {
    d_->grid = on;
    d_->scene.setGridVisible(on);
    update();
}

void ViewportWidget::setHiddenEdgesVisible(bool on) {
    d_->hidden = on;
    d_->scene.setHiddenEdgesVisible(on);
    update();
}

bool ViewportWidget::occlusionVisible() const { return d_->occlusion; }

void ViewportWidget::setOcclusionVisible(bool on) {
    constexpr int kSamples = 32;  // a frame is to be quick
    d_->occlusion = on;
    d_->scene.setOcclusion(on ? kSamples : 0);
    update();
}

bool ViewportWidget::cageVisible() const { return d_->cage; }

void ViewportWidget::setCageVisible(bool on) {
    d_->cage = on;
    d_->scene.setCageVisible(on);
    update();
}

void ViewportWidget::setPreview(std::optional<ShapePreview> preview) {
    if (!preview && !d_->preview) return;
    d_->preview = std::move(preview);
    d_->shapeStale = true;
    update();
}

std::shared_ptr<const DerivedShape> ViewportWidget::shownShape() const {
    return d_->preview ? d_->preview->shape : d_->document.shape();
}

void ViewportWidget::setMoving(bool on) {
    if (on == d_->moving) return;
    d_->moving = on;
    update();
}

void ViewportWidget::setChosenEdges(const std::vector<EdgeRef>& edges) {
    d_->chosen = edges;
    update();
}

void ViewportWidget::setGhost(std::optional<Ghost> ghost) {
    d_->ghost = std::move(ghost);
    d_->overlayStale = true;
    update();
}

void ViewportWidget::showShape() {
    Private& d = *d_;
    d.shapeStale = false;
    const DocumentState& state = d.document.state();
    const bool others = d.preview && !d.preview->bodies.empty();
    d.scene.setShape(others ? d.preview->bodies : state.bodies, shownShape(), state.mapped);
}

void ViewportWidget::setReadingVisible(bool on) {
    d_->readingShown = on;
    d_->overlayStale = true;
    update();
}

void ViewportWidget::onDocumentChanged(DocumentChange what) {
    if (what == DocumentChange::Bodies || what == DocumentChange::Shape) {
        d_->shapeStale = true;
        d_->preview.reset();
    }
    // A document or script that was made in another window brings that window's size. Later, when
    // whoever moves the camera is done with it.
    if (what == DocumentChange::Camera || what == DocumentChange::File) {
        QMetaObject::invokeMethod(this, &ViewportWidget::claimCamera, Qt::QueuedConnection);
    }
    if (what == DocumentChange::History || what == DocumentChange::File) return;
    d_->overlayStale = true;
    update();
}

void ViewportWidget::claimCamera() {
    const OrthographicCamera& camera = d_->document.camera();
    if (camera.width == width() && camera.height == height()) return;
    const bool fits = camera.width <= width() && camera.height <= height();
    (void)d_->document.setCamera(fits ? resizeCamera(camera, width(), height())
                                      : scaleCamera(camera, width(), height()));
}

void ViewportWidget::initializeGL() {
    d_->context = context();
    d_->surface = context()->surface();
    connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, &ViewportWidget::releaseGL,
            Qt::DirectConnection);
    d_->renderer->initialise();
}

void ViewportWidget::resizeGL(int width, int height) {
    const double dpr = devicePixelRatioF();
    const QSize device(qRound(width * dpr), qRound(height * dpr));
    d_->renderer->resize(device, dpr);
    d_->ink.resize(device, dpr);
    d_->wet.resize(device, dpr);
    d_->overlay.resize(device, dpr);
    d_->overlayStale = true;
}

void ViewportWidget::resizeEvent(QResizeEvent* event) {
    QOpenGLWidget::resizeEvent(event);
    // What the document calls the viewport is this widget.
    const OrthographicCamera camera =
        resizeCamera(d_->document.camera(), event->size().width(), event->size().height());
    if (!(camera == d_->document.camera())) (void)d_->document.setCamera(camera);
}

void ViewportWidget::paintGL() {
    QElapsedTimer clock;
    clock.start();
    Private& d = *d_;
    if (d.shapeStale) showShape();
    d.scene.setChosen(d.chosen);
    d.scene.setCamera(resizeCamera(d.document.camera(), width(), height()));
    d.renderer->setRough(d.moving || (d.preview && d.preview->hurried));
    paintStill();
    copyStill();
    QPainter painter(this);
    d.wet.update(d.wetStroke, d.appearance.colours());
    d.wet.paintOn(painter);
    if (d.hover && d.wetStroke == nullptr) {
        const ThemeColours& colours = d.appearance.colours();
        const OrthographicCamera view = resizeCamera(d.document.camera(), width(), height());
        const double r = d.document.thresholds().distancePx *
                         meanScale(sketchToView(d.reading.sketchCamera(), view));
        paintRing(painter, toPoint(*d.hover), r, d.hoverErases ? colours.warning : colours.hover,
                  devicePixelRatioF());
    }
    painter.end();
    d.frameMs = static_cast<double>(clock.nsecsElapsed()) / 1e6;
    if (!d.shownOnce) {
        d.shownOnce = true;
        QMetaObject::invokeMethod(this, &ViewportWidget::firstFrame, Qt::QueuedConnection);
    }
}

void ViewportWidget::paintStill() {
    Private& d = *d_;
    const double dpr = devicePixelRatioF();
    const QSize device(qRound(width() * dpr), qRound(height() * dpr));
    bool stale = d.renderer->stale();
    if (!d.still || d.still->size() != device) {
        d.still = std::make_unique<QOpenGLFramebufferObject>(
            device, QOpenGLFramebufferObject::CombinedDepthStencil);
        stale = true;
    }
    const ThemeColours& colours = d.appearance.colours();
    const OrthographicCamera view = resizeCamera(d.document.camera(), width(), height());
    const auto& strokes = d.document.pendingStrokes();
    const auto dropped = droppedStrokes(d.reading.reading(), strokes.size());
    stale = d.ink.update(strokes, dropped, view, colours) || stale;
    stale = updateOverlay(view) || stale;
    if (!stale) return;
    d.renderer->render(d.still->handle());
    QOpenGLPaintDevice canvas(device);
    canvas.setDevicePixelRatio(dpr);
    QPainter painter(&canvas);
    d.ink.paintOn(painter);
    d.overlay.paintOn(painter);
}

void ViewportWidget::copyStill() {
    const QSize size = d_->still->size();
    QOpenGLExtraFunctions* gl = d_->context->extraFunctions();
    gl->glBindFramebuffer(GL_READ_FRAMEBUFFER, d_->still->handle());
    gl->glBindFramebuffer(GL_DRAW_FRAMEBUFFER, defaultFramebufferObject());
    gl->glDisable(GL_SCISSOR_TEST);
    gl->glBlitFramebuffer(0, 0, size.width(), size.height(), 0, 0, size.width(), size.height(),
                          GL_COLOR_BUFFER_BIT, GL_NEAREST);
    gl->glBindFramebuffer(GL_FRAMEBUFFER, defaultFramebufferObject());
}

bool ViewportWidget::updateOverlay(const OrthographicCamera& view) {
    Private& d = *d_;
    const bool anything = !d.document.pendingStrokes().empty() || d.wetStroke != nullptr;
    if (!d.overlayStale) return false;
    d.overlayStale = false;
    d.overlay.clear();
    const auto& mirror = d.document.state().mirror;
    const bool read = d.readingShown && anything;
    if (read || mirror || d.ghost) {
        QPainter painter(&d.overlay.image());
        painter.setRenderHint(QPainter::Antialiasing);
        painter.setFont(font());
        const ThemeColours& colours = d.appearance.colours();
        if (d.ghost) paintGhost(painter, *d.ghost, view, colours);
        if (mirror) paintMirror(painter, *mirror, d.document.state().bodies, view, colours);
        ReadingOverlay shown{
            &d.reading.reading(),    d.reading.sketchCamera(), view,
            d.document.thresholds(), d.reading.current(),      d.reading.settled()};
        if (read) paintReading(painter, shown, colours, rect());
        painter.end();
        d.overlay.touchContent();
    }
    return true;
}

}  // namespace ew
