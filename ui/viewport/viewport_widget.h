// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QOpenGLWidget>
#include <memory>
#include <optional>

#include "core/document/document.h"
#include "ui/viewport/ghost_overlay.h"

namespace ew {

class Appearance;
class LiveReading;

/// A shape that is not the document's (yet).
struct ShapePreview {
    std::shared_ptr<const DerivedShape> shape;
    bool hurried = false;  ///< the next one is expected soon; drawn roughly where that is faster
    std::vector<Body> bodies = {};  ///< that it is the shape of; empty: the document's
};

/// The drawing surface: the scene by VTK, ink and reading by QPainter on top. Shows a document; it
/// changes it only by telling it the viewport's size. Pointer input is someone else's business.
class ViewportWidget : public QOpenGLWidget {
    Q_OBJECT

  public:
    ViewportWidget(Document& document, LiveReading& reading, Appearance& appearance,
                   QWidget* parent = nullptr);
    ~ViewportWidget() override;

    /// The stroke under way in view px, null where there is none; must outlive its being set.
    void setWetStroke(const Stroke* stroke);
    /// Where the pen hovers [px]; a ring of the distance threshold is drawn round it.
    void setHover(std::optional<Vec2> position, bool eraser = false);
    std::optional<Vec2> hover() const;

    bool gridVisible() const;
    bool hiddenEdgesVisible() const;
    bool readingVisible() const;
    bool occlusionVisible() const;
    bool cageVisible() const;

    /// Shows another shape than the document's own, or other bodies; nothing: its own
    /// again. Gone as soon as the document's shape changes.
    void setPreview(std::optional<ShapePreview> preview);
    /// What is shown: the preview or, without one, the document's own shape.
    std::shared_ptr<const DerivedShape> shownShape() const;
    /// The view is being turned or moved by hand: frames may be rough till it rests.
    void setMoving(bool on);
    /// Edges that are marked as chosen.
    void setChosenEdges(const std::vector<EdgeRef>& edges);

    /// Strokes to trace; nothing: none.
    void setGhost(std::optional<Ghost> ghost);

    /// Time that the newest frame took in this widget, without the swap [ms].
    double lastFrameMs() const;

  public slots:
    void setGridVisible(bool on);
    void setHiddenEdgesVisible(bool on);
    void setReadingVisible(bool on);
    void setOcclusionVisible(bool on);
    void setCageVisible(bool on);

  signals:
    /// After the first picture that shows everything was made.
    void firstFrame();

  protected:
    void initializeGL() override;
    void resizeGL(int width, int height) override;
    void paintGL() override;
    void resizeEvent(QResizeEvent* event) override;

  private:
    void onDocumentChanged(DocumentChange what);
    void claimCamera();
    /// Scene, ink and reading, where one of them looks different now.
    void paintStill();
    void copyStill();
    bool updateOverlay(const OrthographicCamera& view);
    void releaseGL();
    void showShape();

    struct Private;
    std::unique_ptr<Private> d_;
};

}  // namespace ew
