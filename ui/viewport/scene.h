// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QRectF>
#include <memory>
#include <vector>

#include "core/base/camera.h"
#include "core/document/derived_shape.h"
#include "ui/theme/colours.h"

class vtkRenderer;

namespace ew {

/// What VTK draws: flat-shaded solids and filleted cages with crisp edges (edges between planar
/// faces only, never what triangulation brought in), surfaces with their smooth normals and their
/// creases, strokes on them, hidden edges dashed and the cage over the surface on demand, a quiet
/// ground grid under everything. Ambient occlusion on demand. A setter that changes nothing costs
/// nothing and does not ask for a new picture.
class Scene {
  public:
    Scene();
    ~Scene();
    Scene(const Scene&) = delete;
    Scene& operator=(const Scene&) = delete;

    /// \param shape  of these bodies.
    /// \param mapped  the strokes that shape->curves speak of.
    void setShape(const std::vector<Body>& bodies, std::shared_ptr<const DerivedShape> shape,
                  const std::vector<MappedStroke>& mapped);
    /// Edges of the bodies that are marked as chosen; unknown ones are left out.
    void setChosen(const std::vector<EdgeRef>& edges);
    /// Shows the cage over surfaces.
    void setCageVisible(bool on);
    /// Draws only this part of the camera's viewport [px]; an empty one: all of it.
    void setTile(const QRectF& tile);
    /// Nothing behind the bodies, not even the grid.
    void setTransparent(bool on);
    void setCamera(const OrthographicCamera& camera);
    void setColours(const ThemeColours& colours);
    void setGridVisible(bool on);
    void setHiddenEdgesVisible(bool on);
    /// Ambient occlusion: corners and hollows are darker, as under an even sky.
    /// \param samples  a pixel, the more the smoother and the slower; 0: off.
    void setOcclusion(int samples);
    /// Device pixels per logical pixel, for line widths.
    void setScale(double devicePixelRatio);

    vtkRenderer* renderer() const;

    /// True once after something changed that is seen.
    bool takeChanged();
    /// Would takeChanged() be true?
    bool changed() const;

  private:
    struct Private;
    std::unique_ptr<Private> d_;
};

}  // namespace ew
