// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lesson/join_dialog.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QFileDialog>
#include <QFormLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QVBoxLayout>

#include "core/document/classroom/class_overview.h"
#include "ui/theme/appearance.h"

namespace ew {

namespace {
constexpr int kWidth = 520;
}

JoinDialog::JoinDialog(Appearance& appearance, const QString& folder, QWidget* parent)
    : QDialog(parent),
      appearance_(appearance),
      folder_(new QLineEdit(folder, this)),
      pupil_(new QComboBox(this)),
      problem_(new QLabel(this)) {
    setWindowTitle(tr("Work in a class"));
    auto* layout = new QVBoxLayout(this);
    auto* about = new QLabel(tr("What you do in lessons is kept in the class folder under your "
                                "name, for your teacher to see. There is no account and no "
                                "password."),
                             this);
    about->setWordWrap(true);
    layout->addWidget(about);
    layout->addSpacing(metrics::kSpace);
    auto* form = new QFormLayout;
    auto* place = new QHBoxLayout;
    folder_->setObjectName(QStringLiteral("classFolder"));
    folder_->setPlaceholderText(tr("A share, or a folder on a stick"));
    auto* browse = new QPushButton(tr("&Browse\u2026"), this);
    browse->setAutoDefault(false);
    place->addWidget(folder_, 1);
    place->addWidget(browse);
    auto* folderLabel = new QLabel(tr("Class &folder:"), this);
    folderLabel->setBuddy(folder_);
    form->addRow(folderLabel, place);
    pupil_->setObjectName(QStringLiteral("classPupil"));
    pupil_->setEditable(true);
    pupil_->setInsertPolicy(QComboBox::NoInsert);
    pupil_->lineEdit()->setPlaceholderText(tr("First name, or as your teacher says"));
    auto* pupilLabel = new QLabel(tr("Your &name:"), this);
    pupilLabel->setBuddy(pupil_);
    form->addRow(pupilLabel, pupil_);
    layout->addLayout(form);
    problem_->setObjectName(QStringLiteral("classProblem"));
    problem_->setWordWrap(true);
    problem_->setTextFormat(Qt::PlainText);
    layout->addWidget(problem_);
    layout->addStretch(1);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
    join_ = buttons->addButton(tr("&Work here"), QDialogButtonBox::AcceptRole);
    join_->setObjectName(QStringLiteral("classJoin"));
    join_->setDefault(true);
    layout->addWidget(buttons);
    connect(browse, &QPushButton::clicked, this, &JoinDialog::browse);
    connect(folder_, &QLineEdit::editingFinished, this, &JoinDialog::listPupils);
    connect(folder_, &QLineEdit::textChanged, this, &JoinDialog::refresh);
    connect(pupil_, &QComboBox::editTextChanged, this, &JoinDialog::refresh);
    connect(buttons, &QDialogButtonBox::accepted, this, &JoinDialog::joinWanted);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
    setMinimumWidth(kWidth);
    listPupils();
    if (!folder.isEmpty()) pupil_->setFocus();
    refresh();
}

QString JoinDialog::folder() const { return folder_->text().trimmed(); }

QString JoinDialog::pupil() const { return pupil_->currentText(); }

void JoinDialog::browse() {
    const QString chosen = QFileDialog::getExistingDirectory(this, tr("Class folder"), folder());
    if (chosen.isEmpty()) return;
    folder_->setText(chosen);
    listPupils();
    pupil_->setFocus();
}

/// The name that is typed already stays.
void JoinDialog::listPupils() {
    if (folder() == listed_) return;
    listed_ = folder();
    const QString typed = pupil();
    const QSignalBlocker quiet(pupil_);
    pupil_->clear();
    if (const auto names = pupilNames(listed_)) {
        for (const QString& name : *names) pupil_->addItem(name);
    }
    pupil_->setCurrentIndex(-1);
    pupil_->setEditText(typed);
}

void JoinDialog::showProblem(const QString& text) {
    problem_->setText(text);
    QPalette palette = problem_->palette();
    palette.setColor(QPalette::WindowText, appearance_.colours().warning);
    problem_->setPalette(palette);
}

void JoinDialog::refresh() {
    problem_->clear();
    join_->setEnabled(!folder().isEmpty() && !pupil().trimmed().isEmpty());
}

}  // namespace ew
