// SPDX-License-Identifier: GPL-3.0-or-later
#include "cost/compile_server.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <span>
#include <utility>
#include <variant>
#include <vector>

#include "cost/mali_core.h"
#include "predict/compile_request.h"
#include "predict/gpu_family.h"
#include "vulkan/null_device.h"
#include "vulkan/spirv_loops.h"
#include "vulkan/spirv_program.h"

namespace patina {
namespace {

int number(const NullDevice::Statistics& statistics, const std::string& name) {
    const auto found = statistics.find(name);
    return found == statistics.end() ? 0 : int(found->second);
}

/// Returns GpuFamily::lookUpCycles() of a family by its id.
double lookUpCycles(const std::string& family) {
    const auto found = std::ranges::find(gpuFamilies(), family, &GpuFamily::id);
    return found == gpuFamilies().end() ? 0.0 : found->lookUpCycles();
}

/// Reading texels counts as if nothing were computed meanwhile: how much of it other waves hide is
/// not known.
StageStatistics stageStatistics(const NullDevice::Statistics& numbers, double cyclesOfLookUp) {
    StageStatistics stage;
    stage.instructions = number(numbers, "Instructions");
    stage.vectorRegisters = number(numbers, "VGPRs");
    stage.scalarRegisters = number(numbers, "SGPRs");
    stage.spilledRegisters = number(numbers, "Spilled VGPRs") + number(numbers, "Spilled SGPRs");
    stage.waves = number(numbers, "Subgroups per SIMD");
    stage.lanesOfWave = number(numbers, "Subgroup size");
    stage.loops = number(numbers, "Loops");
    stage.latency = number(numbers, "Latency");
    stage.cycles =
        number(numbers, "Inverse Throughput") + cyclesOfLookUp * number(numbers, "Look-ups");
    return stage;
}

/// Is how often the driver's compiler takes a loop to run whose rounds it does not count.
constexpr double guessedRounds = 8.0;

/// Corrects what a compiler guesses of loops whose rounds are constants. The program is compiled
/// with one round of such loops; what the guess has more than that are their other rounds. Loops
/// with as many rounds are taken together, since the guess is as far off in each.
class KnownRounds {
  public:
    explicit KnownRounds(const SpirvProgram& program) : program_(program) {
        if (auto optimised = optimisedSpirv(program.fragment)) {
            program_.fragment = std::move(*optimised);
            loops_ = countedLoops(program_.fragment);
        }
    }

    /// Corrects the cycles of a fragment stage. The loops that are left in it are those that are
    /// still guessed. Which loops the driver leaves is asked of the first device, as all chips have
    /// that from the same passes, and telling it takes the driver long.
    void correct(StageStatistics& stage, const NullDevice& device, double cyclesOfLookUp) {
        cyclesOfLookUp_ = cyclesOfLookUp;
        if (!isGrouped_) {
            group(device);
        }
        auto guessed = std::exchange(guessed_, std::nullopt);
        if (!guessed && !groups_.empty()) {
            guessed = fragmentOf(program_, device, false);
        }
        for (Group& each : groups_) {
            auto single = std::exchange(each.single, std::nullopt);
            if (!single) {
                single = fragmentOf(each.once, device, false);
            }
            if (guessed && single) {
                const double more = (each.rounds - guessedRounds) / (guessedRounds - 1.0);
                stage.cycles += more * (guessed->cycles - single->cycles);
                stage.latency += more * (guessed->latency - single->latency);
                stage.loops -= each.loops;
            }
        }
        stage.cycles = std::round(stage.cycles);
        stage.latency = std::round(stage.latency);
    }

  private:
    /// Are loops of equally many rounds.
    struct Group {
        int rounds = 0;
        int loops = 0;
        SpirvProgram once;
        std::optional<StageStatistics> single; ///< is `once` on the first device
    };

    void group(const NullDevice& device) {
        isGrouped_ = true;
        if (loops_.empty()) {
            return;
        }
        guessed_ = fragmentOf(program_, device, true);
        std::map<int, std::vector<CountedLoop>> byRounds;
        for (const CountedLoop& loop : loops_) {
            byRounds[loop.rounds].push_back(loop);
        }
        for (const auto& [rounds, loops] : byRounds) {
            if (!isAdded(loops, device) && loops.size() > 1) {
                for (const CountedLoop& loop : loops) {
                    isAdded({&loop, 1}, device);
                }
            }
        }
    }

    /// Adds loops that the driver leaves all: it may have counted the rounds itself, with no loop
    /// left.
    bool isAdded(std::span<const CountedLoop> loops, const NullDevice& device) {
        Group made{loops.front().rounds, static_cast<int>(loops.size()), program_, std::nullopt};
        made.once.fragment = withOneRound(program_.fragment, loops);
        made.single = fragmentOf(made.once, device, true);
        if (!guessed_ || !made.single || made.single->loops != guessed_->loops - made.loops) {
            return false;
        }
        groups_.push_back(std::move(made));
        return true;
    }

    std::optional<StageStatistics> fragmentOf(const SpirvProgram& program, const NullDevice& device,
                                              bool countsLoops) const {
        auto stages = device.compile(program, countsLoops);
        return stages ? std::optional(stageStatistics((*stages)["fragment"], cyclesOfLookUp_))
                      : std::nullopt;
    }

    SpirvProgram program_;
    double cyclesOfLookUp_ = 0.0; ///< is of the device that is corrected for
    std::vector<CountedLoop> loops_;
    bool isGrouped_ = false;
    std::vector<Group> groups_;
    std::optional<StageStatistics> guessed_; ///< is the program on the first device
};

/// Compiles for one family, with a null device or with malioc.
class FamilyTarget {
  public:
    static Result<FamilyTarget> create(const CompileRequest::Family& family) {
        const auto target = [&family](auto made) { return FamilyTarget(family, std::move(made)); };
        return family.isMali
                   ? MaliCore::create(family.chips.empty() ? "" : family.chips.front()).map(target)
                   : NullDevice::create(family.chips).map(target);
    }

    const std::string& family() const { return family_; }

    std::string compiler() const {
        const auto* core = std::get_if<MaliCore>(&compiler_);
        return core != nullptr ? core->compiler() : std::get<NullDevice>(compiler_).driver();
    }

    /// `rounds` is made when it is needed the first time, and used by all families.
    Result<PipelineStatistics> compile(const SpirvProgram& program,
                                       std::optional<KnownRounds>& rounds) const {
        if (const auto* core = std::get_if<MaliCore>(&compiler_)) {
            return core->compile(program);
        }
        const auto& device = std::get<NullDevice>(compiler_);
        auto stages = device.compile(program);
        if (!stages) {
            return tl::unexpected(stages.error());
        }
        PipelineStatistics statistics{stageStatistics((*stages)["vertex"], cyclesOfLookUp_),
                                      stageStatistics((*stages)["fragment"], cyclesOfLookUp_)};
        if (statistics.fragment.loops > 0) {
            if (!rounds) {
                rounds.emplace(program);
            }
            rounds->correct(statistics.fragment, device, cyclesOfLookUp_);
        }
        return statistics;
    }

  private:
    FamilyTarget(const CompileRequest::Family& family, std::variant<NullDevice, MaliCore> compiler)
        : family_(family.id), cyclesOfLookUp_(lookUpCycles(family.id)),
          compiler_(std::move(compiler)) {}

    std::string family_;
    double cyclesOfLookUp_; ///< is GpuFamily::lookUpCycles()
    std::variant<NullDevice, MaliCore> compiler_;
};

Result<FamilyStatistics> compiled(const ProgramText& text,
                                  const std::vector<FamilyTarget>& targets) {
    const auto program = spirvProgram(text.vertex, text.fragment);
    if (!program) {
        return tl::unexpected(program.error());
    }
    std::optional<KnownRounds> rounds;
    FamilyStatistics answer;
    for (const FamilyTarget& target : targets) {
        auto statistics = target.compile(*program, rounds);
        if (!statistics) {
            return tl::unexpected(statistics.error());
        }
        answer[target.family()] = *statistics;
    }
    return answer;
}

/// Returns the names of the compilers, each once.
std::string compilersOf(const std::vector<FamilyTarget>& targets) {
    std::string names;
    for (const FamilyTarget& target : targets) {
        if (const std::string name = target.compiler(); names.find(name) == std::string::npos) {
            names += (names.empty() ? "" : " and ") + name;
        }
    }
    return names;
}

} // namespace

int serveCompilation(const std::string& text,
                     const std::function<void(const std::string&)>& report) {
    const auto tellError = [&](const Error& error) {
        report(nlohmann::json{{"error", error.text()}}.dump());
        return 1;
    };
    const auto request = compileRequestIn(text);
    if (!request) {
        return tellError(request.error());
    }
    std::vector<FamilyTarget> targets;
    for (const CompileRequest::Family& family : request->families) {
        auto target = FamilyTarget::create(family);
        if (!target) {
            return tellError(target.error());
        }
        targets.push_back(std::move(*target));
    }
    report(nlohmann::json{{"driver", compilersOf(targets)}}.dump());
    for (const ProgramText& program : request->programs) {
        report(toJson(compiled(program, targets)).dump());
    }
    return 0;
}

} // namespace patina
