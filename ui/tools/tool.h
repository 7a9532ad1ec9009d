// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "core/document/document.h"
#include "ui/input/pen_event.h"

namespace ew {

class LiveReading;
class ViewportWidget;

/// What tools work on.
struct ToolContext {
    Document& document;
    LiveReading& reading;
    ViewportWidget& viewport;
    /// Says a sentence to the person where an action failed.
    std::function<void(const Error&)> report;
    /// Ink was added or erased by hand, and the pen is up.
    std::function<void()> inkDone;
};

/// A gesture with the pointer. begin, any number of updates, then end (keep) or cancel (leave
/// everything as it was before begin). Tools keep no history.
class Tool {
  public:
    virtual ~Tool() = default;
    virtual void begin(const PenEvent& event) = 0;
    virtual void update(const PenEvent& event) = 0;
    virtual void end(const PenEvent& event) = 0;
    virtual void cancel() = 0;
    /// Like cancel(), but what was made of it can be done again.
    virtual void takeBack() { cancel(); }
};

}  // namespace ew
