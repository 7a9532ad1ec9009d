// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/document/document.h"

namespace ew {

class Appearance;
class ApplyController;
class BodySelection;
class LiveReading;
class MessageBar;
class ToolBox;
class ViewportWidget;

/// The parts of a window that its actions work on. All outlive the actions.
struct WindowContext {
    Document& document;
    LiveReading& reading;
    ApplyController& apply;
    ToolBox& tools;
    ViewportWidget& viewport;
    MessageBar& messages;
    Appearance& appearance;
    BodySelection& bodies;
};

}  // namespace ew
