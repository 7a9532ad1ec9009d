// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/viewport/frame_renderer.h"

#include <vtkCallbackCommand.h>
#include <vtkCommand.h>
#include <vtkGenericOpenGLRenderWindow.h>
#include <vtkNew.h>
#include <vtkOpenGLState.h>
#include <vtkRenderer.h>

#include <QOpenGLContext>
#include <QOpenGLExtraFunctions>
#include <cmath>

#include "ui/viewport/scene.h"

namespace ew {

namespace {
constexpr int kSamples = 4;          // antialiasing of edges
constexpr double kRoughScale = 0.6;  // px of a rough picture for one of the window

bool isSoftware(QOpenGLContext& context) {
    const auto* name = context.functions()->glGetString(GL_RENDERER);
    const QByteArray text(reinterpret_cast<const char*>(name));
    return text.contains("llvmpipe") || text.contains("softpipe") || text.contains("SWR") ||
           text.contains("SwiftShader") || text.contains("Software");
}
}  // namespace

struct FrameRenderer::Private {
    Scene& scene;
    std::function<void()> makeCurrent;
    std::function<bool()> isCurrent;
    std::function<void()> requestFrame;
    vtkNew<vtkGenericOpenGLRenderWindow> window;
    vtkNew<vtkCallbackCommand> callback;
    QSize size{1, 1};
    double devicePixelRatio = 1.0;
    bool software = false;
    bool rough = false;
    bool ready = false;
    bool drawing = false;
    bool mustDraw = true;

    QSize drawnSize() const {
        if (!rough) return size;
        return QSize(static_cast<int>(std::ceil(size.width() * kRoughScale)),
                     static_cast<int>(std::ceil(size.height() * kRoughScale)));
    }

    void applySize() {
        const QSize drawn = drawnSize();
        window->SetSize(drawn.width(), drawn.height());
        window->SetDPI(static_cast<int>(72.0 * devicePixelRatio));
        scene.setScale(rough ? kRoughScale * devicePixelRatio : devicePixelRatio);
        mustDraw = true;
    }

    static void onEvent(vtkObject*, unsigned long event, void* client, void* data) {
        auto* self = static_cast<Private*>(client);
        switch (event) {
            case vtkCommand::WindowMakeCurrentEvent:
                self->makeCurrent();
                break;
            case vtkCommand::WindowIsCurrentEvent:
                *static_cast<bool*>(data) = self->isCurrent();
                break;
            case vtkCommand::WindowFrameEvent:
                if (!self->drawing) self->requestFrame();
                break;
            default:
                break;
        }
    }
};

FrameRenderer::FrameRenderer(Scene& scene, std::function<void()> makeCurrent,
                             std::function<bool()> isCurrent, std::function<void()> requestFrame)
    : d_(new Private{
          scene, std::move(makeCurrent), std::move(isCurrent), std::move(requestFrame), {}, {}}) {
    d_->callback->SetCallback(&Private::onEvent);
    d_->callback->SetClientData(d_.get());
    d_->window->SetReadyForRendering(false);
    d_->window->SetFrameBlitModeToNoBlit();
    d_->window->SetMultiSamples(kSamples);
    d_->window->AddRenderer(scene.renderer());
}

FrameRenderer::~FrameRenderer() = default;

void FrameRenderer::initialise() {
    Private& d = *d_;
    for (const unsigned long event :
         {static_cast<unsigned long>(vtkCommand::WindowMakeCurrentEvent),
          static_cast<unsigned long>(vtkCommand::WindowIsCurrentEvent),
          static_cast<unsigned long>(vtkCommand::WindowFrameEvent)}) {
        d.window->AddObserver(event, d.callback);
    }
    d.window->SetOwnContext(0);
    d.window->SetForceMaximumHardwareLineWidth(1);
    d.window->SetReadyForRendering(true);
    d.window->OpenGLInitContext();
    d.window->GetState()->Reset();
    d.window->GetState()->vtkglEnable(GL_DEPTH_TEST);
    d.software = isSoftware(*QOpenGLContext::currentContext());
    d.ready = true;
    d.mustDraw = true;
}

void FrameRenderer::resize(const QSize& devicePixels, double devicePixelRatio) {
    Private& d = *d_;
    d.size = devicePixels.expandedTo({1, 1});
    d.devicePixelRatio = devicePixelRatio;
    d.applySize();
}

void FrameRenderer::setRough(bool on) {
    on = on && d_->software;
    if (on == d_->rough) return;
    d_->rough = on;
    d_->window->SetMultiSamples(on ? 0 : kSamples);
    d_->applySize();
}

void FrameRenderer::render(unsigned framebuffer, bool keepAlpha) {
    Private& d = *d_;
    if (!d.ready) return;
    vtkOpenGLState* state = d.window->GetState();
    QOpenGLExtraFunctions* gl = QOpenGLContext::currentContext()->extraFunctions();
    // The painter of the last frame leaves it off; the state cache is told by Reset().
    gl->glEnable(GL_MULTISAMPLE);
    state->Reset();
    const bool changed = d.scene.takeChanged();
    if (changed || d.mustDraw) {
        d.drawing = true;
        d.window->Render();
        d.drawing = false;
        d.mustDraw = false;
    }
    const int w = d.size.width();
    const int h = d.size.height();
    state->PushDrawFramebufferBinding();
    gl->glBindFramebuffer(GL_DRAW_FRAMEBUFFER, framebuffer);
    const GLenum target = framebuffer == 0 ? GL_BACK : GL_COLOR_ATTACHMENT0;
    gl->glDrawBuffers(1, &target);
    state->vtkglDisable(GL_SCISSOR_TEST);
    gl->glDisable(GL_SCISSOR_TEST);
    const QSize drawn = d.drawnSize();
    d.window->BlitDisplayFramebuffer(0, 0, 0, drawn.width(), drawn.height(), 0, 0, w, h,
                                     GL_COLOR_BUFFER_BIT, d.rough ? GL_LINEAR : GL_NEAREST);
    if (!keepAlpha) {
        // Qt composes the widget by its alpha; what VTK left there means nothing.
        gl->glColorMask(GL_FALSE, GL_FALSE, GL_FALSE, GL_TRUE);
        gl->glClearColor(0.0F, 0.0F, 0.0F, 1.0F);
        gl->glClear(GL_COLOR_BUFFER_BIT);
        gl->glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    }
    state->PopDrawFramebufferBinding();
    gl->glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
}

bool FrameRenderer::stale() const { return d_->mustDraw || d_->scene.changed(); }

void FrameRenderer::finish() {
    Private& d = *d_;
    if (!d.ready) return;
    d.ready = false;
    d.window->RemoveObserver(d.callback);
    d.window->Finalize();
    d.window->SetReadyForRendering(false);
}

}  // namespace ew
