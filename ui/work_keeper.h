// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QTimer>
#include <functional>

#include "core/document/work_copy.h"
#include "ui/window_context.h"

class QWidget;

namespace ew {

/// Keeps the working copy of a window's document, with a small picture of it, and offers what an
/// earlier run left.
class WorkKeeper : public QObject {
    Q_OBJECT

  public:
    WorkKeeper(const WindowContext& context, const WorkFolder& folder, QWidget* window);

    const WorkFolder& folder() const { return folder_; }
    WorkCopy& copy() { return copy_; }
    /// Offers what was not closed as one closes a document.
    /// \return false where there is nothing.
    bool offerLost();
    /// Offers all that is still there.
    void offerAll();
    /// Takes a copy into the window, in place of its document.
    bool restore(const WorkCopyEntry& entry);
    /// The small picture is made anew.
    void takePicture();
    /// Must answer whether the document may be replaced; asked before a copy takes its place.
    void setQuestion(std::function<bool()> mayDiscard) { mayDiscard_ = std::move(mayDiscard); }

    /// Nobody wants a copy back for now.
    void putAway(const WorkCopyEntry& entry);

  signals:
    /// The small picture was made anew.
    void pictured();

  private:
    void offer(const std::vector<WorkCopyEntry>& entries);

    WindowContext context_;
    WorkFolder folder_;
    QWidget* window_;
    WorkCopy copy_;
    QTimer pictureSoon_;
    std::function<bool()> mayDiscard_;
};

}  // namespace ew
