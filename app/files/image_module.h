// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <future>

#include "core/error.h"
#include "io/image_codec.h"

namespace patina {

/// Loads the module with the image formats, `patina-files-images.so` beside this program, once,
/// when it is first asked for.
class ImageModule {
  public:
    /// Starts loading the module on another thread.
    void prefetch();

    /// Waits for the module. Fails where it is missing or does not fit.
    Result<const ImageCodec*> codec();

  private:
    std::shared_future<Result<const ImageCodec*>> codec_;
};

} // namespace patina
