// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QListWidget>
#include <optional>

#include "ui/template_editor/template_model.h"
#include "ui/template_editor/template_report.h"

namespace ew {

/// The relations found in the shape, to tick; what is ticked is a rule that every instance keeps.
/// The one that is pointed at, by the mouse or by the keys, is told, so that its edges can be lit.
class RuleList : public QListWidget {
    Q_OBJECT

  public:
    explicit RuleList(TemplateModel& model, QWidget* parent = nullptr);

    /// Says of each rule whether it is broken or follows from the others.
    void setReport(const DraftReport& report);
    /// Rules with this edge stand out.
    void setMarkedEdge(const std::optional<TemplateEdge>& edge);

  signals:
    /// -1: none is pointed at.
    void pointedAt(int rule);

  protected:
    void leaveEvent(QEvent* event) override;

  private:
    void refresh();
    void restyle();

    TemplateModel& model_;
    DraftReport report_;
    std::optional<TemplateEdge> marked_;
};

/// A relation for people: "Parallel: 0\u20133, 1\u20134".
QString ruleText(const FoundRelation& relation);

}  // namespace ew
