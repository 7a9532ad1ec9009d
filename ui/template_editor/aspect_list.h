// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QListWidget>

#include "core/tlib/aspect_facts.h"
#include "core/tlib/library.h"

namespace ew {

class Appearance;

/// The views of a template as small Edge Graphs, those of cuts below those of the whole, with the
/// share of sides from which each is seen and who else shows it.
class AspectList : public QListWidget {
    Q_OBJECT

  public:
    explicit AspectList(Appearance& appearance, QWidget* parent = nullptr);

    /// \param others  for the names of those who show the same.
    void show(const std::vector<AspectFacts>& aspects, const TemplateLibrary& others);
    const std::vector<AspectFacts>& aspects() const { return aspects_; }

  signals:
    /// A view is pointed at: the shape may be seen along this direction.
    void lookedAt(const ew::Vec3& direction);

  private:
    void refresh();
    void addHeading(const QString& text);
    void addRemark(const QString& text);
    void addAspect(std::size_t index, const TemplateLibrary& others);

    Appearance& appearance_;
    std::vector<AspectFacts> aspects_;
    TemplateLibrary others_;
};

/// An aspect as a small drawing: its lines, and its corners as dots.
QPixmap aspectPicture(const Aspect& aspect, const QSize& size, double devicePixelRatio,
                      const QColor& line);

}  // namespace ew
