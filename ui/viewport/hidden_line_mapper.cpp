// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewport/hidden_line_mapper.h"

#include <QtGui/qopengl.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLState.h>
#include <vtkRenderer.h>

namespace ew {

HiddenLineMapper* HiddenLineMapper::New() {
    auto* mapper = new HiddenLineMapper;
    mapper->InitializeObjectBase();
    return mapper;
}

void HiddenLineMapper::RenderPiece(vtkRenderer* renderer, vtkActor* actor) {
    auto* window = vtkOpenGLRenderWindow::SafeDownCast(renderer->GetRenderWindow());
    if (window == nullptr) return;
    vtkOpenGLState* state = window->GetState();
    // Nothing drawn so means nothing hidden by it: depth is read, not written.
    state->vtkglDepthFunc(GL_GREATER);
    state->vtkglDepthMask(GL_FALSE);
    vtkOpenGLPolyDataMapper::RenderPiece(renderer, actor);
    state->vtkglDepthMask(GL_TRUE);
    state->vtkglDepthFunc(GL_LEQUAL);
}

}  // namespace ew
