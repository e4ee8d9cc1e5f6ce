// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "gl/framebuffer.h"
#include "viewport/view_context.h"

class QOpenGLWidget;

namespace patina {

/// What a view's picture is drawn into: the texture that its widget shows, in the context that all
/// views draw in.
class ViewSurface {
  public:
    /// Both outlive it. The widget has a texture: one sample per pixel.
    ViewSurface(QOpenGLWidget& widget, ViewContext& context);

    /// Opens the view while the widget's context is there, and returns what draws it.
    Result<std::unique_ptr<Renderer>> open();
    void close(std::unique_ptr<Renderer> renderer);

    /// Has the views' context current while the widget is painted, and then the widget's again,
    /// which waits on the device for what was drawn.
    class Painting {
      public:
        explicit Painting(ViewSurface& surface);
        ~Painting();
        Painting(const Painting&) = delete;
        Painting& operator=(const Painting&) = delete;

        /// Returns where the widget's picture is drawn.
        unsigned framebuffer() const;

      private:
        ViewSurface& surface_;
        unsigned shown_; ///< the widget's texture
        std::unique_ptr<ViewContext::Current> current_;
    };

  private:
    QOpenGLWidget& widget_;
    ViewContext& context_;
    gl::Framebuffer framebuffer_; ///< of the views' context
};

} // namespace patina
