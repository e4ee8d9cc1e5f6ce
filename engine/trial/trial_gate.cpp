// SPDX-License-Identifier: GPL-3.0-or-later
#include "trial/trial_gate.h"

#include <algorithm>
#include <chrono>
#include <optional>
#include <utility>

#include <boost/uuid/name_generator_sha1.hpp>
#include <boost/uuid/uuid_io.hpp>
#include <fmt/format.h>

#include "assets/line_process.h"
#include "gl/driver.h"
#include "trial/good_blocks.h"
#include "trial/trial_report.h"
#include "trial/trial_words.h"

namespace patina {
namespace {

namespace fs = std::filesystem;

using Clock = std::chrono::steady_clock;
using namespace std::chrono_literals;

/// Says how often memory and time are checked: little memory can be filled in between.
constexpr auto watchEvery = 10ms;

/// Is the share of its memory limit above which a process that ended is said to have needed more.
constexpr double nearlyAll = 0.75;

/// Limits the stack to half of what programs usually have: a block that passes here has room to
/// spare in the program.
constexpr std::size_t stackBytes = std::size_t(4) << 20;

std::string nameOf(const StrangerBlock& block) {
    return block.kind + '/' + block.id;
}

bool areBeside(const StrangerBlock& a, const StrangerBlock& b) {
    return a.shaders == b.shaders && a.own == b.own;
}

fs::path thisProgram() {
    std::error_code failed;
    return fs::read_symlink("/proc/self/exe", failed);
}

TrialGate::Options completed(TrialGate::Options options) {
    if (options.program.empty()) {
        options.program = thisProgram();
    }
    return options;
}

Error aboutBlock(const StrangerBlock& block, const std::string& problem, std::string expected) {
    return {block.file.string(), 0, 0,
            fmt::format("the block \"{}\" was not let in: {}", block.id, problem),
            std::move(expected)};
}

std::string mebibytes(std::size_t bytes) {
    return fmt::format("{} MiB", bytes >> 20);
}

} // namespace

/// Follows one process that tries some blocks, and ends it at the first that does it harm.
class TrialGate::Run {
  public:
    Run(LineProcess process, const std::vector<StrangerBlock>& blocks, const TrialLimits& limits,
        const std::atomic<bool>& isStopped)
        : process_(std::move(process)), blocks_(blocks), limits_(limits), isStopped_(isStopped) {}

    /// Holds the result of a block's trial.
    struct Verdict {
        const StrangerBlock* block = nullptr;
        Errors mistakes{};
        bool isFinal = true; ///< is false where the files changed, so that it is tried again
    };

    /// Waits for the process and returns a verdict for each block that it came to.
    std::vector<Verdict> verdicts() {
        beginWatch();
        while (!process_.hasEnded() && !isStopped_) {
            if (const auto line = process_.line(watchEvery)) {
                take(*line);
            } else if (const auto why = excess()) {
                refuse(*why);
                return std::move(verdicts_);
            }
        }
        if (isStopped_) {
            process_.end();
        } else if (trying_ != nullptr) {
            refuse(howItEnded());
        }
        return std::move(verdicts_);
    }

    /// Tells whether the process said that it found no OpenGL to try blocks with.
    bool isWithoutDriver() const { return isWithoutDriver_; }

  private:
    void beginWatch() {
        begun_ = Clock::now();
        workBefore_ = process_.workSeconds();
    }

    const StrangerBlock* named(const std::string& name) const {
        const auto found = std::find_if(blocks_.begin(), blocks_.end(),
                                        [&](const auto& block) { return nameOf(block) == name; });
        return found == blocks_.end() ? nullptr : &*found;
    }

    void take(const std::string& line) {
        std::optional<TrialReport> report = trialReport(line);
        if (!report) {
            return; // the driver printed it
        }
        const StrangerBlock* block = named(report->block);
        isWithoutDriver_ = isWithoutDriver_ || report->block.empty();
        if (block != nullptr && !report->isDone) {
            trying_ = block;
            triedHash_ = report->hash;
            beginWatch();
        } else if (block != nullptr) {
            verdicts_.push_back(verdict(*block, std::move(*report)));
            trying_ = nullptr;
            beginWatch();
        }
    }

    static Verdict verdict(const StrangerBlock& block, TrialReport report) {
        const bool isUnread = report.hash.empty() && !report.mistakes.empty();
        if (report.hash != block.hash && !isUnread) {
            return changed(block);
        }
        return {&block, std::move(report.mistakes)};
    }

    /// Returns a verdict that is not final: what was tried is not what was asked about.
    static Verdict changed(const StrangerBlock& block) {
        return {&block, {aboutBlock(block, "its files changed while it was tried", {})}, false};
    }

    std::optional<std::string> excess() {
        if (process_.memoryBytes() > limits_.memoryBytes) {
            return needsMemory();
        }
        if (process_.workSeconds() - workBefore_ > limits_.seconds) {
            return fmt::format("compiling and drawing it takes more than {:.3g} s of work",
                               limits_.seconds);
        }
        if (Clock::now() - begun_ > std::chrono::duration<double>(limits_.waitSeconds)) {
            return fmt::format("compiling and drawing it takes longer than {:.3g} s",
                               limits_.waitSeconds);
        }
        return std::nullopt;
    }

    std::string needsMemory() const {
        return "the graphics driver needs more than " + mebibytes(limits_.memoryBytes) +
               " of memory to compile it";
    }

    std::string howItEnded() {
        const LineProcess::End end = process_.end();
        if (double(end.maxMemoryBytes) > nearlyAll * double(limits_.memoryBytes)) {
            return needsMemory();
        }
        const std::string how = end.signal != 0 ? fmt::format("signal {}", end.signal)
                                                : fmt::format("status {}", end.status);
        return fmt::format("the graphics driver stopped unexpectedly ({}) while it compiled it, "
                           "with {} of memory",
                           how, mebibytes(limits_.memoryBytes));
    }

    /// Refuses the block that is being tried, or the first one where none was begun, and ends the
    /// process.
    void refuse(const std::string& why) {
        const StrangerBlock& block = trying_ != nullptr ? *trying_ : blocks_.front();
        if (!triedHash_.empty() && triedHash_ != block.hash) {
            verdicts_.push_back(changed(block));
        } else {
            verdicts_.push_back({&block,
                                 {aboutBlock(block, why,
                                             "a shader that the driver compiles in little time and "
                                             "memory")}});
        }
        process_.end();
    }

    LineProcess process_;
    const std::vector<StrangerBlock>& blocks_;
    const TrialLimits& limits_;
    const std::atomic<bool>& isStopped_;
    const StrangerBlock* trying_ = nullptr;
    std::string triedHash_; ///< is the hash of the files of `trying_` as the process read them
    std::vector<Verdict> verdicts_;
    double workBefore_ = 0.0;
    Clock::time_point begun_;
    bool isWithoutDriver_ = false;
};

TrialGate::TrialGate(Options options) : options_(completed(std::move(options))) {}

void TrialGate::stop() {
    isStopped_ = true;
}

void TrialGate::resume() {
    isStopped_ = false;
}

std::string TrialGate::keyOf(const StrangerBlock& block, const std::string& driver) const {
    const boost::uuids::name_generator_sha1 generate(boost::uuids::ns::oid());
    return boost::uuids::to_string(
        generate("patina trial 1\n" + nameOf(block) + '\n' + block.hash + '\n' + driver));
}

/// Returns a block's mistakes, none where it passed; null where it was never tried.
const Errors* TrialGate::known(const std::string& key) {
    const std::lock_guard lock(mutex_);
    const auto found = known_.find(key);
    if (found != known_.end()) {
        return &found->second; // stays valid: entries are neither changed nor erased
    }
    return GoodBlocks(options_.folder).has(key) ? &known_.emplace(key, Errors()).first->second
                                                : nullptr;
}

void TrialGate::note(const std::string& key, Errors mistakes) {
    if (mistakes.empty()) {
        GoodBlocks(options_.folder).add(key);
    }
    const std::lock_guard lock(mutex_);
    known_.emplace(key, std::move(mistakes));
}

BlockGate::Answer TrialGate::ask(std::span<const StrangerBlock> blocks, bool mayWait) {
    const std::string driver = gl::driverText();
    const auto unknown = [&] {
        std::vector<StrangerBlock> missing;
        std::copy_if(blocks.begin(), blocks.end(), std::back_inserter(missing),
                     [&](const auto& block) { return known(keyOf(block, driver)) == nullptr; });
        return missing;
    };
    Answer answer;
    if (mayWait && !unknown().empty()) {
        const std::lock_guard lock(trials_);
        tryOut(unknown(), driver); // another thread may have done it meanwhile
    }
    for (const StrangerBlock& block : blocks) {
        if (const Errors* mistakes = known(keyOf(block, driver))) {
            answer.mistakes.insert(answer.mistakes.end(), mistakes->begin(), mistakes->end());
        } else {
            answer.isFinal = false;
            answer.mistakes.push_back({block.file.string(),
                                       0,
                                       0,
                                       fmt::format("the block \"{}\" is being checked", block.id),
                                       {}});
        }
    }
    return answer;
}

/// Lets blocks pass untried, on a machine that has a context for a window but none without one.
void TrialGate::letIn(const std::vector<StrangerBlock>& blocks, const std::string& driver) {
    const std::lock_guard lock(mutex_);
    for (const StrangerBlock& block : blocks) {
        known_.emplace(keyOf(block, driver), Errors());
    }
}

/// Tries blocks in one process after the other: each tries as many as it survives.
void TrialGate::tryOut(std::vector<StrangerBlock> blocks, const std::string& driver) {
    while (!blocks.empty() && !isStopped_) {
        std::vector<StrangerBlock> together;
        std::copy_if(blocks.begin(), blocks.end(), std::back_inserter(together),
                     [&](const auto& block) { return areBeside(block, blocks.front()); });
        std::vector<std::string> arguments{trialCommandWord, together.front().shaders.string(),
                                           together.front().own.string()};
        for (const StrangerBlock& block : together) {
            arguments.push_back(nameOf(block));
        }
        auto process = LineProcess::start({.program = options_.program,
                                           .arguments = arguments,
                                           .memoryBytes = options_.limits.memoryBytes,
                                           .stackBytes = stackBytes});
        if (!process) {
            for (const StrangerBlock& block : together) {
                note(keyOf(block, driver), {aboutBlock(block, process.error().problem, {})});
            }
            return;
        }
        ++started_;
        Run run(std::move(*process), together, options_.limits, isStopped_);
        const auto verdicts = run.verdicts();
        for (const Run::Verdict& verdict : verdicts) {
            if (verdict.isFinal) {
                note(keyOf(*verdict.block, driver), verdict.mistakes);
            }
            std::erase_if(blocks, [&](const auto& block) { return block == *verdict.block; });
        }
        if (verdicts.empty()) {
            if (run.isWithoutDriver()) {
                letIn(together, driver);
            } else if (!isStopped_) {
                note(keyOf(together.front(), driver),
                     {aboutBlock(together.front(), "the process that tries blocks said nothing",
                                 {})});
            }
            return;
        }
    }
}

} // namespace patina
