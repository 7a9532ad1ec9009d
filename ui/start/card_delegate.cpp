// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/start/card_delegate.h"

#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>

#include "ui/theme/appearance.h"

namespace ew {

namespace {

constexpr int kPictureWidth = 208;
constexpr int kPictureHeight = 130;
constexpr int kPin = 26;

QRect frameOf(const QRect& cell) {
    const int margin = metrics::kSpace / 2;
    return cell.adjusted(margin, margin, -margin, -margin);
}

QRect pictureArea(const QRect& frame) {
    return {frame.left() + 1, frame.top() + 1, frame.width() - 2, kPictureHeight};
}

QRect pinArea(const QRect& frame) {
    return {frame.right() - kPin - metrics::kGap, frame.top() + metrics::kGap + 1, kPin, kPin};
}

/// A drawing pin, upright in a square of side 1.
QPainterPath pinShape() {
    QPainterPath shape;
    shape.addPolygon(QPolygonF({{0.32, 0.16},
                                {0.68, 0.16},
                                {0.63, 0.24},
                                {0.63, 0.44},
                                {0.76, 0.60},
                                {0.24, 0.60},
                                {0.37, 0.44},
                                {0.37, 0.24}}));
    shape.closeSubpath();
    shape.addRect(QRectF(0.475, 0.60, 0.05, 0.26));
    return shape;
}

}  // namespace

QPixmap pictureOf(const std::string& png) {
    QPixmap picture;
    picture.loadFromData(reinterpret_cast<const uchar*>(png.data()), static_cast<uint>(png.size()),
                         "PNG");
    return picture;
}

CardDelegate::CardDelegate(Appearance& appearance, QObject* parent)
    : QStyledItemDelegate(parent), appearance_(appearance) {}

QSize CardDelegate::sizeHint(const QStyleOptionViewItem& option, const QModelIndex&) const {
    const int lines = 2 * option.fontMetrics.height() + metrics::kGap;
    return {kPictureWidth + metrics::kSpace + 2,
            kPictureHeight + lines + 3 * metrics::kSpace + metrics::kGap};
}

void CardDelegate::paintPicture(QPainter& painter, const QRect& area,
                                const QModelIndex& index) const {
    const ThemeColours& c = appearance_.colours();
    const auto picture = index.data(Qt::DecorationRole).value<QPixmap>();
    painter.save();
    QPainterPath clip;
    clip.addRoundedRect(QRectF(area), metrics::kRadius - 1, metrics::kRadius - 1);
    painter.setClipPath(clip);
    painter.fillRect(area, c.background);
    if (picture.isNull()) {
        painter.setPen(c.mutedText);
        painter.drawText(area, Qt::AlignCenter, tr("No picture"));
    } else {
        const QSize size = picture.size().scaled(area.size(), Qt::KeepAspectRatioByExpanding);
        QRect target(QPoint(), size);
        target.moveCenter(area.center());
        painter.setRenderHint(QPainter::SmoothPixmapTransform);
        const bool missing = index.data(kMissingRole).toBool();
        constexpr double kFaded = 0.35;
        painter.setOpacity(missing ? kFaded : 1.0);
        painter.drawPixmap(target, picture);
    }
    painter.restore();
}

void CardDelegate::paintPin(QPainter& painter, const QRect& area, bool pinned) const {
    const ThemeColours& c = appearance_.colours();
    painter.setPen(QPen(pinned ? c.accent : c.border, 1.0));
    painter.setBrush(pinned ? c.accent : c.surface);
    painter.drawEllipse(QRectF(area).adjusted(0.5, 0.5, -0.5, -0.5));
    painter.save();
    painter.translate(area.topLeft());
    painter.scale(area.width(), area.height());
    painter.setPen(Qt::NoPen);
    painter.setBrush(pinned ? c.accentText : c.text);
    painter.drawPath(pinShape());
    painter.restore();
}

void CardDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option,
                         const QModelIndex& index) const {
    const ThemeColours& c = appearance_.colours();
    const bool hovered = option.state.testFlag(QStyle::State_MouseOver);
    const bool chosen = option.state.testFlag(QStyle::State_Selected) &&
                        option.state.testFlag(QStyle::State_HasFocus);
    const QRect frame = frameOf(option.rect);
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    painter->setPen(QPen(chosen ? c.accent : hovered ? c.mutedText : c.border, chosen ? 2.0 : 1.0));
    painter->setBrush(hovered ? mixColours(c.surface, c.raised, 0.6) : c.surface);
    painter->drawRoundedRect(QRectF(frame).adjusted(0.5, 0.5, -0.5, -0.5), metrics::kRadius,
                             metrics::kRadius);
    paintPicture(*painter, pictureArea(frame).adjusted(1, 1, -1, 0), index);

    const bool missing = index.data(kMissingRole).toBool();
    QRect text = frame.adjusted(metrics::kSpace + 2, kPictureHeight + metrics::kSpace,
                                -metrics::kSpace - 2, -metrics::kSpace);
    QFont bold = option.font;
    bold.setBold(true);
    const QFontMetrics strong(bold);
    painter->setFont(bold);
    painter->setPen(missing ? c.mutedText : c.text);
    painter->drawText(text.left(), text.top() + strong.ascent(),
                      strong.elidedText(index.data().toString(), Qt::ElideRight, text.width()));
    text.setTop(text.top() + strong.height() + metrics::kGap);
    painter->setFont(option.font);
    painter->setPen(missing ? c.warning : c.mutedText);
    painter->drawText(text.left(), text.top() + option.fontMetrics.ascent(),
                      option.fontMetrics.elidedText(index.data(kDetailRole).toString(),
                                                    Qt::ElideMiddle, text.width()));
    const QVariant pinned = index.data(kPinnedRole);
    if (pinned.isValid() && (pinned.toBool() || hovered || chosen)) {
        paintPin(*painter, pinArea(frame), pinned.toBool());
    }
    painter->restore();
}

bool CardDelegate::editorEvent(QEvent* event, QAbstractItemModel* model,
                               const QStyleOptionViewItem& option, const QModelIndex& index) {
    const bool click = event->type() == QEvent::MouseButtonPress ||
                       event->type() == QEvent::MouseButtonRelease ||
                       event->type() == QEvent::MouseButtonDblClick;
    if (click) tookClick_ = false;
    if (click && index.data(kPinnedRole).isValid()) {
        const auto* mouse = static_cast<QMouseEvent*>(event);
        const bool onPin = pinArea(frameOf(option.rect)).contains(mouse->position().toPoint());
        if (onPin && mouse->button() == Qt::LeftButton) {
            tookClick_ = true;
            if (event->type() == QEvent::MouseButtonRelease) emit pinClicked(index);
            return true;
        }
    }
    return QStyledItemDelegate::editorEvent(event, model, option, index);
}

}  // namespace ew
