// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/theme/themed_icon.h"

#include <QApplication>
#include <QFile>
#include <QIconEngine>
#include <QPainter>
#include <QPalette>
#include <QPixmap>
#include <QSvgRenderer>

namespace ew {

namespace {

// The icon files draw in this colour; it stands for "the text colour of the theme".
constexpr char kInkOfTheFiles[] = "#000000";

class ThemedIconEngine : public QIconEngine {
  public:
    explicit ThemedIconEngine(QString name) : name_(std::move(name)) {}

    void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State) override {
        const QPalette palette = QApplication::palette();
        const QPalette::ColorGroup group =
            mode == QIcon::Disabled ? QPalette::Disabled : QPalette::Active;
        QColor colour = palette.color(group, QPalette::WindowText);
        if (mode == QIcon::Selected) colour = palette.color(QPalette::HighlightedText);
        QByteArray svg = source();
        svg.replace(kInkOfTheFiles, colour.name().toLatin1());
        QSvgRenderer(svg).render(painter, rect);
    }

    QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override {
        QPixmap map(size);
        map.fill(Qt::transparent);
        QPainter painter(&map);
        paint(&painter, QRect(QPoint(0, 0), size), mode, state);
        return map;
    }

    QIconEngine* clone() const override { return new ThemedIconEngine(*this); }

  private:
    QByteArray source() {
        if (svg_.isEmpty()) {
            QFile file(QStringLiteral(":/icons/%1.svg").arg(name_));
            if (file.open(QIODevice::ReadOnly)) svg_ = file.readAll();
        }
        return svg_;
    }

    QString name_;
    QByteArray svg_;
};

}  // namespace

QIcon themedIcon(const QString& name) { return QIcon(new ThemedIconEngine(name)); }

}  // namespace ew
