// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include "core/base/result.h"

namespace ew {

/// What must be set before the QApplication is made: OpenGL surface format, context sharing, the
/// xcb platform where there is an X display and none was asked for.
void prepareApplication();

/// Without a display Qt ends a program by aborting it while its QApplication is made. As long as
/// this lives, the program ends with status 2 and a sentence on stderr instead. One at a time.
class DisplayGuard {
  public:
    /// \param program  its name, for the sentence; outlives this.
    explicit DisplayGuard(const char* program);
    ~DisplayGuard();
    DisplayGuard(const DisplayGuard&) = delete;
    DisplayGuard& operator=(const DisplayGuard&) = delete;
};

/// Does the command line ask for help or the version only? That needs no display, so a
/// QCoreApplication is enough to answer it.
bool asksForWords(int argc, char** argv);

/// Name and version, right after the application was made, of whatever kind it is.
void nameProgram();

/// The same for one with windows: also samples of mouse, pen and touch one by one, icon and
/// resources of the library.
void nameApplication();

/// Loads the texts of a language, before the first window is made.
/// \param language  a code like "de" or "en"; empty: the system's, or English where there is no
/// translation for it. A named one decides the form of numbers and dates too.
/// Errors: Errc::BadValue for a language without a translation.
Result<void> chooseLanguage(const QString& language = {});

}  // namespace ew
