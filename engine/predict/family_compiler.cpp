// SPDX-License-Identifier: GPL-3.0-or-later
#include "predict/family_compiler.h"

#include <chrono>
#include <map>
#include <optional>
#include <utility>

#include "assets/line_process.h"
#include "assets/sibling_program.h"

namespace patina {
namespace {

using Clock = std::chrono::steady_clock;
using namespace std::chrono_literals;

constexpr auto watchEvery = 50ms;
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

    /// Returns the next line; an error says why there is none.
    Result<std::string> line() {
        const double workBefore = process_.workSeconds();
        const auto began = Clock::now();
        while (true) {
            if (auto line = process_.line(watchEvery)) {
                return std::move(*line);
            }
            if (options_.isStopped()) {
                return tl::unexpected(stoppedError());
            }
            if (process_.hasEnded()) {
                return failure("compiling it for other graphics cards ended the compiler");
            }
            const std::chrono::duration<double> waited = Clock::now() - began;
            if (process_.workSeconds() - workBefore > options_.secondsEach ||
                waited.count() > clockFactor * options_.secondsEach) {
                return failure("compiling it for other graphics cards takes too long");
            }
        }
    }

  private:
    LineProcess process_;
    const FamilyCompilerOptions& options_;
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

/// Compiles programs, of which no two are the same.
Result<CompiledForFamilies> compiledNow(std::span<const GpuFamily* const> families,
                                        std::vector<ProgramText> programs,
                                        const FamilyCompilerOptions& options) {
    CompileRequest request = requestFor(families);
    request.programs = std::move(programs);
    const std::size_t count = request.programs.size();
    CompiledForFamilies compiled;
    do {
        auto process = LineProcess::start(
            {.program = options.program.empty() ? siblingProgram("patina-cost") : options.program,
             .input =
                 toJson(request).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace),
             .memoryBytes = options.memoryBytes,
             .stackBytes = stackBytes});
        if (!process) {
            return tl::unexpected(process.error());
        }
        Reader reader(std::move(*process), options);
        const auto driver = reader.line().and_then(driverIn);
        if (!driver) {
            return tl::unexpected(driver.error());
        }
        compiled.driver = *driver;
        const std::size_t before = compiled.programs.size();
        bool isAlive = true;
        while (isAlive && compiled.programs.size() < count) {
            const auto line = reader.line();
            isAlive = line.has_value();
            compiled.programs.push_back(isAlive ? familyStatisticsIn(*line)
                                                : tl::unexpected(line.error()));
            options.onProgress(double(compiled.programs.size()) / double(count));
        }
        if (options.isStopped()) {
            return tl::unexpected(stoppedError());
        }
        const auto done = std::ptrdiff_t(compiled.programs.size() - before);
        request.programs.erase(request.programs.begin(), request.programs.begin() + done);
    } while (!request.programs.empty());
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
