// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "gl/framebuffer.h"
#include "viewport/view_context.h"

class QOpenGLWidget;

namespace patina {

/// Draws a view's picture into the texture that its widget shows, in the context that all views
/// share.
class ViewSurface {
  public:
    /// Both references outlive it. The widget's format has one sample per pixel, so that its
    /// framebuffer has a texture.
    ViewSurface(QOpenGLWidget& widget, ViewContext& context);

    /// Opens the view, while the widget's context is there, and returns what draws it. Fails as
    /// ViewContext::open() does.
    Result<std::unique_ptr<Renderer>> open();
    void close(std::unique_ptr<Renderer> renderer);

    /// Makes the views' context current while the widget is painted. Its end makes the widget's
    /// context current again, in which the device then waits for what was drawn.
    class Painting {
      public:
        explicit Painting(ViewSurface& surface);
        ~Painting();
        Painting(const Painting&) = delete;
        Painting& operator=(const Painting&) = delete;

        /// Returns the OpenGL name of the framebuffer that draws into the widget's texture.
        unsigned framebuffer() const;

      private:
        ViewSurface& surface_;
        unsigned shown_; ///< is the OpenGL name of the widget's texture
        std::unique_ptr<ViewContext::Current> current_;
    };

  private:
    QOpenGLWidget& widget_;
    ViewContext& context_;
    gl::Framebuffer framebuffer_; ///< belongs to the views' context
};

} // namespace patina
