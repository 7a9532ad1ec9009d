// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>
#include <array>
#include <functional>
#include <memory>

#include "core/document/document.h"
#include "ui/template_editor/template_checker.h"
#include "ui/template_editor/template_model.h"
#include "ui/template_editor/trial_reading.h"

class QLabel;
class QLineEdit;
class QPushButton;
class QTabWidget;
class QVBoxLayout;

namespace ew {

class Appearance;
class AspectList;
class ConfusionRun;
class FaultList;
class NameForm;
class NumberBox;
class RuleList;
class ShapeView;
class TrialPage;

/// Makes or changes a template: its shape, the views that it can be drawn from, the rules that all
/// its instances keep, what is said about it, and a sheet to try it on. Nothing of the document
/// changes before it is saved; that is one step of the document.
class TemplateEditor : public QDialog {
    Q_OBJECT

  public:
    enum class Answer { Save, Discard, Stay };

    /// \param start     what is edited at first.
    /// \param replaces  `start` is a template of the document's own, and saving changes it; else
    ///     saving adds one.
    TemplateEditor(Document& document, Appearance& appearance, Template start, bool replaces,
                   QWidget* parent = nullptr);
    ~TemplateEditor() override;

    TemplateModel& model() { return *model_; }
    TemplateChecker& checker() { return *checker_; }
    TrialReading& trial() { return *trial_; }
    ConfusionRun& confusion() { return *confusion_; }
    ShapeView& shapeView() { return *shape_; }
    TrialPage& trialPage() { return *trialPage_; }
    /// What a person is asked when something would be lost; by a message box unless a test asks.
    void setQuestion(std::function<Answer()> question) { question_ = std::move(question); }

    /// False where it cannot be used as it is, which the window says.
    bool save();
    /// Closes, after asking where something would be lost.
    void reject() override;

  signals:
    /// The document has it now.
    void saved(const QString& name);

  protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

  private:
    void buildTop(QVBoxLayout* layout);
    QWidget* buildShapePage();
    QWidget* buildViews();
    QWidget* buildRight();
    QWidget* buildButtons();
    void connectParts();
    void takeShape(Result<Template> from);
    void showPicked();
    void showRule(int rule);
    void showReport();
    void showAspects();
    void mend(const DraftFault& fault);
    Answer ask();

    Document& document_;
    Appearance& appearance_;
    bool replaces_;
    TemplateModel* model_;
    TemplateChecker* checker_;
    TrialReading* trial_;
    ConfusionRun* confusion_;
    std::function<Answer()> question_;
    NameForm* names_ = nullptr;
    ShapeView* shape_ = nullptr;
    QLabel* pickedText_ = nullptr;
    std::array<NumberBox*, 3> place_{};
    QTabWidget* left_ = nullptr;
    TrialPage* trialPage_ = nullptr;
    AspectList* aspects_ = nullptr;
    QLabel* aspectText_ = nullptr;
    RuleList* rules_ = nullptr;
    QLabel* freedoms_ = nullptr;
    FaultList* faults_ = nullptr;
    QPushButton* save_ = nullptr;
    QString refused_;  ///< why it could not be saved or taken, until the draft changes
};

}  // namespace ew
