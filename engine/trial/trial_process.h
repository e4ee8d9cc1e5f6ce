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

/// A process whose lines are read while its memory and its time are watched. It dies with the
/// thread that started it, and with this object.
class TrialProcess {
  public:
    static Result<TrialProcess> start(const std::filesystem::path& program,
                                      const std::vector<std::string>& arguments,
                                      std::size_t memoryBytes);

    TrialProcess(TrialProcess&&) noexcept;
    TrialProcess& operator=(TrialProcess&&) noexcept;
    ~TrialProcess();

    /// Returns the next line of its standard output, waited for so long; nothing: there is none
    /// yet, or none will come (hasEnded()).
    std::optional<std::string> line(std::chrono::milliseconds patience);

    /// Its output is at its end.
    bool hasEnded() const;

    /// Returns how long it has computed, on all processors together; 0 once it has gone.
    double workSeconds() const;

    /// Returns what it holds in memory now; 0 once it has gone.
    std::size_t memoryBytes() const;

    /// Says how it ended.
    struct End {
        int signal = 0;                 ///< that ended it; 0: none
        int status = 0;                 ///< it gave back
        std::size_t maxMemoryBytes = 0; ///< it ever held
    };

    /// Ends it, where it has not by itself.
    End end();

  private:
    struct State;
    explicit TrialProcess(std::unique_ptr<State> state);
    std::unique_ptr<State> state_;
};

} // namespace patina
