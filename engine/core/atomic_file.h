// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <string_view>
#include <utility>

#include "core/error.h"

namespace patina {

/// Is a file that takes the place of another one when it is whole: until commit() it is a draft
/// beside it, with a name that nothing else uses, and it is removed when it is not committed. The
/// old file is intact whatever happens.
class AtomicFile {
  public:
    /// Creates the draft for a file, or for the one that a link names. Errors name the file: it is
    /// no ordinary file or write-protected, or its folder takes no new file.
    static Result<AtomicFile> create(const std::filesystem::path& file);

    AtomicFile(AtomicFile&& other) noexcept
        : target_(std::move(other.target_)), draft_(std::exchange(other.draft_, {})),
          descriptor_(std::exchange(other.descriptor_, -1)) {}
    AtomicFile& operator=(AtomicFile&&) = delete;
    ~AtomicFile();

    /// Returns the descriptor of the draft, which is open for writing.
    int descriptor() const { return descriptor_; }

    Result<void> write(std::string_view bytes);

    /// Gives the draft the old file's rights, flushes it to the disk and puts it in place.
    Result<void> commit();

  private:
    AtomicFile(std::filesystem::path target, std::filesystem::path draft, int descriptor)
        : target_(std::move(target)), draft_(std::move(draft)), descriptor_(descriptor) {}

    tl::unexpected<Error> cannotBeSaved() const; ///< says why by `errno`

    std::filesystem::path target_;
    std::filesystem::path draft_; ///< is empty once it is in place
    int descriptor_ = -1;
};

/// Writes a whole file or nothing, through a draft beside it. A link is followed; a device or a
/// pipe is written to, as it cannot be replaced. Errors name the file and the cause.
Result<void> writeFileAtomically(const std::filesystem::path& file, std::string_view bytes);

} // namespace patina
