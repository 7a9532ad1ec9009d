// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dialogs/export_dialog.h"

#include <QComboBox>
#include <QDialogButtonBox>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QVBoxLayout>

#include "ui/theme/colours.h"

namespace ew {

namespace {
constexpr ExportUnit kUnits[] = {ExportUnit::Millimetre, ExportUnit::Centimetre, ExportUnit::Metre,
                                 ExportUnit::Inch};
constexpr int kMostRows = 8;
constexpr int kWidth = 380;
}  // namespace

QString exportUnitText(ExportUnit unit) {
    switch (unit) {
        case ExportUnit::Millimetre:
            return ExportDialog::tr("millimetres (mm)");
        case ExportUnit::Centimetre:
            return ExportDialog::tr("centimetres (cm)");
        case ExportUnit::Metre:
            return ExportDialog::tr("metres (m)");
        case ExportUnit::Inch:
            return ExportDialog::tr("inches (in)");
    }
    return {};
}

ExportDialog::ExportDialog(const Questions& questions, QWidget* parent) : QDialog(parent) {
    setWindowTitle(tr("Export"));
    setMinimumWidth(kWidth);
    auto* layout = new QVBoxLayout(this);
    layout->setSpacing(metrics::kSpace);
    auto* buttons = new QDialogButtonBox(QDialogButtonBox::Cancel, this);
    accept_ = buttons->addButton(questions.exports ? tr("&Export") : tr("&Use"),
                                 QDialogButtonBox::AcceptRole);
    accept_->setDefault(true);
    if (questions.unit) {
        auto* label = new QLabel(tr("This kind of file does not say what its numbers are. "
                                    "&Lengths are written in:"),
                                 this);
        label->setWordWrap(true);
        unit_ = new QComboBox(this);
        unit_->setObjectName(QStringLiteral("exportUnit"));
        for (const ExportUnit unit : kUnits) {
            unit_->addItem(exportUnitText(unit), static_cast<int>(unit));
        }
        unit_->setCurrentIndex(unit_->findData(static_cast<int>(*questions.unit)));
        label->setBuddy(unit_);
        auto* hint = new QLabel(
            tr("It is used from now on, and can be changed by File, Export unit."), this);
        hint->setWordWrap(true);
        hint->setForegroundRole(QPalette::PlaceholderText);
        layout->addWidget(label);
        layout->addWidget(unit_);
        layout->addWidget(hint);
    }
    if (questions.bodies.size() > 1) {
        auto* label = new QLabel(tr("&Bodies:"), this);
        bodies_ = new QListWidget(this);
        bodies_->setObjectName(QStringLiteral("exportBodies"));
        label->setBuddy(bodies_);
        for (const QString& name : questions.bodies) {
            auto* item = new QListWidgetItem(name, bodies_);
            item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable | Qt::ItemIsUserCheckable);
            item->setCheckState(Qt::Checked);
        }
        const int rows = std::min(kMostRows, static_cast<int>(questions.bodies.size()));
        bodies_->setFixedHeight(rows * bodies_->sizeHintForRow(0) + 2 * bodies_->frameWidth());
        connect(bodies_, &QListWidget::itemChanged, this, [this] {
            bool any = false;
            for (int i = 0; i < bodies_->count(); ++i) {
                any |= bodies_->item(i)->checkState() == Qt::Checked;
            }
            accept_->setEnabled(any);
        });
        layout->addWidget(label);
        layout->addWidget(bodies_);
    }
    layout->addStretch(1);
    layout->addWidget(buttons);
    connect(buttons, &QDialogButtonBox::accepted, this, &QDialog::accept);
    connect(buttons, &QDialogButtonBox::rejected, this, &QDialog::reject);
}

ExportUnit ExportDialog::unit() const {
    if (unit_ == nullptr) return ExportUnit::Millimetre;
    return static_cast<ExportUnit>(unit_->currentData().toInt());
}

std::vector<int> ExportDialog::bodies() const {
    std::vector<int> chosen;
    if (bodies_ == nullptr) return chosen;
    for (int i = 0; i < bodies_->count(); ++i) {
        if (bodies_->item(i)->checkState() == Qt::Checked) chosen.push_back(i);
    }
    if (static_cast<int>(chosen.size()) == bodies_->count()) chosen.clear();
    return chosen;
}

}  // namespace ew
