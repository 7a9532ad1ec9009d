// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QPalette>

#include "ui/theme/colours.h"

namespace ew {

/// The look in force: light, dark or as the system has it. Sets the application's style, palette
/// and style sheet; widgets that paint themselves ask colours() and listen to changed().
class Appearance : public QObject {
    Q_OBJECT

  public:
    enum class Mode { System, Light, Dark };

    /// Remembers the palette that the application started with, to know what the system has.
    explicit Appearance(QObject* parent = nullptr);

    Mode mode() const { return mode_; }
    void setMode(Mode mode);
    const ThemeColours& colours() const { return *colours_; }

    /// "system", "light", "dark", for settings and the command line.
    static QString modeName(Mode mode);
    /// System for any other text.
    static Mode modeFromName(const QString& name);

  signals:
    void changed();

  private:
    void apply();

    Mode mode_ = Mode::System;
    bool systemIsDark_ = false;
    const ThemeColours* colours_ = nullptr;
};

}  // namespace ew
