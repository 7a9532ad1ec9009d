// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/actions/surface_actions.h"

#include <QAction>
#include <QMenu>

#include "ui/surface_controller.h"
#include "ui/theme/themed_icon.h"
#include "ui/viewport/viewport_widget.h"

namespace ew {

SurfaceActions::SurfaceActions(const WindowContext& context, SurfaceController& controller,
                               QWidget* window)
    : QObject(window), context_(context), controller_(controller) {
    filletAction = makeAction("fillet", tr("&Fillet the chosen edges"), QStringLiteral("Ctrl+F"),
                              tr("Round the edges that the Surface panel names, with its radius"));
    sharpenAction = makeAction(nullptr, tr("Make the chosen edges &sharp"),
                               QStringLiteral("Ctrl+Shift+F"), tr("Take their fillets away"));
    smoothAction = makeAction("smooth", tr("Smoo&th surface"), QStringLiteral("S"),
                              tr("The smooth surface over the solid, on and off"));
    smoothAction->setCheckable(true);
    cageAction = makeAction("cage", tr("Show the &cage"), QStringLiteral("C"),
                            tr("The cage over the smooth surface"));
    cageAction->setCheckable(true);
    mapAction = makeAction("map-strokes", tr("&Map strokes onto the surface"),
                           QStringLiteral("Ctrl+M"), tr("Put what is drawn onto the surface"));
    unmapAction = makeAction(nullptr, tr("&Remove strokes from the surface"), QString(), QString());
    connect(sharpenAction, &QAction::triggered, this, [this] { controller_.sharpen(); });
    connect(smoothAction, &QAction::triggered, this,
            [this](bool on) { controller_.setSmooth(on); });
    connect(cageAction, &QAction::toggled, &context_.viewport, &ViewportWidget::setCageVisible);
    connect(mapAction, &QAction::triggered, this, [this] { controller_.mapStrokes(); });
    connect(unmapAction, &QAction::triggered, this, [this] { controller_.unmapStrokes(); });
    connect(&context_.document, &Document::changed, this, [this](DocumentChange what) {
        if (what == DocumentChange::Shape || what == DocumentChange::Ink) refresh();
    });
    connect(&controller_, &SurfaceController::changed, this, &SurfaceActions::refresh);
    refresh();
}

QAction* SurfaceActions::makeAction(const char* icon, const QString& text, const QString& key,
                                    const QString& tip) {
    auto* action = new QAction(text, this);
    if (icon != nullptr) action->setIcon(themedIcon(QLatin1String(icon)));
    if (!key.isEmpty()) action->setShortcut(QKeySequence(key));
    if (!tip.isEmpty()) action->setToolTip(key.isEmpty() ? tip : tr("%1 (%2)").arg(tip, key));
    return action;
}

void SurfaceActions::fill(QMenu* menu) {
    menu->addActions({filletAction, sharpenAction});
    menu->addSeparator();
    menu->addActions({smoothAction, cageAction});
    menu->addSeparator();
    menu->addActions({mapAction, unmapAction});
}

void SurfaceActions::refresh() {
    const DocumentState& state = context_.document.state();
    const bool solid = !state.bodies.empty();
    filletAction->setEnabled(solid);
    sharpenAction->setEnabled(state.surface.hasFillet());
    smoothAction->setEnabled(solid);
    smoothAction->setChecked(state.surface.subdivision.on);
    cageAction->setEnabled(state.surface.subdivision.on);
    mapAction->setEnabled(solid && !context_.document.pendingStrokes().empty());
    unmapAction->setEnabled(!state.mapped.empty());
}

}  // namespace ew
