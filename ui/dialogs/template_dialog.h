// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDialog>

#include "core/tlib/library.h"

class QDialogButtonBox;
class QLabel;
class QLineEdit;

namespace ew {

/// Asks for the name and the id of a new template; only ids that are free and well-formed pass.
class TemplateDialog : public QDialog {
    Q_OBJECT

  public:
    explicit TemplateDialog(TemplateLibrary library, QWidget* parent = nullptr);

    QString name() const;
    QString id() const;

    /// "House with a roof" -> "house-with-a-roof"; only [a-z0-9-], at most 64.
    static QString idFromName(const QString& name);

  private:
    void check();

    TemplateLibrary library_;
    QLineEdit* name_;
    QLineEdit* id_;
    QLabel* problem_;
    QDialogButtonBox* buttons_;
    bool ownId_ = false;  // typed by the person
};

}  // namespace ew
