// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dialogs/template_dialog.h"

#include <QDialogButtonBox>
#include <QFormLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QRegularExpression>
#include <QRegularExpressionValidator>
#include <QVBoxLayout>

#include "ui/theme/colours.h"

namespace ew {

namespace {
constexpr int kLongestId = 64;
}

QString TemplateDialog::idFromName(const QString& name) {
    QString id;
    for (const QChar c : name.normalized(QString::NormalizationForm_KD).toLower()) {
        const bool plain = (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9');
        if (plain) {
            id += c;
        } else if (c.category() != QChar::Mark_NonSpacing && !id.isEmpty() && !id.endsWith('-')) {
            id += '-';
        }
    }
    id.truncate(kLongestId);
    while (id.endsWith('-')) id.chop(1);
    return id;
}

TemplateDialog::TemplateDialog(TemplateLibrary library, QWidget* parent)
    : QDialog(parent),
      library_(std::move(library)),
      name_(new QLineEdit(this)),
      id_(new QLineEdit(this)),
      problem_(new QLabel(this)),
      buttons_(new QDialogButtonBox(QDialogButtonBox::Ok | QDialogButtonBox::Cancel, this)) {
    setWindowTitle(tr("Add solid as template"));
    auto* layout = new QVBoxLayout(this);
    layout->setSpacing(metrics::kMargin);
    auto* text =
        new QLabel(tr("Drawings of this shape, in any proportion, will be read as it."), this);
    text->setWordWrap(true);
    layout->addWidget(text);
    auto* form = new QFormLayout;
    form->addRow(tr("&Name"), name_);
    form->addRow(tr("&Id"), id_);
    layout->addLayout(form);
    problem_->setForegroundRole(QPalette::BrightText);
    problem_->setMinimumHeight(problem_->fontMetrics().height());
    layout->addWidget(problem_);
    layout->addWidget(buttons_);
    buttons_->button(QDialogButtonBox::Ok)->setText(tr("Add"));
    name_->setMaxLength(80);
    id_->setMaxLength(kLongestId);
    id_->setValidator(
        new QRegularExpressionValidator(QRegularExpression(QStringLiteral("[a-z0-9-]*")), this));
    id_->setToolTip(
        tr("Names the template in files and scripts: small letters, digits and hyphens."));
    setMinimumWidth(380);
    connect(name_, &QLineEdit::textEdited, this, [this](const QString& typed) {
        if (!ownId_) id_->setText(idFromName(typed));
        check();
    });
    connect(id_, &QLineEdit::textEdited, this, [this](const QString& typed) {
        ownId_ = !typed.isEmpty();
        check();
    });
    connect(buttons_, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons_, &QDialogButtonBox::rejected, this, &QDialog::reject);
    check();
}

QString TemplateDialog::name() const { return name_->text().trimmed(); }
QString TemplateDialog::id() const { return id_->text(); }

void TemplateDialog::check() {
    const bool taken = library_.find(id().toStdString()) >= 0;
    problem_->setText(taken ? tr("There is a template with this id already.") : QString());
    buttons_->button(QDialogButtonBox::Ok)
        ->setEnabled(!name().isEmpty() && !id().isEmpty() && !taken);
}

}  // namespace ew
