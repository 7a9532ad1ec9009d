// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/panels/graph_panel.h"

#include <QLabel>
#include <QLocale>
#include <QVBoxLayout>

#include "ui/core_text.h"
#include "ui/live_reading.h"
#include "ui/panels/graph_view.h"
#include "ui/theme/colours.h"

namespace ew {

QString aspectText(const std::string& aspect) {
    const QString text = QString::fromStdString(aspect);
    const int count = text.section(QLatin1Char('-'), 1).toInt();
    if (text.startsWith(QLatin1String("mouth-"))) {
        return GraphPanel::tr("outline on %n face(s)", nullptr, count);
    }
    if (text.startsWith(QLatin1String("cavity-"))) {
        return GraphPanel::tr("seen through %n face(s)", nullptr, count);
    }
    if (text.startsWith(QLatin1String("explicit-"))) {
        bool ok = false;
        const int faces = text.mid(9).toInt(&ok);
        if (ok) return GraphPanel::tr("%n face(s) seen", nullptr, faces);
    }
    if (text == QLatin1String("region")) return GraphPanel::tr("drawing as a whole");
    return text;
}

namespace {

QString differenceText(const Interpretation& reading) {
    const auto missing = static_cast<int>(reading.nearest->missing.size());
    const auto extra = static_cast<int>(reading.nearest->extra.size());
    const auto open = static_cast<int>(reading.graph.openEnds.size());
    if (missing + extra > 0) {
        return GraphPanel::tr("%1 missing, %2 too many").arg(missing).arg(extra);
    }
    if (open > 0) return GraphPanel::tr("Every line is there, %n end(s) open", nullptr, open);
    return GraphPanel::tr("As many lines, which meet in another way");
}

}  // namespace

GraphPanel::GraphPanel(LiveReading& reading, Appearance& appearance, QWidget* parent)
    : QWidget(parent), reading_(reading), heading_(new QLabel(this)), detail_(new QLabel(this)) {
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(metrics::kMargin, metrics::kGap, metrics::kMargin, metrics::kMargin);
    layout->setSpacing(metrics::kGap);
    QFont bold = heading_->font();
    bold.setBold(true);
    heading_->setFont(bold);
    heading_->setObjectName(QStringLiteral("graphHeading"));
    detail_->setObjectName(QStringLiteral("graphDetail"));
    detail_->setForegroundRole(QPalette::PlaceholderText);
    layout->addWidget(heading_);
    layout->addWidget(detail_);
    layout->addSpacing(metrics::kGap);
    layout->addWidget(new GraphView(reading, appearance, this), 1);
    connect(&reading, &LiveReading::changed, this, &GraphPanel::refresh);
    refresh();
}

void GraphPanel::refresh() {
    const Interpretation& r = reading_.reading();
    const int current = reading_.current();
    if (current >= 0) {
        const Candidate& c = r.candidates[static_cast<std::size_t>(current)];
        heading_->setText(coreText(c.templateName));
        detail_->setText(tr("%1, fit %2 %, off by %3 px")
                             .arg(aspectText(c.aspect))
                             .arg(qRound(c.score * 100))
                             .arg(QLocale().toString(c.residualPx, 'f', 1)));
        return;
    }
    const int edges = static_cast<int>(r.graph.edges.size());
    if (r.nearest && reading_.settled()) {
        heading_->setText(tr("Nearest: %1").arg(coreText(r.nearest->templateName)));
        detail_->setText(differenceText(r));
        return;
    }
    heading_->setText(edges > 0 ? tr("No template yet") : tr("Nothing read yet"));
    detail_->setText(tr("%1, %2").arg(
        tr("%n edge(s)", nullptr, edges),
        tr("%n junction(s)", nullptr, static_cast<int>(r.graph.junctions.size()))));
}

}  // namespace ew
