// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/view_context.h"

#include <utility>

#include <QOffscreenSurface>
#include <QOpenGLContext>

namespace patina {

ViewContext::ViewContext(std::filesystem::path programCache)
    : programCache_(std::move(programCache)) {}

ViewContext::~ViewContext() = default;

Result<std::unique_ptr<Renderer>> ViewContext::open(QOpenGLContext& shown) {
    if (auto created = create(shown); !created) {
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
Result<void> ViewContext::create(QOpenGLContext& shown) {
    if (!context_) {
        context_ = std::make_unique<QOpenGLContext>();
        context_->setFormat(shown.format());
        context_->setShareContext(&shown);
        context_->setScreen(shown.screen());
        context_->create();
        surface_ = std::make_unique<QOffscreenSurface>(shown.screen());
        surface_->setFormat(context_->format());
        surface_->create();
    }
    if (!QOpenGLContext::areSharing(context_.get(), &shown)) {
        return failure("the graphics driver does not let the views share a context");
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

ViewContext::Current::Current(const ViewContext& context)
    : before_(QOpenGLContext::currentContext()),
      surfaceBefore_(before_ != nullptr ? before_->surface() : nullptr) {
    if (context.context_) {
        context.context_->makeCurrent(context.surface_.get());
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
