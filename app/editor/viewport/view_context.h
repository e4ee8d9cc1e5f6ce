// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>

#include "render/renderer.h"
#include "viewport/frame_turns.h"

class QOffscreenSurface;
class QOpenGLContext;
class QSurface;

namespace patina {

/// Holds the OpenGL context that all views of a window draw in, so that meshes, images, programs
/// and shadow maps exist once however many views show them. The context exists while a view is
/// open; it shares objects with the contexts of the views' widgets.
class ViewContext {
  public:
    /// `programCache` is what Renderer::Options has under that name.
    explicit ViewContext(std::filesystem::path programCache);
    ~ViewContext();

    const std::filesystem::path& programCache() const { return programCache_; }

    /// Returns the queue of the views' frames, which all draw in this context.
    FrameTurns& turns() { return turns_; }

    /// Opens a view whose widget has the context `shown`, and returns what draws it. close() has to
    /// end the view. Fails where the driver does not let contexts share objects or does not offer
    /// what a Renderer needs.
    Result<std::unique_ptr<Renderer>> open(QOpenGLContext& shown);
    void close(std::unique_ptr<Renderer> renderer);

    /// Makes the views' context current for as long as it lives, and then the one before again.
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
    /// Draws nothing; the renderers of the views share its objects.
    std::unique_ptr<Renderer> first_;
    std::size_t openViews_ = 0;
    FrameTurns turns_;
};

} // namespace patina
