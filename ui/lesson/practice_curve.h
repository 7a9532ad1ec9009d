// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <vector>

#include "core/document/practice/practice_log.h"

namespace ew {

class Appearance;

/// How somebody gets on: accuracy, speed and steadiness of the newest exercises, each as a small
/// curve with its newest value.
class PracticeCurve : public QWidget {
    Q_OBJECT

  public:
    explicit PracticeCurve(Appearance& appearance, QWidget* parent = nullptr);

    void setResults(std::vector<PracticeResult> results);
    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }
    /// In words, for those who do not see it: the newest values.
    static QString words(const PracticeResult& result);

  protected:
    void paintEvent(QPaintEvent* event) override;

  private:
    struct Row {
        QString name;
        QString newest;
        std::vector<double> values;
        double least = 0.0;
        double most = 1.0;
    };
    std::vector<Row> rows() const;
    void paintRow(QPainter& painter, const Row& row, const QRect& area) const;

    Appearance& appearance_;
    std::vector<PracticeResult> results_;
};

}  // namespace ew
