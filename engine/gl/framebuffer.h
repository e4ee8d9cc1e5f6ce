// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "core/error.h"
#include "gl/name.h"
#include "gl/renderbuffer.h"
#include "gl/target_texture.h"
#include "gl/texture.h"
#include "gl/texture_array.h"

namespace patina::gl {

void deleteFramebuffer(unsigned name);

/// Returns the attachment for a program's output at this location: GL_COLOR_ATTACHMENT0 + location.
unsigned colorAttachment(std::size_t location);

/// Returns the name of the texture at the first colour attachment of a framebuffer object of the
/// current context; 0 where it is no texture.
unsigned colorTextureOf(unsigned framebuffer);

/// Owns a framebuffer object. What is attached must outlive it.
class Framebuffer {
  public:
    Framebuffer() = default;
    static Framebuffer create();

    /// Attaches the texture as colour attachment 0. Each of these functions leaves the framebuffer
    /// bound for drawing and reading.
    void attachColor(const Texture& texture);
    void attachColor(const Renderbuffer& buffer);
    /// Attaches a texture that somebody else owns, of this context or one that shares with it. It
    /// must exist whenever the framebuffer is drawn to.
    void attachColor(unsigned texture);
    void attachDepth(const Renderbuffer& buffer);
    /// Attaches the texture for the colours that a program writes to `location` (0 or 1), and draws
    /// all locations from 0 to this one.
    void attachColor(const TargetTexture& texture, unsigned location);
    void attachDepth(const TargetTexture& texture, int level = 0);
    /// Attaches all layers, at most 8; a program writes layer i at location i.
    void attachColors(const TextureArray& texture);
    /// Attaches one layer of depths and turns off the drawing and reading of colours. It may be
    /// called again for another layer.
    void attachDepth(const TextureArray& texture, int layer);

    /// Checks that the framebuffer is complete; the error has the driver's status in hexadecimal.
    Result<void> check() const;

    unsigned name() const { return name_.get(); }

  private:
    Name<deleteFramebuffer> name_;
};

} // namespace patina::gl
