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
        std::filesystem::path file; ///< for errors
        std::string doing;          ///< for errors: "reading", "writing"
        FileHandle attachment;
        Progress* progress = nullptr;
    };

    struct Answer {
        std::string remarks;
        FileHandle attachment;
    };

    Result<Answer> ask(const Request& request);

    /// The links of a mesh that the process did not read in its last answer, an error or not.
    const std::vector<std::string>& refusedLinks() const { return refusedLinks_; }

    /// Starts the process when there is none, and has it load the image formats if told so.
    void warmUp(bool images);

    /// Says that the answer made no sense: ends the process and says so.
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
