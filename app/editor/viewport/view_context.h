// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>

#include "render/renderer.h"

class QOffscreenSurface;
class QOpenGLContext;
class QSurface;

namespace patina {

/// The OpenGL context that all views of a window draw in, so that meshes, images, programs and
/// shadow maps are there once however many views show them. There is one while a view is open; it
/// shares objects with the contexts of the views' widgets.
class ViewContext {
  public:
    /// `programCache`: see Renderer::Options.
    explicit ViewContext(std::filesystem::path programCache);
    ~ViewContext();

    const std::filesystem::path& programCache() const { return programCache_; }

    /// Opens a view whose widget has this context, and returns what draws it. The view ends with
    /// close().
    Result<std::unique_ptr<Renderer>> open(QOpenGLContext& shown);
    void close(std::unique_ptr<Renderer> renderer);

    /// Has the views' context current for as long as it lives, and then the one before again.
    class Current {
      public:
        explicit Current(const ViewContext& context);
        ~Current();
        Current(const Current&) = delete;
        Current& operator=(const Current&) = delete;

      private:
        QOpenGLContext* before_;
        QSurface* surfaceBefore_ = nullptr;
    };

  private:
    Result<void> create(QOpenGLContext& shown);
    void destroyUnused();

    std::filesystem::path programCache_;
    std::unique_ptr<QOffscreenSurface> surface_;
    std::unique_ptr<QOpenGLContext> context_;
    std::unique_ptr<Renderer> first_; ///< draws nothing; the views' share what it has
    std::size_t openViews_ = 0;
};

} // namespace patina
