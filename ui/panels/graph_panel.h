// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

class QLabel;

namespace ew {

class Appearance;
class GraphView;
class LiveReading;

/// The Edge Graph with a heading that names template, aspect and score.
/// \paper{7.4}
class GraphPanel : public QWidget {
    Q_OBJECT

  public:
    GraphPanel(LiveReading& reading, Appearance& appearance, QWidget* parent = nullptr);

  private:
    void refresh();

    LiveReading& reading_;
    QLabel* heading_;
    QLabel* detail_;
};

/// "3 faces seen" out of "explicit-3"; the aspect itself where it is another kind.
QString aspectText(const std::string& aspect);

}  // namespace ew
