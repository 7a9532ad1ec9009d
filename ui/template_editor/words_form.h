// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <functional>

#include "core/tlib/library.h"
#include "ui/template_editor/template_model.h"
#include "ui/template_editor/template_report.h"

class QAction;
class QComboBox;
class QFormLayout;
class QLineEdit;

namespace ew {

/// What is said about a template, but for its name and id: description, category, tags, author,
/// licence, version, and name and description in other languages.
class WordsForm : public QWidget {
    Q_OBJECT

  public:
    /// \param others  whose categories are proposed.
    WordsForm(TemplateModel& model, const TemplateLibrary& others, QWidget* parent = nullptr);

  private:
    using Text = std::function<std::string&(Template&)>;
    QLineEdit* addLine(QFormLayout* form, const QString& label, const QString& objectName,
                       int field, const QString& step, const Text& text);
    void buildLanguage(QFormLayout* form);
    void setLanguageWords(int field, const QString& step, std::string TemplateWords::*member,
                          const QString& typed);
    void refresh();
    std::string language() const;

    TemplateModel& model_;
    std::vector<std::pair<QLineEdit*, Text>> lines_;
    QLineEdit* tags_ = nullptr;
    QComboBox* language_ = nullptr;
    QLineEdit* languageName_ = nullptr;
    QLineEdit* languageDescription_ = nullptr;
};

/// Name and id, which a template must have. The id follows the name until somebody writes one.
class NameForm : public QWidget {
    Q_OBJECT

  public:
    NameForm(TemplateModel& model, TemplateLibrary others, bool fixedId, QWidget* parent = nullptr);

    QLineEdit* name() { return name_; }
    /// Marks the fields that are at fault.
    void setFaults(const std::vector<DraftFault>& faults);
    QLineEdit* id() { return id_; }

  private:
    void refresh();

    TemplateModel& model_;
    TemplateLibrary others_;
    QLineEdit* name_;
    QLineEdit* id_;
    QAction* nameMark_;
    QAction* idMark_;
};

}  // namespace ew
