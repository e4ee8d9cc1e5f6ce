// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <filesystem>
#include <utility>

#include <nlohmann/json.hpp>

#include "core/error.h"
#include "scene/scene.h"

namespace patina {

/// Keeps a scene on disk while it is edited: a copy of it and, in a journal beside the copy, what
/// changed since, a JSON patch (RFC 6902) to a line. An edit then costs a line to write, and a kill
/// in the midst of one loses that line alone.
class EditJournal {
  public:
    explicit EditJournal(std::filesystem::path copy) : copy_(std::move(copy)) {}

    /// Adds what changed since the last call. The first call, and one after a failure or when the
    /// journal has grown long, writes the copy anew. Errors name the file that could not be
    /// written.
    Result<void> write(const Scene& scene);

    /// Brings the copy up to what its journal says and removes the journal. A line that is not
    /// whole, or does not fit what stands before it, ends the reading; a journal of another copy is
    /// not read at all.
    static Result<void> join(const std::filesystem::path& copy);

    /// Returns where the journal of a copy is.
    static std::filesystem::path beside(const std::filesystem::path& copy);

  private:
    Result<void> writeCopy(nlohmann::json scene);
    Result<void> append(const nlohmann::json& patch);

    std::filesystem::path copy_;
    nlohmann::json written_;   ///< what the copy and its journal say together; null: nothing yet
    std::uintmax_t bytes_ = 0; ///< length of the journal
};

} // namespace patina
