// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vtkOpenGLPolyDataMapper.h>

namespace ew {

/// Draws only what lies behind something that is already drawn: the depth test the other way
/// round. Add its actor to the renderer after the faces.
class HiddenLineMapper : public vtkOpenGLPolyDataMapper {
  public:
    static HiddenLineMapper* New();

    void RenderPiece(vtkRenderer* renderer, vtkActor* actor) override;

    vtkTypeMacro(HiddenLineMapper, vtkOpenGLPolyDataMapper)

        protected : HiddenLineMapper() = default;
    ~HiddenLineMapper() override = default;

  private:
    HiddenLineMapper(const HiddenLineMapper&) = delete;
    void operator=(const HiddenLineMapper&) = delete;
};

}  // namespace ew
