// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>

#include "core/document/history_change.h"

class QFormLayout;
class QLabel;
class QListWidget;
class QPushButton;

namespace ew {

class Appearance;
class NumberBox;
class WholeNumberBox;

/// Asks how a step of the history shall be: of an apply, which reading and with which thresholds;
/// of a fillet, its radius; of a crease, its sharpness; of a surface, its levels.
class StepDialog : public QDialog {
    Q_OBJECT

  public:
    /// \param file  the document; outlives the dialog.
    /// \param step  what the step was recorded as; canShow() is true of it.
    StepDialog(const DocumentFile& file, const TemplateLibrary& library, int place,
               const RecordedStep& step, Appearance& appearance, QWidget* parent = nullptr);

    /// Is there something in a step that this dialog can change?
    static bool canShow(const ScriptStep& step);
    /// What was asked for.
    StepChange change() const;

  private:
    void show(const ApplyStep& step);
    void show(const FilletStep& step);
    void show(const CreaseStep& step);
    void show(const SubdivideStep& step);
    void read();
    void fillReadings(const Interpretation& reading);
    Thresholds wantedThresholds() const;
    NumberBox* number(const QString& name, double value, double least, double most,
                      const QString& unit);

    const DocumentFile& file_;
    const TemplateLibrary& library_;
    int place_;
    RecordedStep step_;
    Appearance& appearance_;
    QFormLayout* form_;
    QLabel* problem_;
    QPushButton* accept_;
    QListWidget* readings_ = nullptr;
    NumberBox* distance_ = nullptr;
    NumberBox* angle_ = nullptr;
    NumberBox* factor_ = nullptr;
    NumberBox* value_ = nullptr;       ///< radius, sharpness or tolerance
    WholeNumberBox* count_ = nullptr;  ///< segments or levels
};

}  // namespace ew
