// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/graph_view.h"

#include <QPainter>
#include <algorithm>
#include <set>

#include "ui/live_reading.h"
#include "ui/theme/appearance.h"
#include "ui/viewport/sketch_plane.h"

namespace ew {

namespace {

constexpr double kMarginPx = 26.0;  // room for numbers outside the drawing
constexpr double kDotPx = 4.0;
constexpr double kLargestScale = 1.5;  // a small scribble is not blown up

struct Fit {
    QTransform map;
    QPointF centre;  // of the drawing, in widget px
};

Fit fitReading(const Interpretation& reading, const QSizeF& size) {
    Eigen::AlignedBox2d box;
    for (const Junction& j : reading.graph.junctions) box.extend(j.position);
    for (const NoiseItem& n : reading.graph.noise) {
        for (const Vec2& p : n.polyline) box.extend(p);
    }
    for (const DanglingEdge& d : reading.graph.dangling) {
        box.extend(d.ends[0]);
        box.extend(d.ends[1]);
    }
    for (const Culprit& c : reading.culprits) {
        box.extend(c.at);
        box.extend(c.to);
    }
    Fit fit;
    fit.centre = {size.width() / 2, size.height() / 2};
    if (box.isEmpty()) return fit;
    const double sx = (size.width() - 2 * kMarginPx) / std::max(1.0, box.sizes().x());
    const double sy = (size.height() - 2 * kMarginPx) / std::max(1.0, box.sizes().y());
    const double scale = std::clamp(std::min(sx, sy), 1e-6, kLargestScale);
    fit.map.translate(fit.centre.x(), fit.centre.y());
    fit.map.scale(scale, scale);
    fit.map.translate(-box.center().x(), -box.center().y());
    return fit;
}

class GraphPainter {
  public:
    GraphPainter(QPainter& painter, const LiveReading& live, const ThemeColours& colours,
                 const QSizeF& size)
        : p_(painter), live_(live), r_(live.reading()), c_(colours), fit_(fitReading(r_, size)) {
        if (!live.settled()) return;
        for (const Culprit& culprit : r_.culprits) {
            if (culprit.edge >= 0) badEdges_.insert(culprit.edge);
            if (culprit.junction >= 0) badJunctions_.insert(culprit.junction);
        }
        if (r_.nearest) badEdges_.insert(r_.nearest->extra.begin(), r_.nearest->extra.end());
    }

    void paint() {
        dropped();
        edges();
        missing();
        culprits();
        junctions();
    }

  private:
    QPointF at(const Vec2& v) const { return fit_.map.map(toPoint(v)); }

    void dropped() {
        QPen pen(c_.dropped, 1.2);
        pen.setDashPattern({3.0, 3.0});
        p_.setPen(pen);
        for (const NoiseItem& item : r_.graph.noise) {
            QPolygonF line;
            for (const Vec2& v : item.polyline) line.append(at(v));
            p_.drawPolyline(line);
        }
    }

    void edges() {
        for (const DanglingEdge& edge : r_.graph.dangling) {
            p_.setPen(QPen(c_.mutedText, 1.4));
            p_.drawLine(at(edge.ends[0]), at(edge.ends[1]));
        }
        for (std::size_t i = 0; i < r_.graph.edges.size(); ++i) {
            const GraphEdge& edge = r_.graph.edges[i];
            const bool bad = badEdges_.contains(static_cast<int>(i));
            const bool extracted = edge.origin == EdgeOrigin::Model;
            p_.setPen(QPen(bad         ? c_.warning
                           : extracted ? c_.extracted
                                       : c_.read,
                           1.8, Qt::SolidLine, Qt::RoundCap));
            p_.drawLine(at(r_.graph.junctions[static_cast<std::size_t>(edge.ends[0])].position),
                        at(r_.graph.junctions[static_cast<std::size_t>(edge.ends[1])].position));
        }
    }

    void missing() {
        if (!live_.settled() || !r_.nearest) return;
        QPen pen(c_.warning, 1.8, Qt::SolidLine, Qt::RoundCap);
        pen.setDashPattern({0.5, 3.0});
        p_.setPen(pen);
        for (const auto& edge : r_.nearest->missing) p_.drawLine(at(edge[0]), at(edge[1]));
    }

    void culprits() {
        if (!live_.settled()) return;
        for (const Culprit& culprit : r_.culprits) {
            p_.setPen(QPen(c_.warning, 1.6));
            p_.setBrush(Qt::NoBrush);
            p_.drawEllipse(at(culprit.at), kDotPx + 4, kDotPx + 4);
            if (culprit.kind != Culprit::Kind::OpenEnd) continue;
            QPen gap(c_.warning, 1.4);
            gap.setDashPattern({2.0, 2.0});
            p_.setPen(gap);
            p_.drawLine(at(culprit.at), at(culprit.to));
        }
    }

    void junctions() {
        const int current = live_.current();
        const std::vector<int>* numbers =
            current >= 0 ? &r_.candidates[static_cast<std::size_t>(current)].junctionVertex
                         : nullptr;
        for (std::size_t i = 0; i < r_.graph.junctions.size(); ++i) {
            const QPointF p = at(r_.graph.junctions[i].position);
            const bool bad = badJunctions_.contains(static_cast<int>(i));
            p_.setPen(QPen(c_.surface, 1.5));
            p_.setBrush(bad ? c_.warning : c_.read);
            p_.drawEllipse(p, kDotPx, kDotPx);
            p_.setBrush(Qt::NoBrush);
            if (numbers == nullptr || i >= numbers->size() || (*numbers)[i] < 0) continue;
            number(i, p, (*numbers)[i]);
        }
    }

    /// In the widest gap between the junction's edges, where it covers no line.
    void number(std::size_t junction, const QPointF& p, int vertex) {
        std::vector<double> angles;
        for (const GraphEdge& edge : r_.graph.edges) {
            for (std::size_t end = 0; end < 2; ++end) {
                if (edge.ends[end] != static_cast<int>(junction)) continue;
                const Vec2 d =
                    r_.graph.junctions[static_cast<std::size_t>(edge.ends[1 - end])].position -
                    r_.graph.junctions[junction].position;
                angles.push_back(std::atan2(d.y(), d.x()));
            }
        }
        double best = -std::numbers::pi / 2;
        double widest = -1.0;
        std::sort(angles.begin(), angles.end());
        for (std::size_t i = 0; i < angles.size(); ++i) {
            const double next =
                i + 1 < angles.size() ? angles[i + 1] : angles[0] + 2 * std::numbers::pi;
            if (next - angles[i] > widest + 1e-6) {
                widest = next - angles[i];
                best = (next + angles[i]) / 2;
            }
        }
        const QPointF middle = p + 14.0 * QPointF(std::cos(best), std::sin(best));
        p_.setPen(c_.text);
        p_.drawText(QRectF(middle.x() - 12, middle.y() - 9, 24, 18), Qt::AlignCenter,
                    QString::number(vertex));
    }

    QPainter& p_;
    const LiveReading& live_;
    const Interpretation& r_;
    const ThemeColours& c_;
    Fit fit_;
    std::set<int> badEdges_;
    std::set<int> badJunctions_;
};

}  // namespace

GraphView::GraphView(LiveReading& reading, Appearance& appearance, QWidget* parent)
    : QWidget(parent), reading_(reading), appearance_(appearance) {
    setAccessibleName(tr("Edge Graph"));
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    connect(&reading, &LiveReading::changed, this, qOverload<>(&QWidget::update));
    connect(&appearance, &Appearance::changed, this, qOverload<>(&QWidget::update));
}

void GraphView::paintEvent(QPaintEvent*) {
    const ThemeColours& colours = appearance_.colours();
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(colours.border, 1.0));
    painter.setBrush(colours.surface);
    painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), metrics::kRadius,
                            metrics::kRadius);
    painter.setBrush(Qt::NoBrush);
    const EdgeGraph& graph = reading_.reading().graph;
    if (graph.empty() && graph.noise.empty() && graph.dangling.empty()) {
        painter.setPen(colours.mutedText);
        painter.drawText(rect().adjusted(metrics::kMargin, 0, -metrics::kMargin, 0),
                         Qt::AlignCenter | Qt::TextWordWrap,
                         tr("Lines and corners appear here while you draw."));
        return;
    }
    GraphPainter(painter, reading_, colours, size()).paint();
}

}  // namespace ew
