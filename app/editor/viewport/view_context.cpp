// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/view_context.h"

#include <utility>

#include <QOffscreenSurface>
#include <QOpenGLContext>

#include "gl/driver.h"

namespace patina {
namespace {

/// Returns what this machine offers instead of OpenGL 4.1.
std::string foundOpenGL() {
    QOpenGLContext context;
    context.setFormat(QSurfaceFormat());
    QOffscreenSurface surface;
    surface.create();
    if (!context.create() || !context.makeCurrent(&surface)) {
        return "no OpenGL at all";
    }
    return gl::driverText();
}

} // namespace

ViewContext::ViewContext(std::filesystem::path programCache)
    : programCache_(std::move(programCache)) {}

ViewContext::~ViewContext() = default;

QSurfaceFormat ViewContext::format() {
    QSurfaceFormat format;
    format.setVersion(4, 1);
    format.setProfile(QSurfaceFormat::CoreProfile);
    // The renderer has buffers of its own; a window only takes the finished picture.
    format.setDepthBufferSize(0);
    format.setStencilBufferSize(0);
    format.setSwapInterval(0); // views would wait for the screen one after the other
    return format;
}

Result<std::unique_ptr<Renderer>> ViewContext::open() {
    if (auto created = create(); !created) {
        destroyUnused();
        return tl::unexpected(created.error());
    }
    ++openViews_;
    const Current current(*this);
    return first_->forAnotherView();
}

void ViewContext::close(std::unique_ptr<Renderer> renderer) {
    {
        const Current current(*this);
        renderer.reset();
    }
    --openViews_;
    destroyUnused();
}

/// Creates the context and the objects that all views share, unless they exist.
Result<void> ViewContext::create() {
    if (!context_) {
        context_ = std::make_unique<QOpenGLContext>();
        context_->setFormat(format());
        if (!context_->create()) {
            return failure("OpenGL 4.1 is needed, but this machine has " + foundOpenGL());
        }
        surface_ = std::make_unique<QOffscreenSurface>();
        surface_->setFormat(context_->format());
        surface_->create();
    }
    if (!first_) {
        const Current current(*this);
        Result<std::unique_ptr<Renderer>> made = Renderer::create({programCache_});
        if (!made) {
            return tl::unexpected(made.error());
        }
        first_ = std::move(*made);
    }
    return {};
}

void ViewContext::destroyUnused() {
    if (openViews_ == 0) {
        {
            const Current current(*this);
            first_.reset();
        }
        context_.reset();
        surface_.reset();
    }
}

ViewContext::Current::Current(const ViewContext& context, QSurface* window)
    : before_(QOpenGLContext::currentContext()),
      surfaceBefore_(before_ != nullptr ? before_->surface() : nullptr) {
    if (context.context_) {
        context.context_->makeCurrent(window != nullptr ? window : context.surface_.get());
    }
}

ViewContext::Current::~Current() {
    if (before_ != nullptr) {
        before_->makeCurrent(surfaceBefore_);
    } else if (QOpenGLContext* ours = QOpenGLContext::currentContext()) {
        ours->doneCurrent();
    }
}

} // namespace patina
