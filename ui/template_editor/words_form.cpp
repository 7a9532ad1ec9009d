// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/template_editor/words_form.h"

#include <QAction>
#include <QComboBox>
#include <QCompleter>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QRegularExpression>
#include <QRegularExpressionValidator>
#include <QSignalBlocker>
#include <algorithm>
#include <set>

#include "core/document/template_id.h"
#include "ui/theme/colours.h"
#include "ui/theme/themed_icon.h"

namespace ew {

namespace {

constexpr int kLongestName = 80;
constexpr int kLongestId = 64;
constexpr int kLongestText = 160;  // 500 bytes of any script hold it
// Steps of one field are one; the numbers only tell the fields apart.
enum Field {
    Name,
    Id,
    Description,
    Category,
    Tags,
    Author,
    Licence,
    Version,
    OtherName,
    OtherText
};

/// Languages that are proposed; any other code can be typed.
constexpr const char* kLanguages[] = {"de", "es", "fr", "it", "ja", "ko",
                                      "nl", "pl", "pt", "ru", "tr", "zh"};

/// A caret at the end of a text that is set anew would jump while one types inside it.
void setText(QLineEdit* line, const QString& text) {
    if (line->text() == text) return;
    const QSignalBlocker quiet(line);
    line->setText(text);
}

std::vector<std::string> tagsOf(const QString& typed) {
    std::vector<std::string> tags;
    for (const QString& part : typed.split(',')) {
        const std::string tag = part.trimmed().toStdString();
        const bool known = std::find(tags.begin(), tags.end(), tag) != tags.end();
        if (!tag.empty() && !known) tags.push_back(tag);
    }
    return tags;
}

}  // namespace

// WordsForm ---------------------------------------------------------------------------------------

WordsForm::WordsForm(TemplateModel& model, const TemplateLibrary& others, QWidget* parent)
    : QWidget(parent), model_(model) {
    auto* form = new QFormLayout(this);
    form->setContentsMargins(metrics::kSpace, metrics::kSpace, metrics::kSpace, metrics::kSpace);
    form->setFieldGrowthPolicy(QFormLayout::AllNonFixedFieldsGrow);
    addLine(form, tr("D&escription"), QStringLiteral("templateDescription"), Description,
            tr("Describe"), [](Template& t) -> std::string& { return t.description; });
    QLineEdit* category =
        addLine(form, tr("Categor&y"), QStringLiteral("templateCategory"), Category,
                tr("Set category"), [](Template& t) -> std::string& { return t.about.category; });
    QStringList categories;
    for (std::size_t i = 0; i < others.size(); ++i) {
        categories << QString::fromStdString(others.at(i).about.category);
    }
    categories.removeDuplicates();
    categories.removeAll(QString());
    category->setCompleter(new QCompleter(categories, category));
    tags_ = new QLineEdit(this);
    tags_->setObjectName(QStringLiteral("templateTags"));
    tags_->setMaxLength(kLongestText);
    tags_->setPlaceholderText(tr("separated by commas"));
    connect(tags_, &QLineEdit::textEdited, this, [this](const QString& typed) {
        model_.setWords(Tags, tr("Set tags"), [&](Template& t) { t.about.tags = tagsOf(typed); });
    });
    form->addRow(tr("&Tags"), tags_);
    addLine(form, tr("Auth&or"), QStringLiteral("templateAuthor"), Author, tr("Set author"),
            [](Template& t) -> std::string& { return t.about.author; });
    QLineEdit* licence =
        addLine(form, tr("&Licence"), QStringLiteral("templateLicence"), Licence, tr("Set licence"),
                [](Template& t) -> std::string& { return t.about.licence; });
    licence->setCompleter(new QCompleter(
        {QStringLiteral("CC0-1.0"), QStringLiteral("CC-BY-4.0"), QStringLiteral("CC-BY-SA-4.0")},
        licence));
    addLine(form, tr("Versio&n"), QStringLiteral("templateVersion"), Version, tr("Set version"),
            [](Template& t) -> std::string& { return t.about.version; });
    buildLanguage(form);
    connect(&model, &TemplateModel::changed, this, [this](DraftChange what) {
        if (what.words) refresh();
    });
    refresh();
}

QLineEdit* WordsForm::addLine(QFormLayout* form, const QString& label, const QString& objectName,
                              int field, const QString& step, const Text& text) {
    auto* line = new QLineEdit(this);
    line->setObjectName(objectName);
    line->setMaxLength(kLongestText);
    form->addRow(label, line);
    connect(line, &QLineEdit::textEdited, this, [this, field, step, text](const QString& typed) {
        model_.setWords(field, step, [&](Template& t) { text(t) = typed.trimmed().toStdString(); });
    });
    lines_.emplace_back(line, text);
    return line;
}

void WordsForm::buildLanguage(QFormLayout* form) {
    auto* heading = new QLabel(tr("In another language"), this);
    QFont bold = font();
    bold.setBold(true);
    heading->setFont(bold);
    heading->setContentsMargins(0, metrics::kMargin, 0, 0);
    form->addRow(heading);
    language_ = new QComboBox(this);
    language_->setObjectName(QStringLiteral("templateLanguage"));
    std::set<std::string> codes(std::begin(kLanguages), std::end(kLanguages));
    for (const auto& [code, words] : model_.draft().tmpl.about.inLanguage) codes.insert(code);
    for (const std::string& code : codes) {
        const QString word = QString::fromStdString(code);
        language_->addItem(QStringLiteral("%1 (%2)").arg(QLocale(word).nativeLanguageName(), word),
                           word);
    }
    // The window's own language first, unless it is the one that the name is in.
    const int own = language_->findData(QLocale().name().section('_', 0, 0));
    language_->setCurrentIndex(std::max(own, 0));
    form->addRow(tr("Lan&guage"), language_);
    languageName_ = new QLineEdit(this);
    languageName_->setObjectName(QStringLiteral("templateLanguageName"));
    languageName_->setMaxLength(kLongestName);
    form->addRow(tr("Name there"), languageName_);
    languageDescription_ = new QLineEdit(this);
    languageDescription_->setObjectName(QStringLiteral("templateLanguageDescription"));
    languageDescription_->setMaxLength(kLongestText);
    form->addRow(tr("Description there"), languageDescription_);
    connect(language_, &QComboBox::currentIndexChanged, this, &WordsForm::refresh);
    connect(languageName_, &QLineEdit::textEdited, this, [this](const QString& typed) {
        setLanguageWords(OtherName, tr("Translate name"), &TemplateWords::name, typed);
    });
    connect(languageDescription_, &QLineEdit::textEdited, this, [this](const QString& typed) {
        setLanguageWords(OtherText, tr("Translate description"), &TemplateWords::description,
                         typed);
    });
}

std::string WordsForm::language() const {
    return language_->currentData().toString().toStdString();
}

void WordsForm::setLanguageWords(int field, const QString& step, std::string TemplateWords::*member,
                                 const QString& typed) {
    // Each language has its fields of its own.
    const int own = field + 100 * (language_->currentIndex() + 1);
    model_.setWords(own, step, [&](Template& t) {
        TemplateWords& words = t.about.inLanguage[language()];
        words.*member = typed.trimmed().toStdString();
        if (words == TemplateWords{}) t.about.inLanguage.erase(language());
    });
}

void WordsForm::refresh() {
    Template t = model_.draft().tmpl;
    for (const auto& [line, text] : lines_) {
        // What is being typed may end in a space, which does not count yet.
        if (line->text().trimmed().toStdString() != text(t)) {
            setText(line, QString::fromStdString(text(t)));
        }
    }
    if (tagsOf(tags_->text()) != t.about.tags) {
        QStringList words;
        for (const std::string& tag : t.about.tags) words << QString::fromStdString(tag);
        setText(tags_, words.join(QStringLiteral(", ")));
    }
    const auto known = t.about.inLanguage.find(language());
    const TemplateWords words = known == t.about.inLanguage.end() ? TemplateWords{} : known->second;
    const auto show = [](QLineEdit* line, const std::string& text) {
        if (line->text().trimmed().toStdString() != text) {
            setText(line, QString::fromStdString(text));
        }
    };
    show(languageName_, words.name);
    show(languageDescription_, words.description);
}

// NameForm ----------------------------------------------------------------------------------------

NameForm::NameForm(TemplateModel& model, TemplateLibrary others, bool fixedId, QWidget* parent)
    : QWidget(parent),
      model_(model),
      others_(std::move(others)),
      name_(new QLineEdit(this)),
      id_(new QLineEdit(this)),
      nameMark_(
          name_->addAction(themedIcon(QStringLiteral("warning")), QLineEdit::TrailingPosition)),
      idMark_(id_->addAction(themedIcon(QStringLiteral("warning")), QLineEdit::TrailingPosition)) {
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(metrics::kSpace);
    const auto add = [&](const QString& text, QLineEdit* line, int stretch) {
        auto* label = new QLabel(text, this);
        label->setBuddy(line);
        row->addWidget(label);
        row->addWidget(line, stretch);
    };
    add(tr("Na&me"), name_, 3);
    add(tr("&Id"), id_, 2);
    name_->setObjectName(QStringLiteral("templateName"));
    name_->setMaxLength(kLongestName);
    name_->setPlaceholderText(tr("what people call it"));
    id_->setObjectName(QStringLiteral("templateId"));
    id_->setMaxLength(kLongestId);
    id_->setValidator(
        new QRegularExpressionValidator(QRegularExpression(QStringLiteral("[a-z0-9-]*")), this));
    id_->setReadOnly(fixedId);
    id_->setToolTip(fixedId ? tr("A template that is in use keeps its id.")
                            : tr("Names the template in files and scripts: small letters, digits "
                                 "and hyphens."));
    const auto taken = [this](const std::string& id) { return others_.find(id) >= 0; };
    connect(name_, &QLineEdit::textEdited, this, [this, taken, fixedId](const QString& typed) {
        model_.setWords(Name, tr("Name"), [&](Template& t) {
            const std::string before = idFromName(t.name);
            const bool follows = t.id.empty() || t.id == before || t.id == freeId(before, taken);
            t.name = typed.trimmed().toStdString();
            if (fixedId || !follows) return;
            const std::string wanted = idFromName(t.name);
            t.id = wanted.empty() ? wanted : freeId(wanted, taken);
        });
    });
    connect(id_, &QLineEdit::textEdited, this, [this](const QString& typed) {
        model_.setWords(Id, tr("Set id"), [&](Template& t) { t.id = typed.toStdString(); });
    });
    connect(&model, &TemplateModel::changed, this, [this](DraftChange what) {
        if (what.words) refresh();
    });
    refresh();
}

void NameForm::setFaults(const std::vector<DraftFault>& faults) {
    const auto mark = [&](QAction* action, DraftFault::Place place) {
        const auto fault = std::find_if(faults.begin(), faults.end(),
                                        [place](const auto& f) { return f.place == place; });
        action->setVisible(fault != faults.end());
        action->setToolTip(fault != faults.end() ? fault->text : QString());
    };
    mark(nameMark_, DraftFault::Place::Name);
    mark(idMark_, DraftFault::Place::Id);
}

void NameForm::refresh() {
    const Template& t = model_.draft().tmpl;
    if (name_->text().trimmed().toStdString() != t.name) {
        setText(name_, QString::fromStdString(t.name));
    }
    setText(id_, QString::fromStdString(t.id));
}

}  // namespace ew
