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
#include "cli/long_work.h"
#include "gl/headless_context.h"
#include "material/preset_file.h"
#include "measure/stability/finding_text.h"
#include "measure/stability/stability_sweep.h"
#include "measure/stability/sweep_cases.h"

namespace patina {
namespace {

struct CheckOptions {
    std::string subject;
    /// Means every edge case and at least 300 000 cases where empty.
    std::optional<std::size_t> cases;
    bool json = false;
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

Checked<std::vector<EvalCase>> variantsOf(const Catalog& catalog, const std::string& subject) {
    std::error_code ignored; // a path that cannot be examined is not a file
    const bool file =
        std::filesystem::is_regular_file(subject, ignored) || subject.ends_with(".json");
    return file ? variantsOfPreset(catalog, subject) : variantsOfBlocks(catalog, subject);
}

/// Says how many cases are left out of a sweep that was asked for fewer than there are.
void tellLeftOut(const StabilitySweep& sweep, const SweepOptions& how) {
    const std::size_t leftOut = how.isWhole ? 0 : sweep.leftOut();
    if (leftOut > 0) {
        std::cerr << fmt::format("{} cases; {} that are tried without --cases are left out\n",
                                 sweep.plannedCases(), leftOut);
    }
}

void runSweep(StabilitySweep& sweep) {
    LongWork work;
    while (!sweep.finished() && !work.isStopped()) {
        sweep.step();
        work.tell(
            fmt::format("{:3.0f} %  {} cases ", 100.0 * sweep.progress(), sweep.report().cases));
    }
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
    std::cout << fmt::format("{} cases in {} programs{}: {}\n", report.cases, report.programs,
                             limitText(report), report.isClean() ? "nothing breaks" : "see above");
}

void print(const StabilitySweep& sweep, const CheckOptions& options) {
    if (!options.json) {
        printReport(sweep.report());
        return;
    }
    nlohmann::json json = toJson(sweep.report());
    json["subject"] = options.subject;
    json["finished"] = sweep.finished();
    json["withoutDouble"] = sweep.withoutReference();
    std::cout << writeJson(json);
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

/// Returns the exit status.
Checked<int> check(const CheckOptions& options) {
    const Catalog catalog = loadCatalog(standardBlockRoots());
    report(catalog.errors);
    const auto variants = variantsOf(catalog, options.subject);
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
    StabilitySweep sweep(*variants, how);
    tellLeftOut(sweep, how);
    runSweep(sweep);
    print(sweep, options);
    remark(sweep, how);
    if (!sweep.report().isClean()) {
        return 1;
    }
    return sweep.finished() ? 0 : LongWork::stoppedStatus;
}

} // namespace

void addCheck(CLI::App& program, int& status) {
    CLI::App* command = program.add_subcommand(
        "check", "Evaluate a preset or a block where formulas break, on the graphics device and\n"
                 "in double precision; the status is 1 when a value is not finite, negative or\n"
                 "inaccurate, and 130 when it was interrupted before one was found. Each finding "
                 "comes as a line for `patina eval`");
    auto options = std::make_shared<CheckOptions>();
    command
        ->add_option("subject", options->subject, "A preset, or the id of a model or other block")
        ->required();
    command
        ->add_option("--cases", options->cases,
                     "About how many cases to evaluate, shared out among the block's compiled\n"
                     "choices: an even part of all, and one with each choice at least. A case is\n"
                     "one pair of directions with one set of values, evaluated in both precisions\n"
                     "and counted once. Without this every edge-case pair is evaluated, 16 with\n"
                     "each set of edge-case values, and 300000 in all where those are fewer")
        ->check(CLI::Range(1UL, 100000000UL));
    command->add_flag("--json", options->json, "Print JSON");
    command->callback([options, &status] {
        const Checked<int> ended = check(*options);
        status = ended.value_or(1);
        if (!ended) {
            report(ended.error());
        }
    });
}

} // namespace patina
