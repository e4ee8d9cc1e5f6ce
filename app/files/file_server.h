// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "assets/channel.h"
#include "assets/shared_block.h"
#include "core/error.h"
#include "files/image_module.h"

namespace patina {

/// Answers requests one at a time until the client closes the channel. Exceptions of libraries
/// become error answers.
class FileServer {
  public:
    explicit FileServer(Channel channel);

    /// Serves until the channel is closed and returns the exit status of the program: 1 where the
    /// channel failed.
    int run();

  private:
    struct Answer {
        std::string remarks;
        FileHandle block;
        std::shared_ptr<void> leftovers; ///< is freed only after the answer was sent
    };

    Result<Answer> answer(const Channel::Delivery& request);
    Result<Answer> guarded(const Channel::Delivery& request);
    Result<Answer> readMesh(const Message& request);
    Result<Answer> readImage(const Message& request);
    Result<Answer> writeImage(const Channel::Delivery& request);
    Result<Answer> encodeImage(const Channel::Delivery& request);
    Result<std::string> encoded(const Channel::Delivery& request, const std::string& extension);
    bool send(const Result<Answer>& answer);

    Channel channel_;
    ImageModule images_;
    /// Paths that the last mesh names and that may not be read.
    std::vector<std::string> refusedLinks_;
};

} // namespace patina
