// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <vector>

#include "core/base/camera.h"
#include "core/solid/solid.h"
#include "ui/theme/colours.h"

class vtkRenderer;

namespace ew {

/// What VTK draws: flat-shaded bodies with crisp edges (edges between planar faces only, never
/// what triangulation brought in), hidden edges dashed on demand, a quiet ground grid under
/// everything. A setter that changes nothing costs nothing and does not ask for a new picture.
class Scene {
  public:
    Scene();
    ~Scene();
    Scene(const Scene&) = delete;
    Scene& operator=(const Scene&) = delete;

    void setBodies(const std::vector<Body>& bodies);
    void setCamera(const OrthographicCamera& camera);
    void setColours(const ThemeColours& colours);
    void setGridVisible(bool on);
    void setHiddenEdgesVisible(bool on);
    /// Device pixels per logical pixel, for line widths.
    void setScale(double devicePixelRatio);

    vtkRenderer* renderer() const;

    /// True once after something changed that is seen.
    bool takeChanged();

  private:
    struct Private;
    std::unique_ptr<Private> d_;
};

}  // namespace ew
