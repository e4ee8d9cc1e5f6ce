// SPDX-License-Identifier: GPL-3.0-or-later
#include <filesystem>
#include <iostream>
#include <memory>
#include <optional>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "catalog/json_text.h"
#include "catalog/suggestion.h"
#include "cli/command.h"
#include "cli/half_check.h"
#include "cli/job.h"
#include "cli/long_work.h"
#include "cli/option_families.h"
#include "gl/headless_context.h"
#include "material/preset_file.h"
#include "measure/approximation/approximation_subject.h"
#include "measure/stability/finding_text.h"
#include "measure/stability/stability_sweep.h"
#include "measure/stability/sweep_cases.h"

namespace patina {
namespace {

struct CheckOptions {
    std::vector<std::string> subjects;
    /// Means every edge case and at least 300 000 cases where empty.
    std::optional<std::size_t> cases;
    bool json = false;
    bool inHalf = false; ///< says which lines survive floats of 16 bits instead
    double halfLimit = 1.0 / 255.0;
    HalfCheckWish half; ///< says what else is told of floats of 16 bits
    JobOptions job;
};

/// Returns the blocks of that id, or of that "kind/id"; the same id may be a model and another
/// block.
std::vector<const Block*> blocksNamed(const Catalog& catalog, const std::string& name) {
    std::vector<const Block*> found;
    for (const Block& block : catalog.blocks) {
        const bool named = block.id == name || block.kind + '/' + block.id == name;
        if (named && !evaluatedFunctions(block).empty()) {
            found.push_back(&block);
        }
    }
    return found;
}

Checked<std::vector<EvalCase>> variantsOfBlocks(const Catalog& catalog, const std::string& name) {
    std::vector<EvalCase> variants;
    for (const Block* block : blocksNamed(catalog, name)) {
        const std::vector<EvalCase> own = sweepVariants(catalog, *block);
        variants.insert(variants.end(), own.begin(), own.end());
    }
    if (variants.empty()) {
        std::vector<std::string> ids;
        for (const Block* model : catalog.ofKind(kinds::models)) {
            ids.push_back(model->id);
        }
        for (const Block& block : catalog.blocks) {
            if (block.id == name || block.kind + '/' + block.id == name) {
                return tl::unexpected(
                    oneError(failure(fmt::format("\"{}\" gives no single values to check", name),
                                     "a preset, or a block of a kind that `patina eval` takes")
                                 .value()));
            }
        }
        return tl::unexpected(oneError(
            failure(fmt::format("\"{}\" is neither a preset nor a block", name), oneOf(name, ids))
                .value()));
    }
    return variants;
}

/// Returns a material's model as it is set, and its Fresnel block where the model has no slot for
/// it.
Checked<std::vector<EvalCase>> variantsOfPreset(const Catalog& catalog, const std::string& file) {
    const auto reading = readPreset(file, catalog);
    if (!reading) {
        return tl::unexpected(reading.error());
    }
    report(reading->notes);
    const Result<EvalCase> variant = sweepVariant(catalog, reading->material);
    if (!variant) {
        return tl::unexpected(oneError(variant.error()));
    }
    std::vector<EvalCase> variants{*variant};
    const std::vector<EvalCase> blend = blendVariants(catalog, reading->material);
    variants.insert(variants.end(), blend.begin(), blend.end());
    return variants;
}

bool isFile(const std::string& subject) {
    std::error_code ignored; // a path that cannot be examined is not a file
    return std::filesystem::is_regular_file(subject, ignored) || subject.ends_with(".json");
}

Checked<std::vector<EvalCase>> variantsOf(const Catalog& catalog, const std::string& subject) {
    return isFile(subject) ? variantsOfPreset(catalog, subject)
                           : variantsOfBlocks(catalog, subject);
}

/// Returns the cases that are evaluated in 16 bits: blocks with their defaults, or what a preset
/// has.
Checked<std::vector<EvalCase>> halfSubjects(const Catalog& catalog, const std::string& subject) {
    auto all = variantsOf(catalog, subject);
    if (!all || isFile(subject)) {
        return all;
    }
    std::vector<EvalCase> blocks;
    for (const Block* block : blocksNamed(catalog, subject)) {
        auto made = defaultCase(catalog, *block);
        if (!made) {
            return tl::unexpected(made.error());
        }
        blocks.push_back(std::move(*made));
    }
    return blocks;
}

/// Returns which lines survive floats of 16 bits; nothing where it is stopped meanwhile.
Checked<std::optional<HalfReport>> halfReportOf(const EvalCase& subject, bool hasOwnValues,
                                                const Catalog& catalog, double limit,
                                                LongWork& work) {
    const auto progress = [&work](double share) {
        work.report(fmt::format("{:3.0f} %  of the lines ", 100.0 * share));
        return !work.isStopped();
    };
    auto made = halfReport(subject, catalog.roots.front().folder, hasOwnValues, limit, progress);
    work.report({});
    if (!made && !work.isStopped()) {
        return tl::unexpected(made.error());
    }
    return made ? std::optional(std::move(*made)) : std::nullopt;
}

/// Prints which lines of the subjects survive floats of 16 bits, or of those before it is stopped;
/// returns the exit status.
Checked<int> checkInHalf(const Catalog& catalog, const CheckOptions& options) {
    LongWork work;
    nlohmann::json all = nlohmann::json::array();
    std::unique_ptr<gl::HeadlessContext> context;
    if (options.half.isTimed) {
        auto made = gl::HeadlessContext::create();
        if (!made) {
            return tl::unexpected(oneError(made.error()));
        }
        context = std::move(*made);
    }
    for (const std::string& subject : options.subjects) {
        if (work.isStopped()) {
            break;
        }
        const auto cases = halfSubjects(catalog, subject);
        if (!cases) {
            return tl::unexpected(cases.error());
        }
        for (const EvalCase& each : *cases) {
            const auto made = halfReportOf(each, isFile(subject), catalog, options.halfLimit, work);
            if (!made) {
                return tl::unexpected(made.error());
            }
            if (!*made) {
                break; // it was stopped
            }
            const std::string name = each.block.block->kind + '/' + each.block.block->id;
            const MixedForm mixed = mixedForm(each, **made, options.half, work);
            if (options.json) {
                all.push_back(halfJson(**made, name, mixed));
            } else {
                std::cout << halfText(**made, name, mixed);
            }
        }
    }
    if (options.json) {
        std::cout << writeJson(all);
    }
    if (work.isStopped()) {
        std::cerr << "stopped: this is what was found so far\n";
    }
    return work.isStopped() ? LongWork::stoppedStatus : 0;
}

/// Says how many cases are left out of a sweep that was asked for fewer than there are.
void tellLeftOut(const StabilitySweep& sweep, const SweepOptions& how) {
    const std::size_t leftOut = how.isWhole ? 0 : sweep.leftOut();
    if (leftOut > 0) {
        std::cerr << fmt::format("{} cases; {} that are tried without --cases are left out\n",
                                 sweep.plannedCases(), leftOut);
    }
}

void runSweep(StabilitySweep& sweep, LongWork& work) {
    while (!sweep.finished() && !work.isStopped()) {
        sweep.step();
        work.report(
            fmt::format("{:3.0f} %  {} cases ", 100.0 * sweep.progress(), sweep.report().cases));
    }
    work.report({});
}

void printFinding(const SweepKey& key, const SweepTally& tally) {
    const std::string programs = variantText(tally.worst.request);
    std::cout << fmt::format("{} {}: {} cases{}\n  worst: {}\n  {}\n  {}\n", wordsFor(key.defect),
                             precisionText(key.gpu), tally.count,
                             programs.empty() ? "" : ", the worst with " + programs,
                             placeText(tally.worst.request), amountText(tally.worst),
                             evalJson(tally.worst.request).dump());
}

void printReport(const SweepReport& report) {
    for (const auto& [key, tally] : report.defects) {
        printFinding(key, tally);
    }
    for (const Error& error : report.errors) {
        std::cout << error.text() << '\n';
    }
    std::cout << fmt::format("{} cases in {} program{}{}: {}\n", report.cases, report.programs,
                             report.programs == 1 ? "" : "s", limitText(report),
                             report.isClean() ? "nothing breaks" : "see above");
}

nlohmann::json jsonOf(const StabilitySweep& sweep, const std::string& subject) {
    nlohmann::json json = toJson(sweep.report());
    json["subject"] = subject;
    json["finished"] = sweep.finished();
    json["withoutDouble"] = sweep.withoutReference();
    return json;
}

/// Writes to standard error what could not be checked.
void remark(const StabilitySweep& sweep, const SweepOptions& how) {
    if (!sweep.withoutReference().empty()) {
        std::cerr << "not checked in double precision: " << sweep.withoutReference() << '\n';
    }
    if (!how.gpu) {
        std::cerr << "not checked on the graphics device: there is none\n";
    }
    if (!sweep.finished()) {
        std::cerr << fmt::format("stopped after {} cases\n", sweep.report().cases);
    }
}

/// Checks the presets of a job.
class CheckWork : public JobWork {
  public:
    CheckWork(const Catalog& catalog, const SweepOptions& how, LongWork& longWork)
        : catalog_(catalog), how_(how), longWork_(longWork) {}

    Checked<nlohmann::json> resultOf(const std::string& subject) override {
        auto variants = variantsOf(catalog_, subject);
        if (!variants) {
            return tl::unexpected(variants.error());
        }
        StabilitySweep sweep(std::move(*variants), how_);
        runSweep(sweep, longWork_);
        return jsonOf(sweep, subject);
    }

    bool isGood(const nlohmann::json& result) const override {
        return result.value("sound", false);
    }

  private:
    const Catalog& catalog_;
    const SweepOptions& how_;
    LongWork& longWork_;
};

/// Returns the variants of every subject, so that a mistake in the last one costs no sweep.
Checked<std::vector<std::vector<EvalCase>>> allVariants(const Catalog& catalog,
                                                        const std::vector<std::string>& subjects) {
    std::vector<std::vector<EvalCase>> all;
    for (const std::string& subject : subjects) {
        auto variants = variantsOf(catalog, subject);
        if (!variants) {
            return tl::unexpected(variants.error());
        }
        all.push_back(std::move(*variants));
    }
    return all;
}

/// Checks subjects one after the other and prints what was found; returns the exit status.
int checkAll(const CheckOptions& options, std::vector<std::vector<EvalCase>> variants,
             const SweepOptions& how, LongWork& work) {
    nlohmann::json found = nlohmann::json::array();
    bool isClean = true;
    for (std::size_t i = 0; i < variants.size() && (i == 0 || !work.isStopped()); ++i) {
        const std::string& subject = options.subjects[i];
        StabilitySweep sweep(std::move(variants[i]), how);
        tellLeftOut(sweep, how);
        runSweep(sweep, work);
        if (options.json) {
            found.push_back(jsonOf(sweep, subject));
        } else {
            std::cout << (variants.size() > 1 ? subject + '\n' : std::string());
            printReport(sweep.report());
        }
        remark(sweep, how);
        isClean = isClean && sweep.report().isClean();
    }
    if (options.json) {
        std::cout << writeJson(variants.size() > 1 ? found : found.front());
    }
    return !isClean ? 1 : work.isStopped() ? LongWork::stoppedStatus : 0;
}

/// Returns the exit status.
Checked<int> check(const CLI::App& command, const CheckOptions& options) {
    const Catalog catalog = loadCatalog(standardBlockRoots());
    report(catalog.errors);
    if (options.inHalf) {
        return checkInHalf(catalog, options);
    }
    auto variants = allVariants(catalog, options.job.isWanted() ? std::vector<std::string>()
                                                                : options.subjects);
    if (!variants) {
        return tl::unexpected(variants.error());
    }
    const auto context = gl::HeadlessContext::create();
    if (!context) {
        report({context.error()});
    }
    SweepOptions how;
    how.gpu = context.has_value();
    how.cases = options.cases.value_or(how.cases);
    how.isWhole = !options.cases;
    how.shaders = catalog.roots.front().folder;
    LongWork longWork;
    if (options.job.isWanted()) {
        CheckWork work(catalog, how, longWork);
        return runJob({command, options.job, options.subjects, catalog}, work, longWork);
    }
    return checkAll(options, std::move(*variants), how, longWork);
}

} // namespace

void addCheck(CLI::App& program, int& status) {
    CLI::App* command = program.add_subcommand(
        "check", "Evaluate presets or blocks where formulas break, on the graphics device and\n"
                 "in double precision; the status is 1 when a value is not finite, negative or\n"
                 "inaccurate, and 130 when it was interrupted before one was found. Each finding "
                 "comes as a line for `patina eval`");
    auto options = std::make_shared<CheckOptions>();
    command->add_option("subjects", options->subjects, "Presets, or ids of models or other blocks")
        ->required();
    command
        ->add_option("--cases", options->cases,
                     "About how many cases to evaluate, shared out among the block's compiled\n"
                     "choices: an even part of all, and one with each choice at least. A case is\n"
                     "one pair of directions with one set of values, evaluated in both precisions\n"
                     "and counted once. Without this every edge-case pair is evaluated, 16 with\n"
                     "each set of edge-case values, and 300000 in all where those are fewer")
        ->check(CLI::Range(1UL, 100000000UL));
    auto* json = command->add_flag("--json", options->json, "Print JSON, an array for several");
    auto* results = addJobOptions(*command, options->job)->excludes(json);
    auto* precision = command->add_option_function<std::string>(
        "--precision", [options](const std::string& word) { options->inHalf = word == "half"; },
        "half: say instead which lines of a block survive floats of 16 bits, and which break");
    precision->check(CLI::IsMember({"half"}))->excludes(results)->excludes("--cases");
    command
        ->add_option("--error", options->halfLimit,
                     "With --precision half: what a line may be off and hold, from 0.0001 on,\n"
                     "which is what floats of 16 bits tell apart; 0.0039 without this")
        ->check(CLI::Range(0.0001, 1.0))
        ->needs(precision);
    addFamiliesOption(*command, options->half.families)->needs(precision);
    command
        ->add_flag("--time", options->half.isTimed,
                   "With --precision half: time the lines that hold, in 16 bits, on the graphics\n"
                   "device that is here")
        ->needs(precision);
    command
        ->add_flag("--source", options->half.hasText,
                   "With --precision half: print the program with those lines in 16 bits")
        ->needs(precision);
    command->callback([command, options, &status] {
        const Checked<int> ended = check(*command, *options);
        status = ended.value_or(1);
        if (!ended) {
            report(ended.error());
        }
    });
}

} // namespace patina
