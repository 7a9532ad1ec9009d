// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/actions/mirror_actions.h"

#include <Eigen/Geometry>
#include <QAction>
#include <QMenu>
#include <algorithm>

#include "ui/body_selection.h"
#include "ui/panels/message_bar.h"

namespace ew {

MirrorActions::MirrorActions(const WindowContext& context, QWidget* window)
    : QObject(window), context_(context), drop_(new QAction(tr("&No mirror plane"), this)) {
    const std::array<QString, 3> names{tr("Left and right, across &X"),
                                       tr("Front and back, across &Y"),
                                       tr("Above and below, across &Z")};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        across_[axis] = new QAction(names[axis], this);
        across_[axis]->setToolTip(
            tr("What you draw, pull and round from now on is done on both sides of the plane "
               "through the middle of the chosen solids"));
        connect(across_[axis], &QAction::triggered, this,
                [this, axis] { set(static_cast<int>(axis)); });
    }
    connect(drop_, &QAction::triggered, this, [this] {
        tell(context_.document.setMirror(std::nullopt),
             tr("No mirror plane: what you draw is done once."));
    });
    connect(&context_.document, &Document::changed, this, [this](DocumentChange what) {
        if (what == DocumentChange::History) refresh();
    });
    refresh();
}

void MirrorActions::fill(QMenu* menu) {
    QMenu* planes = menu->addMenu(tr("Mirror &plane"));
    planes->setToolTipsVisible(true);
    for (QAction* action : across_) planes->addAction(action);
    planes->addSeparator();
    planes->addAction(drop_);
}

void MirrorActions::set(int axis) {
    const std::vector<Body>& bodies = context_.document.state().bodies;
    const std::vector<int>& chosen = context_.bodies.chosen();
    Eigen::AlignedBox3d box;
    for (std::size_t b = 0; b < bodies.size(); ++b) {
        const bool wanted =
            chosen.empty() ? !bodies[b].hidden
                           : std::binary_search(chosen.begin(), chosen.end(), static_cast<int>(b));
        if (!wanted) continue;
        const auto [low, high] = worldBounds(bodies[b]);
        box.extend(low).extend(high);
    }
    MirrorPlane plane;
    plane.point = box.isEmpty() ? Vec3(Vec3::Zero()) : Vec3(box.center());
    plane.normal = Vec3::Unit(axis);
    tell(context_.document.setMirror(plane),
         tr("Mirror plane set: what you draw, pull and round is done on both sides."));
}

void MirrorActions::tell(const Result<void>& result, const QString& done) {
    if (result) {
        context_.messages.showNotice(done);
    } else {
        context_.messages.showError(result.error());
    }
}

void MirrorActions::refresh() { drop_->setEnabled(context_.document.state().mirror.has_value()); }

}  // namespace ew
