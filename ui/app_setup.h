// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace ew {

/// What must be set before the QApplication is made: OpenGL surface format, context sharing, pen
/// samples one by one, the xcb platform where there is an X display and none was asked for.
void prepareApplication();

/// What must be set right after: name, version, icon, resources of the library.
void nameApplication();

}  // namespace ew
