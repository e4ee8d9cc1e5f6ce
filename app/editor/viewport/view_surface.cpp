// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/view_surface.h"

#include <utility>

#include <QOpenGLWidget>

#include "gl/fence.h"

namespace patina {

ViewSurface::ViewSurface(QOpenGLWidget& widget, ViewContext& context)
    : widget_(widget), context_(context) {}

Result<std::unique_ptr<Renderer>> ViewSurface::open() {
    Result<std::unique_ptr<Renderer>> renderer = context_.open(*widget_.context());
    if (renderer) {
        const ViewContext::Current current(context_);
        framebuffer_ = gl::Framebuffer::create();
    }
    return renderer;
}

void ViewSurface::close(std::unique_ptr<Renderer> renderer) {
    {
        const ViewContext::Current current(context_);
        framebuffer_ = {};
    }
    context_.close(std::move(renderer));
}

/// Attaches the widget's texture anew each time: after a change of size it is another one, which
/// may have the same name.
ViewSurface::Painting::Painting(ViewSurface& surface)
    : surface_(surface), shown_(gl::colorTextureOf(surface.widget_.defaultFramebufferObject())),
      current_(std::make_unique<ViewContext::Current>(surface.context_)) {
    surface_.framebuffer_.attachColor(shown_);
}

ViewSurface::Painting::~Painting() {
    const gl::Fence drawn = gl::Fence::afterCommandsSoFar();
    current_.reset();
    drawn.holdBack();
}

unsigned ViewSurface::Painting::framebuffer() const {
    return surface_.framebuffer_.name();
}

} // namespace patina
