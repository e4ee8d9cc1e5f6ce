// SPDX-License-Identifier: GPL-3.0-or-later
#include "predict/family_compiler.h"

#include <algorithm>
#include <chrono>
#include <map>
#include <memory>
#include <optional>
#include <utility>

#include "assets/line_process.h"
#include "assets/sibling_program.h"

namespace patina {
namespace {

using Clock = std::chrono::steady_clock;
using namespace std::chrono_literals;

constexpr auto watchEvery = 50ms;
/// Is how many programs take a process about as long as starting it does.
constexpr std::size_t programsWorthAProcess = 8;
constexpr std::size_t stackBytes = std::size_t(8) << 20;

/// Is how many times its CPU time a process may take on the clock, because others are at work too.
constexpr double clockFactor = 10.0;

Error stoppedError() {
    return {{}, 0, 0, "it was stopped", {}};
}

/// Reads the lines of one process.
class Reader {
  public:
    Reader(LineProcess process, const FamilyCompilerOptions& options)
        : process_(std::move(process)), options_(options) {}

    /// Returns the next line, for which it waits so long: nothing where there is none yet, and an
    /// error, which says why, where none will come.
    std::optional<Result<std::string>> line(std::chrono::milliseconds patience) {
        if (auto line = process_.line(patience)) {
            workBefore_ = process_.workSeconds();
            began_ = Clock::now();
            return Result<std::string>(std::move(*line));
        }
        if (options_.isStopped()) {
            return Result<std::string>(tl::unexpected(stoppedError()));
        }
        if (process_.hasEnded()) {
            return Result<std::string>(
                failure("compiling it for other graphics cards ended the compiler"));
        }
        const std::chrono::duration<double> waited = Clock::now() - began_;
        if (process_.workSeconds() - workBefore_ > options_.secondsEach ||
            waited.count() > clockFactor * options_.secondsEach) {
            return Result<std::string>(
                failure("compiling it for other graphics cards takes too long"));
        }
        return std::nullopt;
    }

  private:
    LineProcess process_;
    const FamilyCompilerOptions& options_;
    double workBefore_ = 0.0; ///< is what the process had computed at its last line, in seconds
    Clock::time_point began_ = Clock::now();
};

Result<std::string> driverIn(const std::string& line) {
    const auto value = nlohmann::json::parse(line, nullptr, false);
    if (value.is_object() && value.contains("driver")) {
        return value["driver"].get<std::string>();
    }
    const auto error = familyStatisticsIn(line);
    return error ? Result<std::string>(failure("the answer has no driver"))
                 : tl::unexpected(error.error());
}

CompileRequest requestFor(std::span<const GpuFamily* const> families) {
    CompileRequest request;
    for (const GpuFamily* family : families) {
        request.families.push_back({family->id, family->chips, family->isMali});
    }
    return request;
}

/// Holds programs without repetition, and for each of the given ones which of them it is: presets
/// of one model often differ in values alone.
struct DistinctPrograms {
    std::vector<ProgramText> texts;
    std::vector<std::size_t> indices;
};

DistinctPrograms distinct(std::vector<ProgramText> programs) {
    DistinctPrograms distinct;
    std::map<ProgramText, std::size_t> known;
    for (ProgramText& program : programs) {
        const auto [found, isNew] = known.emplace(std::move(program), known.size());
        if (isNew) {
            distinct.texts.push_back(found->first);
        }
        distinct.indices.push_back(found->second);
    }
    return distinct;
}

} // namespace

namespace {

/// Has some of a command's programs compiled, one after the other, by processes of its own: a new
/// one takes over behind a program that ended the one before.
class CompilerQueue {
  public:
    CompilerQueue(CompileRequest families, const std::vector<ProgramText>& programs,
                  std::vector<std::size_t> own, const FamilyCompilerOptions& options)
        : families_(std::move(families)), programs_(programs), own_(std::move(own)),
          options_(options) {}

    bool isDone() const { return done_ == own_.size() && !driver_.empty(); }
    std::size_t left() const { return own_.size() - done_; }
    const std::string& driver() const { return driver_; }

    /// Reads what is compiled by now into `answers`; waits a little where there is nothing. An
    /// error is one of all programs.
    Result<void> step(std::vector<Result<FamilyStatistics>>& answers) {
        if (!reader_) {
            if (auto started = start(); !started) {
                return started;
            }
        }
        for (auto line = reader_->line(watchEvery); line; line = reader_->line(0ms)) {
            if (driver_.empty() || isNew_) {
                const auto driver = line->and_then(driverIn);
                if (!driver) {
                    return tl::unexpected(driver.error());
                }
                driver_ = *driver;
                isNew_ = false;
            } else {
                answers[own_[done_++]] =
                    *line ? familyStatisticsIn(**line) : tl::unexpected(line->error());
            }
            if (!*line || isDone()) {
                reader_.reset();
                break;
            }
        }
        return {};
    }

  private:
    Result<void> start() {
        CompileRequest request = families_;
        for (std::size_t i = done_; i < own_.size(); ++i) {
            request.programs.push_back(programs_[own_[i]]);
        }
        auto process = LineProcess::start(
            {.program = options_.program.empty() ? siblingProgram("patina-cost") : options_.program,
             .input =
                 toJson(request).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace),
             .memoryBytes = options_.memoryBytes,
             .stackBytes = stackBytes});
        if (!process) {
            return tl::unexpected(process.error());
        }
        reader_.emplace(std::move(*process), options_);
        isNew_ = true;
        return {};
    }

    CompileRequest families_;
    const std::vector<ProgramText>& programs_;
    std::vector<std::size_t> own_; ///< are indices of its programs
    const FamilyCompilerOptions& options_;
    std::optional<Reader> reader_; ///< is of the process at work
    bool isNew_ = true;            ///< the process has not told its driver yet
    std::string driver_;
    std::size_t done_ = 0;
};

/// Returns how many processes are worth their start.
std::size_t processesFor(std::size_t programs, const FamilyCompilerOptions& options) {
    return std::clamp<std::size_t>(programs / programsWorthAProcess, 1,
                                   std::max<std::size_t>(options.processes, 1));
}

/// Compiles programs, of which no two are the same. Those that stand together are often of one
/// model and take about equally long, so that they are dealt out in turn.
Result<CompiledForFamilies> compiledNow(std::span<const GpuFamily* const> families,
                                        const std::vector<ProgramText>& programs,
                                        const FamilyCompilerOptions& options) {
    std::vector<std::vector<std::size_t>> shares(processesFor(programs.size(), options));
    for (std::size_t i = 0; i < programs.size(); ++i) {
        shares[i % shares.size()].push_back(i);
    }
    std::vector<std::unique_ptr<CompilerQueue>> open;
    for (std::vector<std::size_t>& share : shares) {
        open.push_back(std::make_unique<CompilerQueue>(requestFor(families), programs,
                                                       std::move(share), options));
    }
    CompiledForFamilies compiled;
    compiled.programs.assign(programs.size(), tl::unexpected(stoppedError()));
    while (!open.empty()) {
        for (const auto& queue : open) {
            if (auto done = queue->step(compiled.programs); !done) {
                return tl::unexpected(done.error());
            }
            compiled.driver = queue->driver();
        }
        if (options.isStopped()) {
            return tl::unexpected(stoppedError());
        }
        std::erase_if(open, [](const auto& queue) { return queue->isDone(); });
        std::size_t left = 0;
        for (const auto& queue : open) {
            left += queue->left();
        }
        options.onProgress(1.0 - double(left) / double(std::max<std::size_t>(programs.size(), 1)));
    }
    return compiled;
}

} // namespace

Result<CompiledForFamilies> compileForFamilies(std::span<const GpuFamily* const> families,
                                               std::vector<ProgramText> programs,
                                               const FamilyCompilerOptions& options) {
    const DistinctPrograms wanted = distinct(std::move(programs));
    CompiledBefore once;
    CompiledBefore& known = options.before != nullptr ? *options.before : once;
    std::vector<ProgramText> unknown;
    for (const ProgramText& text : wanted.texts) {
        if (!known.programs.contains(text)) {
            unknown.push_back(text);
        }
    }
    if (!unknown.empty() || known.driver.empty()) {
        auto compiled = compiledNow(families, unknown, options);
        if (!compiled) {
            return tl::unexpected(compiled.error());
        }
        known.driver = std::move(compiled->driver);
        for (std::size_t i = 0; i < unknown.size(); ++i) {
            known.programs.emplace(std::move(unknown[i]), std::move(compiled->programs[i]));
        }
    }
    CompiledForFamilies all{known.driver, {}};
    for (const std::size_t index : wanted.indices) {
        all.programs.push_back(known.programs.at(wanted.texts[index]));
    }
    return all;
}

} // namespace patina
