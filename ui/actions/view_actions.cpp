// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/actions/view_actions.h"

#include <QAction>
#include <QActionGroup>
#include <QMenu>

#include "ui/theme/appearance.h"
#include "ui/theme/themed_icon.h"
#include "ui/viewport/viewport_widget.h"

namespace ew {

namespace {

std::vector<Vec3> seenPoints(const Document& document) {
    std::vector<Vec3> points = bodyPoints(document.state().bodies);
    for (const PendingStroke& stroke : document.pendingStrokes()) {
        for (const PenSample& s : stroke.stroke.samples) {
            points.push_back(stroke.camera.unproject(s.position));
        }
    }
    return points;
}

}  // namespace

ViewActions::ViewActions(const WindowContext& context, QWidget* window)
    : QObject(window),
      fitAction(new QAction(themedIcon("fit"), tr("&Fit"), this)),
      gridAction(new QAction(themedIcon("grid"), tr("&Grid"), this)),
      hiddenAction(new QAction(themedIcon("hidden-edges"), tr("&Hidden edges"), this)),
      readingAction(new QAction(themedIcon("reading"), tr("Show &reading"), this)),
      occlusionAction(new QAction(tr("Soft shado&ws"), this)),
      context_(context) {
    struct Entry {
        StandardView view;
        QString name;
        QKeySequence key;
        const char* icon;
    };
    const Entry entries[] = {
        {StandardView::Home, tr("&Start view"), QKeySequence(QStringLiteral("H")), "view-home"},
        {StandardView::Front, tr("Fr&ont"), QKeySequence(QStringLiteral("Ctrl+1")), "view-front"},
        {StandardView::Back, tr("&Back"), QKeySequence(QStringLiteral("Ctrl+2")), nullptr},
        {StandardView::Left, tr("&Left"), QKeySequence(QStringLiteral("Ctrl+3")), nullptr},
        {StandardView::Right, tr("R&ight"), QKeySequence(QStringLiteral("Ctrl+4")), "view-right"},
        {StandardView::Top, tr("&Top"), QKeySequence(QStringLiteral("Ctrl+5")), "view-top"},
        {StandardView::Bottom, tr("Botto&m"), QKeySequence(QStringLiteral("Ctrl+6")), nullptr},
    };
    for (const Entry& entry : entries) {
        auto* action = new QAction(entry.name, this);
        if (entry.icon != nullptr) action->setIcon(themedIcon(QLatin1String(entry.icon)));
        action->setShortcut(entry.key);
        QString plain = entry.name;
        plain.remove('&');
        action->setToolTip(tr("%1 (%2)").arg(plain, entry.key.toString()));
        connect(action, &QAction::triggered, this, [this, view = entry.view] { setView(view); });
        viewActions.push_back(action);
    }
    fitAction->setShortcut(QKeySequence(QStringLiteral("F")));
    fitAction->setToolTip(tr("Show everything (F)"));
    gridAction->setShortcut(QKeySequence(QStringLiteral("G")));
    hiddenAction->setShortcut(QKeySequence(QStringLiteral("D")));
    hiddenAction->setToolTip(tr("Hidden edges as dashes (D)"));
    readingAction->setShortcut(QKeySequence(QStringLiteral("R")));
    readingAction->setToolTip(tr("Show in the drawing what is read from it (R)"));
    occlusionAction->setToolTip(tr("Soft shadows in corners; slow without a graphics card"));
    occlusionAction->setCheckable(true);
    gridAction->setCheckable(true);
    hiddenAction->setCheckable(true);
    readingAction->setCheckable(true);
    gridAction->setChecked(context_.viewport.gridVisible());
    hiddenAction->setChecked(context_.viewport.hiddenEdgesVisible());
    readingAction->setChecked(context_.viewport.readingVisible());
    connect(fitAction, &QAction::triggered, this, &ViewActions::fitAll);
    connect(gridAction, &QAction::toggled, &context_.viewport, &ViewportWidget::setGridVisible);
    connect(hiddenAction, &QAction::toggled, &context_.viewport,
            &ViewportWidget::setHiddenEdgesVisible);
    connect(readingAction, &QAction::toggled, &context_.viewport,
            &ViewportWidget::setReadingVisible);
    occlusionAction->setChecked(context_.viewport.occlusionVisible());
    connect(occlusionAction, &QAction::toggled, &context_.viewport,
            &ViewportWidget::setOcclusionVisible);
}

void ViewActions::fill(QMenu* menu) {
    for (QAction* action : viewActions) menu->addAction(action);
    menu->addSeparator();
    menu->addAction(fitAction);
    menu->addSeparator();
    menu->addAction(gridAction);
    menu->addAction(hiddenAction);
    menu->addAction(readingAction);
    menu->addAction(occlusionAction);
    menu->addSeparator();
    fillTheme(menu->addMenu(tr("Th&eme")));
}

void ViewActions::fillTheme(QMenu* menu) {
    auto* group = new QActionGroup(this);
    const std::pair<Appearance::Mode, QString> modes[] = {
        {Appearance::Mode::System, tr("&System")},
        {Appearance::Mode::Light, tr("&Light")},
        {Appearance::Mode::Dark, tr("&Dark")},
    };
    for (const auto& [mode, name] : modes) {
        QAction* action = group->addAction(name);
        action->setCheckable(true);
        connect(action, &QAction::triggered, this,
                [this, mode = mode] { context_.appearance.setMode(mode); });
        // The mode may have been set from the settings or the command line.
        connect(menu, &QMenu::aboutToShow, action, [this, action, mode = mode] {
            action->setChecked(context_.appearance.mode() == mode);
        });
        menu->addAction(action);
    }
}

void ViewActions::setView(StandardView view) {
    OrthographicCamera camera = standardView(context_.document.camera(), view);
    const std::vector<Vec3> points = bodyPoints(context_.document.state().bodies);
    if (!points.empty()) {
        // Keep what was in the middle in the middle, at the same scale.
        const double scale = camera.worldPerPixel;
        camera = fitCamera(camera, points);
        if (camera.worldPerPixel < scale) camera.worldPerPixel = scale;
    }
    (void)context_.document.setCamera(camera);
}

void ViewActions::fitAll() {
    const std::vector<Vec3> points = seenPoints(context_.document);
    OrthographicCamera camera = context_.document.camera();
    if (points.empty()) {
        OrthographicCamera start;
        start.width = camera.width;
        start.height = camera.height;
        camera = start;
    } else {
        camera = fitCamera(camera, points);
    }
    (void)context_.document.setCamera(camera);
}

}  // namespace ew
