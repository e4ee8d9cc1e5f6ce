// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "assets/asset_client.h"
#include "assets/files_process.h"
#include "assets/message.h"

namespace patina {

/// Asks the files process one thing at a time: starts it when there is none, watches the time and
/// the cancel flag, and ends it after anything that is not a proper answer.
class FilesSession {
  public:
    explicit FilesSession(AssetClient::Options options);

    struct Request {
        Message message;
        std::filesystem::path file; ///< is named in errors
        std::string doing;          ///< names the work in errors: "reading", "writing"
        FileHandle attachment;
        Progress* progress = nullptr;
    };

    struct Answer {
        std::string remarks;
        FileHandle attachment;
    };

    Result<Answer> ask(const Request& request);

    /// Returns the paths that a mesh links to and that the process was not allowed to read for its
    /// last answer, whether that was an error or not.
    const std::vector<std::string>& refusedLinks() const { return refusedLinks_; }

    /// Starts the process when there is none; if `images`, makes it load the image formats.
    void warmUp(bool images);

    /// Ends the process after a wrong answer and returns the error for it; `why` is named in it.
    Error refuse(const Request& request, const std::string& why);

  private:
    class Patience;

    Result<void> begin(const Request& request);
    Result<Answer> await(const Request& request);
    Result<Answer> interpreted(const Request& request, Channel::Delivery delivery);
    Error ended(const Request& request, std::string problem);

    AssetClient::Options options_;
    std::optional<FilesProcess> process_;
    std::vector<std::string> refusedLinks_;
};

} // namespace patina
