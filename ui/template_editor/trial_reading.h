// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QObject>
#include <QSizeF>
#include <QThreadPool>

#include "core/reading/types/interpretation.h"
#include "ui/template_editor/template_checker.h"
#include "ui/template_editor/template_model.h"

namespace ew {

/// What the strokes that were drawn to try a template are read as, by the draft and all other
/// templates in use, in free space. It is read on another thread after each change; what is older
/// than the newest change is dropped.
class TrialReading : public QObject {
    Q_OBJECT

  public:
    /// \param checker  tells whether the draft can be used.
    TrialReading(TemplateModel& model, TemplateChecker& checker, QObject* parent = nullptr);
    ~TrialReading() override;

    const Interpretation& reading() const { return reading_; }
    /// What the canvas shows: its Sketch Plane.
    const OrthographicCamera& camera() const { return camera_; }
    void setCanvasSize(const QSizeF& size);
    /// The draft among the candidates of reading(); -1 where it is none of them.
    int candidate() const;
    /// Is the draft what a person would get without choosing?
    bool isAccepted() const;
    bool upToDate() const { return !busy_; }
    /// Waits until it is.
    void settle();

    /// What became of the draft, in a sentence of the window's language.
    QString sentence() const;

  signals:
    void changed();

  private:
    void ask();
    void start();
    void take(Interpretation reading, long revision);

    TemplateModel& model_;
    TemplateChecker& checker_;
    OrthographicCamera camera_;
    Interpretation reading_;
    std::string id_;  ///< of the draft when it was read
    long revision_ = 0;
    bool busy_ = false;
    bool again_ = false;
    QThreadPool thread_;  ///< one
};

}  // namespace ew
