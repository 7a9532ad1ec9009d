// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QList>

class QAction;
class QString;
class QWidget;

namespace ew {

/// The tour in five lines and the gestures. One at a time; does not block the window.
void showQuickHelp(QWidget* window);

/// Every action of the window that has a shortcut, gathered from its menus.
void showShortcuts(QWidget* window, const QList<QAction*>& menus);

void showAbout(QWidget* window);

}  // namespace ew
