// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstddef>
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/error.h"

namespace patina {

/// Runs a process, reads its lines, and tells its memory and time. It dies with the thread that
/// started it, and with this object.
class LineProcess {
  public:
    /// Says what is started, and with which limits.
    struct Start {
        std::filesystem::path program;
        std::vector<std::string> arguments{};
        std::string input{};         ///< is all of its standard input
        std::size_t memoryBytes = 0; ///< limits its data
        std::size_t stackBytes = 0;  ///< limits its stack
    };

    /// Starts a program. It is an error where the system refuses.
    static Result<LineProcess> start(const Start& start);

    LineProcess(LineProcess&&) noexcept;
    LineProcess& operator=(LineProcess&&) noexcept;
    ~LineProcess();

    /// Returns the next line of its standard output, for which it waits so long. Nothing is
    /// returned where there is none yet, or none will come (hasEnded()).
    std::optional<std::string> line(std::chrono::milliseconds patience);

    /// Tells whether its output is at its end and all of it was returned.
    bool hasEnded() const;

    /// Returns how long it has computed, on all processors together; 0 once it has gone.
    double workSeconds() const;

    /// Returns what it holds in memory now; 0 once it has gone.
    std::size_t memoryBytes() const;

    /// Says how it ended.
    struct End {
        int signal = 0;                 ///< is the signal that ended it; 0: none
        int status = 0;                 ///< is its exit status; 0 after a signal
        std::size_t maxMemoryBytes = 0; ///< is the most that it ever held
    };

    /// Kills it unless it has ended by itself, and says how it ended. It may be called again.
    End end();

  private:
    struct State;
    explicit LineProcess(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

} // namespace patina
