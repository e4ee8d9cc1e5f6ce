// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <memory>

#include "assets/channel.h"
#include "core/error.h"

namespace patina {

/// Owns a running `patina-files`, whose standard input is one end of a channel. The process dies
/// with the thread that started it, with this object, and when it passes its memory limit.
class FilesProcess {
  public:
    /// Starts the program; fails when it is missing or cannot be run.
    static Result<FilesProcess> start(const std::filesystem::path& program,
                                      std::size_t memoryLimitBytes);

    FilesProcess(FilesProcess&&) noexcept;
    FilesProcess& operator=(FilesProcess&&) noexcept;
    ~FilesProcess();

    const Channel& channel() const;

    /// Returns how long the process has computed so far, on all processors together; 0 when it has
    /// ended.
    double workSeconds() const;

    /// Ends the process at once; does nothing when it has ended.
    void kill();

  private:
    struct State;
    explicit FilesProcess(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

} // namespace patina
