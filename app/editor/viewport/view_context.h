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
class QSurfaceFormat;

namespace patina {

/// Holds the OpenGL context that all views of a window draw in, so that meshes, images, programs
/// and shadow maps exist once however many views show them. The context exists while a view is
/// open; the windows that show the views are drawn in it, too.
class ViewContext {
  public:
    /// `programCache` is what Renderer::Options has under that name.
    explicit ViewContext(std::filesystem::path programCache);
    ~ViewContext();

    const std::filesystem::path& programCache() const { return programCache_; }

    /// Returns the queue of the views' frames, which all draw in this context.
    FrameTurns& turns() { return turns_; }

    /// Returns the OpenGL format that the views need, of a context or a window.
    static QSurfaceFormat format();

    /// Opens a view and returns what draws it. close() has to end the view. Fails where the driver
    /// does not offer what a Renderer needs.
    Result<std::unique_ptr<Renderer>> open();
    void close(std::unique_ptr<Renderer> renderer);

    /// Makes the views' context current for as long as it lives, and then the one before again.
    class Current {
      public:
        /// `window` is what framebuffer 0 is; without one nothing may be drawn there.
        explicit Current(const ViewContext& context, QSurface* window = nullptr);
        ~Current();
        Current(const Current&) = delete;
        Current& operator=(const Current&) = delete;

      private:
        QOpenGLContext* before_;
        QSurface* surfaceBefore_ = nullptr;
    };

  private:
    Result<void> create();
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
