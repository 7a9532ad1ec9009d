// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/template_editor/aspect_list.h"

#include <QLocale>
#include <QPainter>
#include <algorithm>

#include "ui/core_text.h"
#include "ui/theme/appearance.h"
#include "ui/viewport/sketch_plane.h"

namespace ew {

namespace {

constexpr QSize kPicture(64, 56);
constexpr double kMarginPx = 6.0;
constexpr int kIndexRole = Qt::UserRole;
// A shape leaves hundreds of outlines in a solid; the likeliest tell enough.
constexpr int kMostCuts = 24;

QString shareText(const AspectFacts& facts) {
    if (!facts.share) return {};
    const double percent = *facts.share * 100.0;
    if (percent > 99.0) return AspectList::tr("from nearly all sides");
    if (percent < 1.0) return AspectList::tr("from under 1 % of all sides");
    return AspectList::tr("from %1 % of all sides").arg(qRound(percent));
}

QString kindText(const Aspect& aspect) {
    switch (aspect.kind) {
        case AspectKind::Explicit:
            break;
        case AspectKind::Mouth:
            return AspectList::tr("opening of %n face(s)", nullptr,
                                  static_cast<int>(aspect.mouth.size()));
        case AspectKind::Cavity:
            return AspectList::tr("opening with what is seen through it");
    }
    const QString faces =
        AspectList::tr("%n face(s)", nullptr, static_cast<int>(aspect.visibleFaces.size()));
    return aspect.edgeOn ? AspectList::tr("%1, others seen as lines").arg(faces) : faces;
}

}  // namespace

QPixmap aspectPicture(const Aspect& aspect, const QSize& size, double devicePixelRatio,
                      const QColor& line) {
    QPixmap picture(size * devicePixelRatio);
    picture.setDevicePixelRatio(devicePixelRatio);
    picture.fill(Qt::transparent);
    Eigen::AlignedBox2d box;
    for (const Vec2& p : aspect.graph.points) box.extend(p);
    if (box.isEmpty()) return picture;
    const double scale =
        std::min((size.width() - 2 * kMarginPx) / std::max(1e-9, box.sizes().x()),
                 (size.height() - 2 * kMarginPx) / std::max(1e-9, box.sizes().y()));
    const auto at = [&](int v) {
        const Vec2 off = (aspect.graph.points[static_cast<std::size_t>(v)] - box.center()) * scale;
        return QPointF(size.width() / 2.0, size.height() / 2.0) + toPoint(off);
    };
    QPainter painter(&picture);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(line, 1.4, Qt::SolidLine, Qt::RoundCap));
    for (const auto& edge : aspect.graph.edges) painter.drawLine(at(edge[0]), at(edge[1]));
    painter.setPen(Qt::NoPen);
    painter.setBrush(line);
    for (std::size_t v = 0; v < aspect.vertex.size(); ++v) {
        if (aspect.vertex[v] >= 0) painter.drawEllipse(at(static_cast<int>(v)), 2.2, 2.2);
    }
    return picture;
}

AspectList::AspectList(Appearance& appearance, QWidget* parent)
    : QListWidget(parent), appearance_(appearance) {
    setAccessibleName(tr("Views of the template"));
    setIconSize(kPicture);
    setWordWrap(true);
    setTextElideMode(Qt::ElideNone);
    setResizeMode(Adjust);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setVerticalScrollMode(ScrollPerPixel);
    connect(&appearance, &Appearance::changed, this, &AspectList::refresh);
    const auto look = [this](const QListWidgetItem* item) {
        if (item == nullptr || !item->data(kIndexRole).isValid()) return;
        const Aspect& a = aspects_[item->data(kIndexRole).toUInt()].aspect;
        if (!a.directions.empty()) emit lookedAt(a.directions.front());
    };
    // A click on the one that is chosen turns the shape back to it.
    connect(this, &QListWidget::currentItemChanged, this, look);
    connect(this, &QListWidget::itemClicked, this, look);
}

void AspectList::show(const std::vector<AspectFacts>& aspects, const TemplateLibrary& others) {
    aspects_ = aspects;
    others_ = others;
    refresh();
}

void AspectList::refresh() {
    const QSignalBlocker quiet(this);
    clear();
    int cuts = 0;
    for (std::size_t i = 0; i < aspects_.size(); ++i) {
        const bool cut = aspects_[i].aspect.kind != AspectKind::Explicit;
        if (i == 0 && !cut) addHeading(tr("Drawn by itself"));
        if (cut && cuts == 0) addHeading(tr("Drawn on a solid"));
        if (cut && ++cuts > kMostCuts) continue;
        addAspect(i, others_);
    }
    if (cuts > kMostCuts) addRemark(tr("and %n more", nullptr, cuts - kMostCuts));
    if (cuts == 0 && !aspects_.empty()) {
        addHeading(tr("Drawn on a solid"));
        addRemark(tr("Not read there: it has too many edges."));
    }
}

void AspectList::addRemark(const QString& text) {
    auto* item = new QListWidgetItem(text, this);
    item->setFlags(Qt::NoItemFlags);
    item->setForeground(appearance_.colours().mutedText);
}

void AspectList::addHeading(const QString& text) {
    auto* item = new QListWidgetItem(text, this);
    item->setFlags(Qt::NoItemFlags);
    QFont bold = font();
    bold.setBold(true);
    item->setFont(bold);
    item->setForeground(appearance_.colours().text);
}

void AspectList::addAspect(std::size_t index, const TemplateLibrary& others) {
    const AspectFacts& facts = aspects_[index];
    const ThemeColours& c = appearance_.colours();
    QStringList lines{kindText(facts.aspect)};
    const QString share = shareText(facts);
    if (!share.isEmpty()) lines << share;
    QStringList names;
    for (const std::string& id : facts.alsoShownBy) {
        const int other = others.find(id);
        if (other >= 0) names << coreText(others.at(static_cast<std::size_t>(other)).name);
    }
    if (!names.isEmpty()) lines << tr("also: %1").arg(names.join(QStringLiteral(", ")));
    lines.front().front() = lines.front().front().toUpper();
    auto* item = new QListWidgetItem(lines.join('\n'), this);
    const QPixmap picture = aspectPicture(facts.aspect, kPicture, devicePixelRatioF(), c.read);
    QIcon icon(picture);
    icon.addPixmap(picture, QIcon::Selected);  // else it is tinted
    item->setIcon(icon);
    item->setData(kIndexRole, static_cast<uint>(index));
}

}  // namespace ew
