// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/theme/appearance.h"

#include <QApplication>

#include "ui/theme/outlined_style.h"

namespace ew {

namespace {

QPalette makePalette(const ThemeColours& c) {
    QPalette p;
    p.setColor(QPalette::Window, c.window);
    p.setColor(QPalette::WindowText, c.text);
    p.setColor(QPalette::Base, c.surface);
    p.setColor(QPalette::AlternateBase, c.window);
    p.setColor(QPalette::Text, c.text);
    p.setColor(QPalette::PlaceholderText, c.mutedText);
    p.setColor(QPalette::Button, c.raised);
    p.setColor(QPalette::ButtonText, c.text);
    p.setColor(QPalette::BrightText, c.warning);
    p.setColor(QPalette::Highlight, c.accent);
    p.setColor(QPalette::HighlightedText, c.accentText);
    p.setColor(QPalette::Link, c.accent);
    p.setColor(QPalette::LinkVisited, c.accent);
    p.setColor(QPalette::ToolTipBase, c.surface);
    p.setColor(QPalette::ToolTipText, c.text);
    p.setColor(QPalette::Light, mixColours(c.raised, Qt::white, c.dark ? 0.06 : 0.6));
    p.setColor(QPalette::Midlight, mixColours(c.raised, c.window, 0.5));
    p.setColor(QPalette::Mid, c.border);
    p.setColor(QPalette::Dark, mixColours(c.border, Qt::black, c.dark ? 0.35 : 0.2));
    p.setColor(QPalette::Shadow, mixColours(c.border, Qt::black, c.dark ? 0.7 : 0.5));
    const QColor disabled = mixColours(c.mutedText, c.window, 0.45);
    for (const QPalette::ColorRole role :
         {QPalette::WindowText, QPalette::Text, QPalette::ButtonText}) {
        p.setColor(QPalette::Disabled, role, disabled);
    }
    p.setColor(QPalette::Disabled, QPalette::Highlight, c.border);
    return p;
}

QString makeStyleSheet(const ThemeColours& c) {
    return QStringLiteral(
               "QToolTip { color: %1; background: %2; border: 1px solid %3; padding: 4px; }"
               "QDockWidget::title { background: %4; padding: 6px 8px; text-align: left; }"
               "QListWidget, QListView#historyList { border: 1px solid %3; border-radius: 6px; "
               "background: %2;"
               "  padding: 3px; }"
               "QListWidget:focus, QListView#historyList:focus { border-color: %6; }"
               "QListWidget::item { padding: 4px; border-radius: 4px; color: %1; }"
               // No colour of text here: what is undone has one of its own.
               "QListView#historyList::item { padding: 3px; border-radius: 4px; }"
               "QListWidget::item:hover, QListView#historyList::item:hover { background: %5; }"
               "QListWidget::item:selected, QListView#historyList::item:selected {"
               "  background: %7; color: %1; }"
               "QToolBar { background: %4; border: 0; border-bottom: 1px solid %3; spacing: 2px;"
               "  padding: 3px 6px; }"
               "QToolBar QToolButton { border: 1px solid transparent; border-radius: 5px;"
               "  padding: 4px; }"
               "QToolBar QToolButton:hover { background: %5; }"
               "QToolBar QToolButton:focus { border-color: %6; }"
               "QToolBar QToolButton:checked { background: %7; }"
               "QToolBar QToolButton:pressed { background: %3; }"
               // The padding of the other buttons would leave nothing of its arrow.
               "QToolBar QToolButton#qt_toolbar_ext_button { padding: 0; }"
               "QToolBar::separator { background: %3; width: 1px; margin: 5px 6px; }"
               "QMainWindow::separator { background: %3; width: 1px; height: 1px; }")
        .arg(c.text.name(), c.surface.name(), c.border.name(), c.window.name(), c.raised.name(),
             c.accent.name(), mixColours(c.surface, c.accent, c.dark ? 0.28 : 0.18).name());
}

}  // namespace

Appearance::Appearance(QObject* parent) : QObject(parent) {
    systemIsDark_ = isDark(QApplication::palette().color(QPalette::Window));
    QApplication::setStyle(new OutlinedStyle);
    apply();
}

void Appearance::setMode(Mode mode) {
    if (mode == mode_) return;
    mode_ = mode;
    apply();
    emit changed();
}

void Appearance::apply() {
    const bool dark = mode_ == Mode::Dark || (mode_ == Mode::System && systemIsDark_);
    colours_ = dark ? &darkColours() : &lightColours();
    QApplication::setPalette(makePalette(*colours_));
    qApp->setStyleSheet(makeStyleSheet(*colours_));
}

QString Appearance::modeName(Mode mode) {
    switch (mode) {
        case Mode::Light:
            return QStringLiteral("light");
        case Mode::Dark:
            return QStringLiteral("dark");
        case Mode::System:
            break;
    }
    return QStringLiteral("system");
}

Appearance::Mode Appearance::modeFromName(const QString& name) {
    if (name == QLatin1String("light")) return Mode::Light;
    if (name == QLatin1String("dark")) return Mode::Dark;
    return Mode::System;
}

}  // namespace ew
