// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <filesystem>
#include <map>
#include <mutex>
#include <string>
#include <vector>

#include "shading/program/block_gate.h"

namespace patina {

/// Limits what compiling a block and drawing it once may take.
struct TrialLimits {
    double seconds = 20.0;     ///< limits the process' own work, on all processors together
    double waitSeconds = 60.0; ///< limits the time by the clock, for one that hangs
    std::size_t memoryBytes = std::size_t(2) << 30;
};

/// Tries blocks in a process of their own, `patina try-blocks`, and remembers the results by hash
/// and driver: those that passed in a folder, all of them for its own lifetime.
class TrialGate : public BlockGate {
  public:
    struct Options {
        std::filesystem::path program{}; ///< is started to try blocks; empty: this very program
        std::filesystem::path folder{};  ///< keeps those that passed; empty: none is kept
        TrialLimits limits{};
    };

    explicit TrialGate(Options options);

    Answer ask(std::span<const StrangerBlock> blocks, bool mayWait) override;

    void stop() override;
    void resume() override;

    /// Returns how many processes were started.
    int startedCount() const { return started_; }

  private:
    class Run;

    std::string keyOf(const StrangerBlock& block, const std::string& driver) const;
    const Errors* known(const std::string& key);
    void note(const std::string& key, Errors mistakes);
    void letIn(const std::vector<StrangerBlock>& blocks, const std::string& driver);
    void tryOut(std::vector<StrangerBlock> blocks, const std::string& driver);

    Options options_;
    std::mutex trials_; ///< lets one trial run at a time
    std::mutex mutex_;  ///< guards known_
    std::map<std::string, Errors> known_;
    std::atomic<bool> isStopped_ = false;
    std::atomic<int> started_ = 0;
};

} // namespace patina
