// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/approximation/level_check.h"

#include <algorithm>
#include <chrono>
#include <filesystem>
#include <span>

#include <fmt/format.h>

#include "measure/approximation/written_block.h"
#include "measure/eval/eval_program.h"
#include "measure/stability/stability_sweep.h"
#include "measure/stability/sweep_cases.h"

namespace patina {
namespace {

constexpr std::uint32_t seedOfDevice = 3;
constexpr std::size_t firstRowOfDevice = 4096; ///< is behind the sets of values of the search
constexpr std::size_t casesAround = 12;        ///< are tried around each of the worst ones
constexpr std::size_t sweptCases = 60000;
constexpr double shareOfDevice = 0.3; ///< of the time, for the check and what is drawn after it
constexpr double minSecondsOfDevice = 5.0;
constexpr double secondsLonger = 3.0; ///< are about what checking one way takes

/// Returns what a sweep found that no level may give; null where there is nothing. What the claims
/// of the exact block are is not asked of its levels.
const SweepTally* brokenIn(const SweepReport& report) {
    for (const auto& [key, tally] : report.defects) {
        if (key.defect == Defect::NotANumber || key.defect == Defect::Infinite ||
            key.defect == Defect::Negative) {
            return &tally;
        }
    }
    return nullptr;
}

class DeviceCheck {
  public:
    DeviceCheck(const EvalCase& subject, CheaperWays& ways, const WrittenBlock& written,
                const std::filesystem::path& shaders, const CheaperSearchOptions& options,
                const std::function<bool()>& isStopped)
        : subject_(subject), ways_(ways), written_(written), shaders_(shaders), options_(options),
          isStopped_(isStopped) {}

    Checked<std::size_t> run() {
        const std::size_t count = std::min(options_.heldOut, casesOfFront);
        const CaseWish wish{count,
                            seedOfDevice,
                            firstRowOfDevice,
                            std::max<std::size_t>(count / 32, 1),
                            options_.ofValues,
                            true};
        cases_ = commonCases(subject_, wish);
        addWorst();
        exact_ = ways_.text->judged(texelsOfCases(cases_));
        std::vector<CheaperWay> kept;
        std::size_t unchecked = 0;
        for (std::size_t i = 0; i < ways_.ways.size(); ++i) {
            if (options_.isDeviceLate()) {
                ++unchecked;
                continue;
            }
            auto way = tried(i);
            if (!way) {
                return tl::unexpected(oneError(way.error()));
            }
            if (options_.isDeviceLate() && !isStopped_()) {
                ++unchecked; // its sweep was cut off
            } else if (*way) {
                kept.push_back(std::move(**way));
            }
        }
        if (unchecked > 0) {
            ways_.notes.push_back({{},
                                   0,
                                   0,
                                   fmt::format("the time was over before {} of {} ways could be "
                                               "checked on the graphics device: left out",
                                               unchecked, ways_.ways.size()),
                                   "a longer search"});
        }
        ways_.ways = frontOf(kept);
        return count_;
    }

  private:
    /// Adds the cases where ways are farthest off, and some around each of them.
    void addWorst() {
        std::uint32_t seed = seedOfDevice;
        for (const EvalCase& worst : ways_.worst) {
            const auto some = nearbyCases(worst, casesAround, options_.ofValues, seed++);
            cases_.push_back(worst);
            cases_.insert(cases_.end(), some.begin(), some.end());
        }
    }

    /// Leaves out ways than which a cheaper one states no larger an error. They are from the
    /// dearest to the cheapest.
    static std::vector<CheaperWay> frontOf(const std::vector<CheaperWay>& ways) {
        std::vector<CheaperWay> front;
        for (std::size_t i = 0; i < ways.size(); ++i) {
            const auto rest = std::span(ways).subspan(i + 1);
            if (std::ranges::none_of(rest, [&](const CheaperWay& cheaper) {
                    return statedError(cheaper) <= statedError(ways[i]);
                })) {
                front.push_back(ways[i]);
            }
        }
        return front;
    }

    std::string level(std::size_t index) const { return foundLevelId(index); }

    /// Returns the way with its error on the device; nothing where it breaks there.
    Result<std::optional<CheaperWay>> tried(std::size_t index) {
        CheaperWay way = ways_.ways[index];
        if (isStopped_()) {
            return way;
        }
        const auto worst = worstOnDevice(index);
        if (!worst) {
            return tl::unexpected(worst.error());
        }
        way.error = std::max(way.error, *worst);
        if (way.error > greatestErrorStatedAs(options_.maxError)) {
            leftOut(way,
                    fmt::format("at most {:.2g} off on the graphics device", statedError(way)));
            return std::nullopt;
        }
        return isSwept(index) ? std::optional(way) : std::nullopt;
    }

    Result<double> worstOnDevice(std::size_t index) {
        EvalCase own = subject_;
        own.block.block = written_.block;
        own.block.accuracy[written_.choice] = level(index);
        const auto program = EvalProgram::link(own, shaders_);
        if (!program) {
            return tl::unexpected(program.error());
        }
        double worst = 0.0;
        const std::size_t results = program->shape().results;
        for (std::size_t first = 0; first < cases_.size() && !options_.isDeviceLate();
             first += EvalProgram::largestDraw) {
            const std::size_t size = std::min(EvalProgram::largestDraw, cases_.size() - first);
            const auto drawn = program->draw(texels(own, first, size, *program), size);
            if (!drawn) {
                return tl::unexpected(drawn.error());
            }
            for (std::size_t i = 0; i < size; ++i) {
                const std::vector<double> got(
                    drawn->begin() + static_cast<std::ptrdiff_t>(i * results),
                    drawn->begin() + static_cast<std::ptrdiff_t>((i + 1) * results));
                const auto right = std::span(exact_.exact).subspan((first + i) * results, results);
                worst = std::max(worst, ways_.text->errorOf(right, got));
            }
        }
        count_ += cases_.size();
        return worst;
    }

    /// Returns the cases as the program of the written block reads them.
    std::vector<float> texels(const EvalCase& own, std::size_t first, std::size_t size,
                              const EvalProgram& program) const {
        std::vector<EvalCase> some(cases_.begin() + static_cast<std::ptrdiff_t>(first),
                                   cases_.begin() + static_cast<std::ptrdiff_t>(first + size));
        std::vector<float> all;
        for (EvalCase& each : some) {
            each.block.block = own.block.block;
            each.block.accuracy = own.block.accuracy;
        }
        const auto numbers = static_cast<std::size_t>(program.shape().caseTexels) * 4;
        for (const std::vector<double>& each : texelsOfCases(some)) {
            all.insert(all.end(), each.begin(), each.end());
            all.resize(all.size() + numbers - each.size());
        }
        return all;
    }

    void leftOut(const CheaperWay& way, const std::string& why) {
        ways_.notes.push_back(
            {{}, 0, 0, fmt::format("a way is left out, {}: {}", wordsOf(way), why), {}});
    }

    /// Sweeps the programs of a level.
    bool isSwept(std::size_t index) {
        std::vector<EvalCase> variants;
        for (EvalCase& variant : sweepVariants(*written_.catalog, *written_.block)) {
            const auto found = variant.block.accuracy.find(written_.choice);
            if (found != variant.block.accuracy.end() && found->second == level(index)) {
                variants.push_back(std::move(variant));
            }
        }
        EvalCase own = subject_;
        own.block.block = written_.block;
        own.block.accuracy[written_.choice] = level(index);
        variants.push_back(own);
        SweepOptions how;
        how.cpu = false;
        how.error = false;
        how.cases = sweptCases;
        how.isWhole = false;
        how.shaders = shaders_;
        StabilitySweep sweep(std::move(variants), how);
        while (!sweep.finished() && !isStopped_() && !options_.isDeviceLate()) {
            sweep.step();
        }
        count_ += sweep.report().cases;
        const SweepTally* const broken = brokenIn(sweep.report());
        if (broken != nullptr) {
            leftOut(ways_.ways[index], fmt::format("{} on the graphics device in {} cases, as {}",
                                                   wordsFor(broken->worst.defect), broken->count,
                                                   evalJson(broken->worst.request).dump()));
        }
        return broken == nullptr;
    }

    const EvalCase& subject_;
    CheaperWays& ways_;
    const WrittenBlock& written_;
    const std::filesystem::path& shaders_;
    const CheaperSearchOptions& options_;
    const std::function<bool()>& isStopped_;
    std::vector<EvalCase> cases_;
    JudgedCases exact_;
    std::size_t count_ = 0;
};

} // namespace

double secondsOfSearch(double seconds) {
    return seconds - std::min(std::max(shareOfDevice * seconds, minSecondsOfDevice), 0.5 * seconds);
}

std::function<bool()> isOverAfter(double seconds) {
    using Clock = std::chrono::steady_clock;
    return [began = Clock::now(), seconds] {
        return std::chrono::duration<double>(Clock::now() - began).count() >
               seconds + secondsLonger;
    };
}

Checked<std::size_t> checkedOnDevice(const EvalCase& subject, CheaperWays& ways,
                                     const std::filesystem::path& shaders,
                                     const CheaperSearchOptions& options,
                                     const std::function<bool()>& isStopped) {
    const auto written = writtenBlock(subject, ways, shaders);
    if (!written) {
        return tl::unexpected(written.error());
    }
    return DeviceCheck(subject, ways, *written, shaders, options, isStopped).run();
}

} // namespace patina
