// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>
#include <optional>
#include <vector>

#include "core/base/camera.h"
#include "core/tlib/template.h"

namespace ew {

class Appearance;

/// The shape of a template: turned by dragging or with the arrow keys; vertices and edges are
/// picked by a click; edges of a rule are lit.
class ShapeView : public QWidget {
    Q_OBJECT

  public:
    explicit ShapeView(Appearance& appearance, QWidget* parent = nullptr);

    /// Keeps the direction of view.
    void setShape(const PolyhedronSpec& shape);
    void setLit(const std::vector<TemplateEdge>& edges);
    /// Turns it so that it is seen along a direction.
    void lookAlong(const Vec3& direction);

    int pickedVertex() const { return vertex_; }
    std::optional<TemplateEdge> pickedEdge() const { return edge_; }
    void pickNothing();

    const OrthographicCamera& camera() const { return camera_; }
    QSize sizeHint() const override { return {380, 380}; }
    QSize minimumSizeHint() const override { return {220, 200}; }

  signals:
    /// A vertex, an edge, or nothing.
    void picked();

  protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

  private:
    void fit();
    /// The direction, of those from above and in front, that shows all corners well apart.
    Vec3 clearDirection() const;
    void turn(const QPointF& by);
    void pickAt(const QPointF& at);
    QPointF place(int vertex) const;
    void drawEdge(QPainter& painter, const TemplateEdge& edge, const QPen& pen) const;
    void drawVertices(QPainter& painter) const;

    Appearance& appearance_;
    PolyhedronSpec shape_;
    std::vector<TemplateEdge> edges_;
    std::vector<TemplateEdge> lit_;
    OrthographicCamera camera_;
    int vertex_ = -1;
    std::optional<TemplateEdge> edge_;
    QPointF pressedAt_;
    QPointF lastAt_;
    bool turning_ = false;
};

}  // namespace ew
