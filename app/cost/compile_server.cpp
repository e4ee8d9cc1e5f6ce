// SPDX-License-Identifier: GPL-3.0-or-later
#include "cost/compile_server.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <numeric>
#include <optional>
#include <set>
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

/// Returns how often the driver's compiler takes what is in so many loops to run whose rounds it
/// does not count: 8 times, in a loop within another 4 times that, and farther in twice that.
double guessedRuns(std::size_t depth) {
    return depth == 0 ? 1.0 : depth == 1 ? 8.0 : 16.0 * std::exp2(static_cast<double>(depth) - 1.0);
}

/// Corrects what a compiler guesses of loops whose rounds are constants. The program is compiled
/// with one round of each of them: what the guess has more are its other rounds, and those of the
/// loops within, which are guessed to be fewer then. So what one round of each loop takes is told
/// from the innermost on. Loops with as many rounds that have no loops around or in them are taken
/// together.
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
        std::vector<Round> rounds(groups_.size()); // behind those that are in them
        for (std::size_t i = groups_.size(); i-- > 0 && guessed;) {
            auto single = std::exchange(groups_[i].single, std::nullopt);
            single = single ? single : fragmentOf(groups_[i].once, device, false);
            if (!single) {
                return;
            }
            const Group& own = groups_[i];
            Round left{guessed->cycles - single->cycles, guessed->latency - single->latency};
            for (std::size_t inner = i + 1; inner < groups_.size(); ++inner) {
                if (isAround(own, groups_[inner])) {
                    const double fewer = runsMore(groups_[inner]);
                    left.cycles -= fewer * rounds[inner].cycles;
                    left.latency -= fewer * rounds[inner].latency;
                }
            }
            rounds[i] = {left.cycles / runsMore(own), left.latency / runsMore(own)};
            const double more = own.runs - guessedRuns(own.depth);
            stage.cycles += more * rounds[i].cycles;
            stage.latency += more * rounds[i].latency;
            stage.loops -= static_cast<int>(own.loops.size());
        }
        stage.cycles = std::round(stage.cycles);
        stage.latency = std::round(stage.latency);
    }

  private:
    /// Is what one round of a loop takes, without those in it.
    struct Round {
        double cycles = 0.0;
        double latency = 0.0;
    };

    /// Are loops of equally many rounds that the driver leaves.
    struct Group {
        std::vector<std::size_t> loops; ///< are places among the counted ones
        SpirvProgram once;
        std::optional<StageStatistics> single; ///< is `once` on the first device
        std::size_t depth = 1;                 ///< counts the loops around that are left, and it
        double runs = 1.0;                     ///< is how often it runs with those around it
    };

    /// Returns how much oftener what is in loops runs than it would without one of them.
    static double runsMore(const Group& group) {
        return guessedRuns(group.depth) - guessedRuns(group.depth - 1);
    }

    bool isAround(const Group& outer, const Group& inner) const {
        const std::vector<std::size_t>& around = loops_[inner.loops.front()].around;
        return std::ranges::find(around, outer.loops.front()) != around.end();
    }

    /// Tells whether a loop has no other in or around it.
    bool isAlone(std::size_t loop) const {
        return loops_[loop].around.empty() && loops_[loop].othersAround == 0 &&
               std::ranges::none_of(loops_, [loop](const CountedLoop& other) {
                   return std::ranges::find(other.around, loop) != other.around.end();
               });
    }

    std::size_t outermost(std::size_t loop) const {
        return loops_[loop].around.empty() ? loop : loops_[loop].around.front();
    }

    void group(const NullDevice& device) {
        isGrouped_ = true;
        if (loops_.empty()) {
            return;
        }
        guessed_ = fragmentOf(program_, device, true);
        if (!guessed_) {
            return;
        }
        const auto once = fragmentOf(withOneRoundOf(everyLoop()), device, true);
        int open = once ? guessed_->loops - once->loops : 0; // counts those that the driver leaves
        std::set<std::size_t> unclear;
        for (const std::vector<std::size_t>& loops : likelyLeft()) {
            if (open <= 0) {
                break;
            }
            if (isAdded(loops, device, open)) {
                continue;
            }
            for (const std::size_t loop : loops) {
                if ((loops.size() == 1 || !isAdded({loop}, device, open)) && !isAlone(loop)) {
                    unclear.insert(outermost(loop));
                }
            }
        }
        std::erase_if(groups_, [&](const Group& each) {
            return unclear.contains(outermost(each.loops.front()));
        });
        std::ranges::sort(groups_, {}, [](const Group& each) { return each.loops.front(); });
        for (Group& each : groups_) {
            const CountedLoop& loop = loops_[each.loops.front()];
            each.depth += static_cast<std::size_t>(loop.othersAround);
            each.runs = loop.rounds;
            for (const Group& outer : groups_) {
                if (isAround(outer, each)) {
                    ++each.depth;
                    each.runs *= loops_[outer.loops.front()].rounds;
                }
            }
            each.runs *= guessedRuns(static_cast<std::size_t>(loop.othersAround));
        }
    }

    std::vector<std::size_t> everyLoop() const {
        std::vector<std::size_t> all(loops_.size());
        std::iota(all.begin(), all.end(), std::size_t(0));
        return all;
    }

    /// Returns the loops, those with equally many rounds and no other in or around them together:
    /// first those that are most to write out, which the driver rather leaves.
    std::vector<std::vector<std::size_t>> likelyLeft() const {
        std::map<int, std::vector<std::size_t>> alone;
        std::vector<std::vector<std::size_t>> all;
        for (const std::size_t loop : everyLoop()) {
            if (isAlone(loop)) {
                alone[loops_[loop].rounds].push_back(loop);
            } else {
                all.push_back({loop});
            }
        }
        for (auto& [rounds, loops] : alone) {
            all.push_back(std::move(loops));
        }
        std::ranges::stable_sort(all, std::ranges::greater(), [this](const auto& loops) {
            const CountedLoop& loop = loops_[loops.front()];
            return loop.instructions * static_cast<std::size_t>(loop.rounds);
        });
        return all;
    }

    SpirvProgram withOneRoundOf(const std::vector<std::size_t>& loops) const {
        std::vector<CountedLoop> some;
        for (const std::size_t loop : loops) {
            some.push_back(loops_[loop]);
        }
        SpirvProgram made = program_;
        made.fragment = withOneRound(program_.fragment, some);
        return made;
    }

    /// Adds loops that the driver leaves all, and nothing where it has written them all out.
    /// Returns false where it leaves some of them, or others in another program. Those that are
    /// added are no longer open.
    bool isAdded(const std::vector<std::size_t>& loops, const NullDevice& device, int& open) {
        Group made{loops, withOneRoundOf(loops), std::nullopt};
        made.single = fragmentOf(made.once, device, true);
        if (made.single && made.single->loops == guessed_->loops) {
            return true;
        }
        const int left = guessed_->loops - static_cast<int>(loops.size());
        if (!made.single || made.single->loops != left) {
            return false;
        }
        open -= static_cast<int>(loops.size());
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
    std::vector<Group> groups_;              ///< have those around before those within
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
