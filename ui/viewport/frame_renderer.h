// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSize>
#include <functional>
#include <memory>

namespace ew {

class Scene;

/// VTK inside an OpenGL context that someone else owns: a widget's or an off-screen one. Draws a
/// Scene into a framebuffer of that context. Every function but the constructor needs the context
/// to be current; finish() must be called with it before it goes away.
class FrameRenderer {
  public:
    /// \param scene         outlives this.
    /// \param makeCurrent   makes the context current where it is not; never more than that.
    /// \param requestFrame  called when VTK wants to be drawn again.
    FrameRenderer(Scene& scene, std::function<void()> makeCurrent, std::function<bool()> isCurrent,
                  std::function<void()> requestFrame);
    ~FrameRenderer();
    FrameRenderer(const FrameRenderer&) = delete;
    FrameRenderer& operator=(const FrameRenderer&) = delete;

    /// Again after a lost context, after finish().
    void initialise();
    /// \param devicePixels  size of the framebuffer.
    void resize(const QSize& devicePixels, double devicePixelRatio);
    /// Draws rough pictures from now on, or fine ones again: what moves is to move smoothly. Where
    /// a graphics card does the work it is all the same; in software OpenGL a rough picture has no
    /// antialiasing and fewer px, which are drawn larger.
    void setRough(bool on);
    /// Draws into a framebuffer object (0 for the window's own). The scene itself is drawn only if
    /// it changed since the last time; else its last picture is copied.
    /// \param keepAlpha  the framebuffer gets the alpha of the scene, premultiplied; else it is
    ///                   opaque.
    void render(unsigned framebuffer, bool keepAlpha = false);
    /// Would render() draw the scene anew?
    bool stale() const;
    void finish();

  private:
    struct Private;
    std::unique_ptr<Private> d_;
};

}  // namespace ew
