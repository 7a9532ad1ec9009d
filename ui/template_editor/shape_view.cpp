// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/template_editor/shape_view.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <algorithm>
#include <limits>
#include <numbers>
#include <set>

#include "ui/theme/appearance.h"
#include "ui/viewport/camera_moves.h"
#include "ui/viewport/sketch_plane.h"
#include "ui/viewport/solid_picture.h"

namespace ew {

namespace {

constexpr double kMarginPx = 30.0;  // room for numbers outside the shape
constexpr double kDragPx = 4.0;     // less is a click
constexpr double kVertexReachPx = 11.0;
constexpr double kEdgeReachPx = 8.0;
constexpr double kKeyTurnPx = 12.0;
constexpr double kNumberOffPx = 13.0;

double distanceToSegment(const QPointF& p, const QPointF& a, const QPointF& b) {
    const QPointF d = b - a;
    const double length = QPointF::dotProduct(d, d);
    const double t =
        length > 0.0 ? std::clamp(QPointF::dotProduct(p - a, d) / length, 0.0, 1.0) : 0.0;
    const QPointF off = p - (a + t * d);
    return std::hypot(off.x(), off.y());
}

}  // namespace

ShapeView::ShapeView(Appearance& appearance, QWidget* parent)
    : QWidget(parent), appearance_(appearance) {
    setFocusPolicy(Qt::StrongFocus);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    setAccessibleName(tr("Shape of the template"));
    setToolTip(tr("Drag to turn it; click a corner or an edge"));
    // A little off the isometric direction, where corners of a cube would fall on each other.
    camera_.direction = Vec3(-0.55, 1.0, -0.6).normalized();
    connect(&appearance, &Appearance::changed, this, qOverload<>(&QWidget::update));
}

void ShapeView::setShape(const PolyhedronSpec& shape) {
    const bool otherFaces = shape.faces != shape_.faces;
    shape_ = shape;
    std::set<TemplateEdge> edges;
    for (const std::vector<int>& loop : shape.faces) {
        for (std::size_t i = 0; i < loop.size(); ++i) {
            const auto [a, b] = std::minmax(loop[i], loop[(i + 1) % loop.size()]);
            edges.insert({a, b});
        }
    }
    edges_.assign(edges.begin(), edges.end());
    fit();
    if (otherFaces) {
        camera_.direction = clearDirection();
        camera_.up = Vec3(0, 0, 1);
        lit_.clear();
        pickNothing();
    }
    update();
}

Vec3 ShapeView::clearDirection() const {
    constexpr int kTurns = 36;
    const double tilt = std::sin(30.0 * std::numbers::pi / 180.0);
    Vec3 best = camera_.direction;
    double widest = -1.0;
    OrthographicCamera camera = camera_;
    camera.up = Vec3(0, 0, 1);
    for (int i = 0; i < kTurns; ++i) {
        const double turn = 2.0 * std::numbers::pi * (i + 0.35) / kTurns;
        camera.direction = Vec3(std::cos(turn), std::sin(turn), -tilt).normalized();
        double nearest = std::numeric_limits<double>::infinity();
        for (std::size_t a = 0; a < shape_.vertices.size(); ++a) {
            for (std::size_t b = 0; b < a; ++b) {
                const Vec2 off =
                    camera.project(shape_.vertices[a]) - camera.project(shape_.vertices[b]);
                nearest = std::min(nearest, off.squaredNorm());
            }
        }
        if (nearest <= widest) continue;
        widest = nearest;
        best = camera.direction;
    }
    return best;
}

void ShapeView::setLit(const std::vector<TemplateEdge>& edges) {
    lit_ = edges;
    update();
}

void ShapeView::lookAlong(const Vec3& direction) {
    camera_.direction = direction.normalized();
    const bool steep = std::abs(camera_.direction.z()) > 0.999;
    camera_.up = steep ? Vec3(0, 1, 0) : Vec3(0, 0, 1);
    update();
}

void ShapeView::pickNothing() {
    if (vertex_ < 0 && !edge_) return;
    vertex_ = -1;
    edge_.reset();
    update();
    emit picked();
}

void ShapeView::fit() {
    camera_.width = width();
    camera_.height = height();
    Eigen::AlignedBox3d box;
    for (const Vec3& v : shape_.vertices) box.extend(v);
    if (box.isEmpty()) return;
    camera_.center = box.center();
    double radius = 0.0;
    for (const Vec3& v : shape_.vertices) radius = std::max(radius, (v - box.center()).norm());
    // All of it stays in sight while it is turned, and its size does not change.
    const double room = std::max(1.0, std::min(width(), height()) - 2.0 * kMarginPx);
    if (radius > 0.0) camera_.worldPerPixel = 2.0 * radius / room;
}

void ShapeView::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    fit();
}

QPointF ShapeView::place(int vertex) const {
    return toPoint(camera_.project(shape_.vertices[static_cast<std::size_t>(vertex)]));
}

void ShapeView::drawEdge(QPainter& painter, const TemplateEdge& edge, const QPen& pen) const {
    const int count = static_cast<int>(shape_.vertices.size());
    if (std::max(edge[0], edge[1]) >= count) return;
    painter.setPen(pen);
    painter.drawLine(place(edge[0]), place(edge[1]));
}

/// Numbers stand away from the middle, where they cover no edge of their corner.
void ShapeView::drawVertices(QPainter& painter) const {
    const ThemeColours& c = appearance_.colours();
    const QPointF middle(width() / 2.0, height() / 2.0);
    for (int v = 0; v < static_cast<int>(shape_.vertices.size()); ++v) {
        const QPointF p = place(v);
        const bool chosen = v == vertex_;
        painter.setPen(QPen(c.surface, 1.5));
        painter.setBrush(chosen ? c.accent : c.bodyEdge);
        const double size = chosen ? 5.5 : 3.5;
        painter.drawEllipse(p, size, size);
        QPointF away = p - middle;
        const double length = std::hypot(away.x(), away.y());
        away = length > 1.0 ? away / length : QPointF(0.0, -1.0);
        const QPointF at = p + kNumberOffPx * away;
        painter.setPen(chosen ? c.accent : c.text);
        painter.drawText(QRectF(at.x() - 14, at.y() - 9, 28, 18), Qt::AlignCenter,
                         QString::number(v));
    }
}

void ShapeView::paintEvent(QPaintEvent*) {
    const ThemeColours& c = appearance_.colours();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(hasFocus() ? c.accent : c.border, 1.0));
    painter.setBrush(c.surface);
    painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), metrics::kRadius,
                            metrics::kRadius);
    painter.setBrush(Qt::NoBrush);
    if (shape_.vertices.empty()) return;
    painter.drawImage(QPointF(0, 0), solidView(shape_, {}, camera_, devicePixelRatioF(), c));
    for (const TemplateEdge& edge : lit_) {
        drawEdge(painter, edge, QPen(c.accent, 4.0, Qt::SolidLine, Qt::RoundCap));
    }
    if (edge_) drawEdge(painter, *edge_, QPen(c.accent, 2.5, Qt::DashLine, Qt::RoundCap));
    drawVertices(painter);
}

void ShapeView::mousePressEvent(QMouseEvent* event) {
    pressedAt_ = lastAt_ = event->position();
    turning_ = false;
    setFocus(Qt::MouseFocusReason);
}

void ShapeView::mouseMoveEvent(QMouseEvent* event) {
    if (event->buttons() == Qt::NoButton) return;
    const QPointF way = event->position() - pressedAt_;
    if (!turning_ && std::hypot(way.x(), way.y()) < kDragPx) return;
    turning_ = true;
    turn(event->position() - lastAt_);
    lastAt_ = event->position();
}

void ShapeView::mouseReleaseEvent(QMouseEvent* event) {
    if (!turning_ && event->button() == Qt::LeftButton) pickAt(event->position());
    turning_ = false;
}

void ShapeView::keyPressEvent(QKeyEvent* event) {
    QPointF by;
    if (event->key() == Qt::Key_Left) by = {-kKeyTurnPx, 0.0};
    if (event->key() == Qt::Key_Right) by = {kKeyTurnPx, 0.0};
    if (event->key() == Qt::Key_Up) by = {0.0, -kKeyTurnPx};
    if (event->key() == Qt::Key_Down) by = {0.0, kKeyTurnPx};
    if (by.isNull()) {
        QWidget::keyPressEvent(event);
    } else {
        turn(by);
    }
}

void ShapeView::turn(const QPointF& by) {
    camera_.up = Vec3(0, 0, 1);
    camera_ = orbitCamera(camera_, toVec(by), camera_.center);
    fit();
    update();
}

/// The nearest within reach; of two at one place the one that is nearer to the eye.
void ShapeView::pickAt(const QPointF& at) {
    const auto depth = [&](int v) {
        return camera_.depthPx(shape_.vertices[static_cast<std::size_t>(v)]) * 1e-3;
    };
    vertex_ = -1;
    edge_.reset();
    double best = std::numeric_limits<double>::infinity();
    for (int v = 0; v < static_cast<int>(shape_.vertices.size()); ++v) {
        const QPointF off = place(v) - at;
        const double distance = std::hypot(off.x(), off.y());
        if (distance > kVertexReachPx || distance + depth(v) >= best) continue;
        best = distance + depth(v);
        vertex_ = v;
    }
    best = std::numeric_limits<double>::infinity();
    for (const TemplateEdge& e : edges_) {
        const double distance = distanceToSegment(at, place(e[0]), place(e[1]));
        const double rank = distance + (depth(e[0]) + depth(e[1])) / 2;
        if (vertex_ >= 0 || distance > kEdgeReachPx || rank >= best) continue;
        best = rank;
        edge_ = e;
    }
    update();
    emit picked();
}

}  // namespace ew
