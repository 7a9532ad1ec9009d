// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewport/reading_overlay.h"

#include <QFontMetricsF>
#include <QPainter>
#include <algorithm>
#include <vector>

#include "ui/core_text.h"
#include "ui/viewport/sketch_plane.h"
#include "ui/viewport/wireframe.h"

namespace ew {

namespace {

constexpr double kEdgePx = 1.2;
constexpr double kDotPx = 2.8;
constexpr double kRingPx = 11.0;  // round a culprit that is a place

class Painter {
  public:
    Painter(QPainter& painter, const ReadingOverlay& overlay, const ThemeColours& colours,
            const QRectF& bounds)
        : p_(painter),
          o_(overlay),
          c_(colours),
          bounds_(bounds),
          map_(sketchToView(overlay.sketchCamera, overlay.viewCamera)),
          scale_(meanScale(map_)) {}

    void ghost() {
        if (o_.ghost < 0 || o_.ghost >= static_cast<int>(o_.reading->candidates.size())) return;
        const Candidate& candidate = o_.reading->candidates[static_cast<std::size_t>(o_.ghost)];
        QColor colour = c_.ghost;
        if (candidate.operation == Operation::Add) colour = c_.added;
        if (candidate.operation == Operation::Cut || candidate.operation == Operation::Split) {
            colour = c_.removed;
        }
        if (colour != c_.ghost) fillFaces(candidate, colour);
        QPen seen(colour, 1.4);
        QPen hidden(colour, 1.0);
        seen.setCapStyle(Qt::RoundCap);
        hidden.setDashPattern({4.0, 4.0});
        for (const WireSegment& s : wireSegments(candidate.spec, candidate.pose, o_.viewCamera)) {
            p_.setPen(s.hidden ? hidden : seen);
            p_.drawLine(toPoint(s.ends[0]), toPoint(s.ends[1]));
        }
    }

    /// What is added or cut, as tinted glass.
    void fillFaces(const Candidate& candidate, QColor colour) {
        colour.setAlphaF(0.16F);
        p_.setPen(Qt::NoPen);
        p_.setBrush(colour);
        for (const auto& loop : candidate.spec.faces) {
            QPolygonF face;
            double area = 0;
            for (std::size_t i = 0; i < loop.size(); ++i) {
                const auto corner = [&](std::size_t k) {
                    const auto v = static_cast<std::size_t>(loop[k % loop.size()]);
                    return o_.viewCamera.project(
                        candidate.pose.toWorld(candidate.spec.vertices[v]));
                };
                area += cross2(corner(i), corner(i + 1));
                face.append(toPoint(corner(i)));
            }
            // Towards the eye only, so that glass before glass is not counted twice.
            if (area < 0) p_.drawPolygon(face);
        }
        p_.setBrush(Qt::NoBrush);
    }

    void graph() {
        const EdgeGraph& graph = o_.reading->graph;
        QPen stroke(c_.read, kEdgePx);
        const QPen model(c_.extracted, kEdgePx);
        for (const GraphEdge& edge : graph.edges) {
            p_.setPen(edge.origin == EdgeOrigin::Model ? model : stroke);
            p_.drawLine(at(graph.junctions[static_cast<std::size_t>(edge.ends[0])].position),
                        at(graph.junctions[static_cast<std::size_t>(edge.ends[1])].position));
        }
        p_.setPen(QPen(c_.background, 1.0));
        p_.setBrush(c_.read);
        for (const Junction& junction : graph.junctions) {
            p_.drawEllipse(at(junction.position), kDotPx, kDotPx);
        }
        p_.setBrush(Qt::NoBrush);
        QPen off(c_.dropped, 1.0);
        off.setDashPattern({3.0, 3.0});
        p_.setPen(off);
        if (graph.empty()) return;
        for (const NoiseItem& item : graph.noise) {
            QPolygonF line;
            for (const Vec2& v : item.polyline) line.append(at(v));
            p_.drawPolyline(line);
        }
    }

    void missing() {
        if (!o_.reading->nearest) return;
        QPen pen(c_.warning, 1.6);
        pen.setDashPattern({1.0, 3.0});
        pen.setCapStyle(Qt::RoundCap);
        p_.setPen(pen);
        for (const auto& edge : o_.reading->nearest->missing) p_.drawLine(at(edge[0]), at(edge[1]));
    }

    void culprits() {
        p_.setBrush(Qt::NoBrush);
        for (const Culprit& culprit : o_.reading->culprits) mark(culprit);
        // Open ends first: they are what a click repairs.
        for (const bool openEnds : {true, false}) {
            for (const Culprit& culprit : o_.reading->culprits) {
                if ((culprit.kind == Culprit::Kind::OpenEnd) == openEnds) label(culprit);
            }
        }
    }

  private:
    QPointF at(const Vec2& v) const { return map_.map(toPoint(v)); }

    double radiusOf(const Culprit& culprit) const {
        return culprit.kind == Culprit::Kind::OpenEnd ? o_.thresholds.distancePx * scale_ : kRingPx;
    }

    /// Beside the ring where there is room; a label that would cover another one or another ring is
    /// left out, the ring says enough.
    void label(const Culprit& culprit) {
        if (culprit.label.empty()) return;
        const QString text = coreText(culprit.label);
        const QFontMetricsF metrics(p_.font());
        const QSizeF size(metrics.horizontalAdvance(text) + 12, metrics.height() + 6);
        const QPointF tip = at(culprit.at);
        const double reach = radiusOf(culprit) + 6.0;
        const double aside = reach + size.width() / 2;
        const double above = reach + size.height() / 2;
        for (const QPointF& offset :
             {QPointF(aside, 0), QPointF(-aside, 0), QPointF(0, -above), QPointF(0, above)}) {
            QRectF plate(QPointF(0, 0), size);
            plate.moveCenter(tip + offset);
            const bool free =
                bounds_.contains(plate) &&
                std::none_of(plates_.begin(), plates_.end(),
                             [&](const QRectF& other) { return other.intersects(plate); });
            if (!free) continue;
            paintPlate(plate, text);
            plates_.push_back(plate);
            return;
        }
    }

    void paintPlate(const QRectF& plate, const QString& text) {
        QColor back = c_.surface;
        back.setAlphaF(0.92F);
        p_.setPen(QPen(c_.border, 1.0));
        p_.setBrush(back);
        p_.drawRoundedRect(plate, 4, 4);
        p_.setBrush(Qt::NoBrush);
        p_.setPen(c_.warning);
        p_.drawText(plate, Qt::AlignCenter, text);
    }

    void mark(const Culprit& culprit) {
        const QPointF tip = at(culprit.at);
        const auto edgeCount = static_cast<int>(o_.reading->graph.edges.size());
        if (culprit.edge >= 0 && culprit.edge < edgeCount &&
            culprit.kind != Culprit::Kind::OpenEnd) {
            const EdgeGraph& graph = o_.reading->graph;
            const GraphEdge& edge = graph.edges[static_cast<std::size_t>(culprit.edge)];
            p_.setPen(QPen(c_.warning, 2.2, Qt::SolidLine, Qt::RoundCap));
            p_.drawLine(at(graph.junctions[static_cast<std::size_t>(edge.ends[0])].position),
                        at(graph.junctions[static_cast<std::size_t>(edge.ends[1])].position));
        }
        p_.setPen(QPen(c_.warning, 1.6));
        const double r = radiusOf(culprit);
        p_.drawEllipse(tip, r, r);
        plates_.emplace_back(tip.x() - r, tip.y() - r, 2 * r, 2 * r);
        if (culprit.kind != Culprit::Kind::OpenEnd) return;
        QPen gap(c_.warning, 1.4);
        gap.setDashPattern({3.0, 3.0});
        p_.setPen(gap);
        p_.drawLine(tip, at(culprit.to));
        p_.setPen(Qt::NoPen);
        p_.setBrush(c_.warning);
        p_.drawEllipse(tip, 2.4, 2.4);
        p_.drawEllipse(at(culprit.to), 2.4, 2.4);
        p_.setBrush(Qt::NoBrush);
    }

    QPainter& p_;
    const ReadingOverlay& o_;
    const ThemeColours& c_;
    QRectF bounds_;
    QTransform map_;
    double scale_;
    std::vector<QRectF> plates_;  // taken: rings and labels
};

}  // namespace

void paintReading(QPainter& painter, const ReadingOverlay& overlay, const ThemeColours& colours,
                  const QRectF& bounds) {
    if (overlay.reading == nullptr) return;
    Painter p(painter, overlay, colours, bounds);
    p.ghost();
    p.graph();
    if (!overlay.criticise) return;
    p.missing();
    p.culprits();
}

}  // namespace ew
