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

/// Holds what one block may take to be compiled and drawn once.
struct TrialLimits {
    double seconds = 20.0;     ///< of the process' own work, on all processors together
    double waitSeconds = 60.0; ///< by the clock, for one that hangs
    std::size_t memoryBytes = std::size_t(2) << 30;
};

/// Has blocks tried in a process of their own, `patina try-blocks`, and remembers by their hash and
/// the driver what came of it: good ones in a folder, all for as long as it lives.
class TrialGate : public BlockGate {
  public:
    struct Options {
        std::filesystem::path program{}; ///< empty: this one
        std::filesystem::path folder{};  ///< of what is remembered; empty: none
        TrialLimits limits{};
    };

    explicit TrialGate(Options options);

    Answer ask(std::span<const StrangerBlock> blocks, bool mayWait) override;

    void stop() override;
    void resume() override;

    /// Processes that were started.
    int startedCount() const { return started_; }

  private:
    class Run;

    std::string keyOf(const StrangerBlock& block, const std::string& driver) const;
    const Errors* known(const std::string& key);
    void note(const std::string& key, Errors mistakes);
    void letIn(const std::vector<StrangerBlock>& blocks, const std::string& driver);
    void tryOut(std::vector<StrangerBlock> blocks, const std::string& driver);

    Options options_;
    std::mutex trials_; ///< one at a time
    std::mutex mutex_;  ///< guards what follows
    std::map<std::string, Errors> known_;
    std::atomic<bool> isStopped_ = false;
    std::atomic<int> started_ = 0;
};

} // namespace patina
