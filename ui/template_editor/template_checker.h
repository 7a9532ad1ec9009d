// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QThreadPool>
#include <optional>

#include "ui/template_editor/template_model.h"
#include "ui/template_editor/template_report.h"

namespace ew {

/// Checks the draft of a model after each change on another thread: names, shape and rules at once,
/// then the views, which take longer. What is older than the newest change is dropped.
class TemplateChecker : public QObject {
    Q_OBJECT

  public:
    /// \param others  the templates in use, without the one that is edited.
    TemplateChecker(TemplateModel& model, TemplateLibrary others, QObject* parent = nullptr);
    ~TemplateChecker() override;

    const TemplateLibrary& others() const { return others_; }
    const DraftReport& report() const { return report_; }
    const AspectReport& aspects() const { return aspects_; }
    /// Do report() and aspects() speak of the draft as it is?
    bool upToDate() const { return checking_ == 0 && !looking_; }
    /// Are the views of a new shape being looked at?
    bool isLooking() const { return looking_; }
    /// Waits until they do.
    void settle();

  signals:
    void reportChanged();
    /// The views, or whether they are being looked at.
    void aspectsChanged();

  private:
    void check();
    void takeReport(DraftReport report, long revision);
    /// Looks at the views of the draft where they are not those that are known.
    void look();
    void takeAspects(AspectReport aspects, const Template& tmpl);

    TemplateModel& model_;
    TemplateLibrary others_;
    DraftReport report_;
    AspectReport aspects_;
    std::optional<Template> lookedAt_;  ///< aspects_ are of its shape and relations
    long revision_ = 0;
    int checking_ = 0;
    bool looking_ = false;
    QThreadPool threads_;  ///< two: a check never waits for views
};

}  // namespace ew
