// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <array>

#include "core/solid/mirror.h"
#include "ui/window_context.h"

class QAction;
class QMenu;

namespace ew {

/// The mirror plane: through the middle of a solid, or none.
class MirrorActions : public QObject {
    Q_OBJECT

  public:
    MirrorActions(const WindowContext& context, QWidget* window);

    void fill(QMenu* menu);

  private:
    /// Across a world axis, through the middle of the chosen solids, else of all that are shown,
    /// else of the world.
    void set(int axis);
    void tell(const Result<void>& result, const QString& done);
    void refresh();

    WindowContext context_;
    std::array<QAction*, 3> across_{};
    QAction* drop_;
};

}  // namespace ew
