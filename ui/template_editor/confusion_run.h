// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QThreadPool>
#include <atomic>
#include <vector>

#include "core/reading/confusion.h"
#include "ui/template_editor/template_checker.h"
#include "ui/template_editor/template_model.h"

namespace ew {

/// Has a model of a hand draw the draft, and the templates that it shares views with, and counts
/// what the drawings are read as. On another thread, from start() on; a change of the template
/// makes what was found old.
class ConfusionRun : public QObject {
    Q_OBJECT

  public:
    static constexpr int kDrawings = 200;  ///< of each template

    ConfusionRun(TemplateModel& model, TemplateChecker& checker, QObject* parent = nullptr);
    ~ConfusionRun() override;

    /// \pre the draft is usable, but for its name and id.
    void start(int drawings = kDrawings);
    /// What was counted until then is dropped.
    void cancel();
    bool isRunning() const { return running_; }
    double done() const { return done_; }  ///< 0..1
    /// The draft first; empty before the first run has ended.
    const std::vector<ConfusionRow>& rows() const { return rows_; }
    /// Is rows() of a template that was changed since?
    bool isOld() const { return old_; }
    /// Id and name that the draft has in rows().
    const std::string& draftId() const { return draftId_; }
    /// Waits until it has ended.
    void settle();

  signals:
    void changed();

  private:
    void take(std::vector<ConfusionRow> rows, bool stopped);

    TemplateModel& model_;
    TemplateChecker& checker_;
    std::vector<ConfusionRow> rows_;
    std::string draftId_;
    std::atomic<double> done_ = 0.0;
    std::atomic<bool> stop_ = false;
    bool running_ = false;
    bool old_ = false;
    bool changedMeanwhile_ = false;
    QThreadPool thread_;  ///< one
};

}  // namespace ew
