// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewport/ink_layer.h"

#include <QPainter>
#include <QPainterPath>
#include <algorithm>
#include <cmath>
#include <iterator>

#include "ui/viewport/sketch_plane.h"

namespace ew {

namespace {

constexpr double kThinnestPx = 1.1;
constexpr double kThickestPx = 3.3;
constexpr int kWeights = 12;      // steps of line weight; neighbours cannot be told apart
constexpr double kSkipPx = 0.35;  // samples nearer than this add nothing to the picture
constexpr double kDroppedWidthPx = 1.3;

int weightOf(double pressure) {
    return static_cast<int>(std::lround(std::clamp(pressure, 0.0, 1.0) * kWeights));
}

double widthOf(int weight) {
    return kThinnestPx + (kThickestPx - kThinnestPx) * weight / static_cast<double>(kWeights);
}

QPen penFor(const InkStyle& style, double width) {
    QPen pen(style.colour, width, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin);
    if (style.dropped) {
        pen.setWidthF(kDroppedWidthPx);
        pen.setDashPattern({4.0, 4.0});
        pen.setCapStyle(Qt::FlatCap);
    }
    return pen;
}

QRectF boundsOf(const Stroke& stroke, const QTransform& map, std::size_t first) {
    QRectF box;
    for (std::size_t i = first; i < stroke.samples.size(); ++i) {
        const QPointF p = map.map(toPoint(stroke.samples[i].position));
        const QRectF dot(p.x() - kThickestPx, p.y() - kThickestPx, 2 * kThickestPx,
                         2 * kThickestPx);
        box = box.isNull() ? dot : box.united(dot);
    }
    return box;
}

}  // namespace

void paintStroke(QPainter& painter, const Stroke& stroke, const QTransform& map,
                 const InkStyle& style, std::size_t firstSample) {
    if (firstSample >= stroke.samples.size()) return;
    QPolygonF run;
    run.append(map.map(toPoint(stroke.samples[firstSample].position)));
    int weight = weightOf(stroke.samples[firstSample].pressure);
    const auto flush = [&] {
        painter.setPen(penFor(style, widthOf(weight)));
        if (run.size() > 1) {
            painter.drawPolyline(run);
        } else if (firstSample == 0 && stroke.samples.size() == 1) {
            painter.drawPoint(run.first());
        }
    };
    for (std::size_t i = firstSample + 1; i < stroke.samples.size(); ++i) {
        const QPointF p = map.map(toPoint(stroke.samples[i].position));
        const QPointF step = p - run.last();
        const bool last = i + 1 == stroke.samples.size();
        if (!last && std::abs(step.x()) + std::abs(step.y()) < kSkipPx) continue;
        const int next = style.dropped ? weight : weightOf(stroke.samples[i].pressure);
        run.append(p);
        if (next != weight) {
            flush();
            run = QPolygonF({p});
            weight = next;
        }
    }
    flush();
}

std::vector<bool> droppedStrokes(const Interpretation& reading, std::size_t strokeCount) {
    std::vector<bool> dropped(strokeCount, false);
    const auto set = [&](int stroke, bool value) {
        if (stroke >= 0 && static_cast<std::size_t>(stroke) < strokeCount) {
            dropped[static_cast<std::size_t>(stroke)] = value;
        }
    };
    for (const NoiseItem& item : reading.graph.noise) {
        switch (item.kind) {
            case NoiseKind::Dot:
            case NoiseKind::Scribble:
            case NoiseKind::Curve:
                set(item.stroke, true);
                break;
            case NoiseKind::Stray:
                set(item.stroke, !reading.graph.empty());
                break;
            case NoiseKind::Overshoot:
            case NoiseKind::ModelEdge:
                break;
        }
    }
    for (const GraphEdge& edge : reading.graph.edges) {
        for (const int stroke : edge.strokes) set(stroke, false);
    }
    return dropped;
}

void Layer::resize(const QSize& devicePixels, double devicePixelRatio) {
    if (image_.size() == devicePixels && image_.devicePixelRatio() == devicePixelRatio) return;
    image_ = QImage(devicePixels.expandedTo({1, 1}), QImage::Format_ARGB32_Premultiplied);
    image_.setDevicePixelRatio(devicePixelRatio);
    image_.fill(Qt::transparent);
    used_ = {};
    part_ = {};
}

void Layer::clear() {
    if (used_.isEmpty()) return;
    image_.fill(Qt::transparent);
    used_ = {};
    part_ = {};
}

void Layer::touch(const QRectF& area) {
    const double s = image_.devicePixelRatio();
    const QRectF device(area.x() * s, area.y() * s, area.width() * s, area.height() * s);
    used_ = used_.united(device.toAlignedRect()).intersected(image_.rect());
    part_ = {};
}

void Layer::touchContent() {
    const QImage& image = image_;
    const auto isInk = [](QRgb pixel) { return pixel != 0; };
    int left = image.width();
    int right = -1;
    int top = -1;
    int bottom = -1;
    for (int y = 0; y < image.height(); ++y) {
        const auto* begin = reinterpret_cast<const QRgb*>(image.constScanLine(y));
        const auto* end = begin + image.width();
        const auto* first = std::find_if(begin, end, isInk);
        if (first == end) continue;
        const auto* last =
            std::find_if(std::make_reverse_iterator(end), std::make_reverse_iterator(first), isInk)
                .base();
        left = std::min(left, static_cast<int>(first - begin));
        right = std::max(right, static_cast<int>(last - begin) - 1);
        if (top < 0) top = y;
        bottom = y;
    }
    used_ = bottom < 0 ? QRect() : QRect(QPoint(left, top), QPoint(right, bottom));
    part_ = {};
}

void Layer::paintOn(QPainter& painter) const {
    if (used_.isEmpty()) return;
    const double s = image_.devicePixelRatio();
    const QRectF target(used_.x() / s, used_.y() / s, used_.width() / s, used_.height() / s);
    if (used_ == image_.rect()) {
        painter.drawImage(target, image_);
        return;
    }
    // A copy of the used part: the painter would send the whole picture to the card. It sends the
    // same image once only.
    if (part_.isNull()) part_ = image_.copy(used_);
    painter.drawImage(target, part_);
}

void InkLayer::resize(const QSize& devicePixels, double devicePixelRatio) {
    layer_.resize(devicePixels, devicePixelRatio);
    valid_ = false;
}

bool InkLayer::update(const std::vector<PendingStroke>& strokes, const std::vector<bool>& dropped,
                      const OrthographicCamera& view, const ThemeColours& colours) {
    std::vector<int> ids;
    ids.reserve(strokes.size());
    for (const PendingStroke& stroke : strokes) ids.push_back(stroke.id);
    const bool grows = valid_ && view == view_ && colours_ == &colours &&
                       ids.size() >= ids_.size() &&
                       std::equal(ids_.begin(), ids_.end(), ids.begin()) &&
                       std::equal(dropped_.begin(), dropped_.end(), dropped.begin());
    std::size_t first = grows ? ids_.size() : 0;
    if (grows && first == ids.size()) return false;
    if (!grows) layer_.clear();
    QPainter painter(&layer_.image());
    painter.setRenderHint(QPainter::Antialiasing);
    for (std::size_t i = first; i < strokes.size(); ++i) {
        const QTransform map = sketchToView(strokes[i].camera, view);
        const bool off = i < dropped.size() && dropped[i];
        paintStroke(painter, strokes[i].stroke, map, {off ? colours.dropped : colours.ink, off});
        layer_.touch(boundsOf(strokes[i].stroke, map, 0));
    }
    ids_ = std::move(ids);
    dropped_ = dropped;
    dropped_.resize(ids_.size(), false);
    view_ = view;
    colours_ = &colours;
    valid_ = true;
    return true;
}

void WetInkLayer::resize(const QSize& devicePixels, double devicePixelRatio) {
    layer_.resize(devicePixels, devicePixelRatio);
    painted_ = 0;
}

void WetInkLayer::update(const Stroke* stroke, const ThemeColours& colours) {
    if (stroke == nullptr || stroke->samples.size() < painted_) {
        layer_.clear();
        painted_ = 0;
    }
    if (stroke == nullptr || stroke->samples.size() == painted_) return;
    const std::size_t first = painted_ > 0 ? painted_ - 1 : 0;
    QPainter painter(&layer_.image());
    painter.setRenderHint(QPainter::Antialiasing);
    paintStroke(painter, *stroke, {}, {colours.ink, false}, first);
    layer_.touch(boundsOf(*stroke, {}, first));
    painted_ = stroke->samples.size();
}

}  // namespace ew
