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

/// Returns where a program's output of this location goes: GL_COLOR_ATTACHMENT0 and what follows
/// it.
unsigned colorAttachment(std::size_t location);

/// Returns the texture that a framebuffer object of the current context is drawn into; 0 where that
/// is none.
unsigned colorTextureOf(unsigned framebuffer);

/// Represents a framebuffer object. What is attached must outlive it.
class Framebuffer {
  public:
    Framebuffer() = default;
    static Framebuffer create();

    /// These bind the framebuffer for drawing and reading.
    void attachColor(const Texture& texture);
    void attachColor(const Renderbuffer& buffer);
    /// Attaches a texture that somebody else owns, of this context or one that shares with it; it
    /// may go and be replaced, but is drawn to only while it is there.
    void attachColor(unsigned texture);
    void attachDepth(const Renderbuffer& buffer);
    /// Attaches the colours that a program writes to `location`; those of all locations from 0 on
    /// are drawn.
    void attachColor(const TargetTexture& texture, unsigned location);
    void attachDepth(const TargetTexture& texture);
    /// Attaches all layers, which a program writes to the locations from 0 on.
    void attachColors(const TextureArray& texture);
    /// Attaches a layer of depths; it may be attached again and again, and no colours are drawn
    /// then.
    void attachDepth(const TextureArray& texture, int layer);

    /// Tells whether it can be drawn to; the error says what the driver does not like.
    Result<void> check() const;

    unsigned name() const { return name_.get(); }

  private:
    Name<deleteFramebuffer> name_;
};

} // namespace patina::gl
