// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewport/ghost_overlay.h"

#include <QPainter>
#include <QPainterPath>
#include <algorithm>

#include "ui/theme/colours.h"
#include "ui/viewport/sketch_plane.h"

namespace ew {

namespace {

constexpr double kGhostPx = 6.0;
constexpr double kPenPx = 2.5;
constexpr double kPenTipPx = 5.0;

std::size_t sampleCount(const Ghost& ghost) {
    std::size_t count = 0;
    for (const Stroke& s : ghost.strokes) count += s.samples.size();
    return count;
}

}  // namespace

void paintGhost(QPainter& painter, const Ghost& ghost, const OrthographicCamera& view,
                const ThemeColours& colours) {
    const QTransform map = sketchToView(ghost.camera, view);
    QPainterPath all;
    QPainterPath done;
    QPointF tip;
    auto left = static_cast<std::size_t>(std::clamp(ghost.drawn, 0.0, 1.0) *
                                         static_cast<double>(sampleCount(ghost)));
    const bool shows = left > 0;
    for (const Stroke& stroke : ghost.strokes) {
        for (std::size_t i = 0; i < stroke.samples.size(); ++i) {
            const QPointF p = map.map(toPoint(stroke.samples[i].position));
            i == 0 ? all.moveTo(p) : all.lineTo(p);
            if (left == 0) continue;
            i == 0 ? done.moveTo(p) : done.lineTo(p);
            tip = p;
            --left;
        }
    }
    painter.save();
    painter.setBrush(Qt::NoBrush);
    painter.setOpacity(ghost.opacity);
    painter.setPen(QPen(colours.mutedText, kGhostPx, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPath(all);
    if (shows) {
        painter.setOpacity(1.0);
        painter.setPen(QPen(colours.accent, kPenPx, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        painter.drawPath(done);
        painter.setBrush(colours.accent);
        painter.drawEllipse(tip, kPenTipPx, kPenTipPx);
    }
    painter.restore();
}

}  // namespace ew
