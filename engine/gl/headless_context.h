// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "core/error.h"

namespace patina::gl {

/// Owns an OpenGL 4.1 core context without a window or a display server. It is current on the
/// thread that made it until it is destroyed there. When the last such context is destroyed, the
/// driver has finished the work of its own threads, such as writing programs to disk.
class HeadlessContext {
  public:
    struct Options {
        bool debug = false; ///< asks the driver for debug messages
    };

    /// Makes a context on the first display that offers one. The error says what was found instead
    /// (no EGL, only OpenGL 3.3 by this renderer, ...).
    static Result<std::unique_ptr<HeadlessContext>> create(const Options& options);
    static Result<std::unique_ptr<HeadlessContext>> create() { return create(Options{}); }
    ~HeadlessContext();

    HeadlessContext(const HeadlessContext&) = delete;
    HeadlessContext& operator=(const HeadlessContext&) = delete;

  private:
    HeadlessContext(void* display, void* context) : display_(display), context_(context) {}

    void* display_;
    void* context_;
};

} // namespace patina::gl
