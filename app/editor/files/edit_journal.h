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
/// changed since, one JSON patch (RFC 6902) per line. An edit costs only a line, and a crash while
/// writing loses only that line.
class EditJournal {
  public:
    explicit EditJournal(std::filesystem::path copy) : copy_(std::move(copy)) {}

    /// Adds what changed since the last call. The first call, one after a failure and one after the
    /// journal has grown beyond 1 MiB write the whole copy. Errors name the file that could not be
    /// written.
    Result<void> write(const Scene& scene);

    /// Applies the journal to the copy and removes the journal. Reading ends at an incomplete line
    /// or one that does not fit; a journal of another copy is ignored.
    static Result<void> join(const std::filesystem::path& copy);

    /// Returns the path of the journal of a copy.
    static std::filesystem::path beside(const std::filesystem::path& copy);

  private:
    Result<void> writeCopy(nlohmann::json scene);
    Result<void> append(const nlohmann::json& patch);

    std::filesystem::path copy_;
    nlohmann::json written_; ///< is the content of the copy with its journal; null before the first
    std::uintmax_t bytes_ = 0; ///< bytes in the journal
};

} // namespace patina
