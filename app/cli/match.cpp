// SPDX-License-Identifier: GPL-3.0-or-later
#include <iostream>
#include <map>
#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "catalog/json_text.h"
#include "catalog/suggestion.h"
#include "cli/command.h"
#include "cli/cost_sweeps.h"
#include "cli/picture_options.h"
#include "cli/prepared_subject.h"
#include "gl/headless_context.h"
#include "material/preset_file.h"
#include "measure/match/model_matches.h"

namespace patina {
namespace {

/// Are the seconds for all models together, and the fewest pairs of frames of each: a table of many
/// fits needs no intervals.
constexpr double timingSeconds = 10.0;
constexpr int timingPairs = 3;

struct MatchRequest {
    std::string preset;
    std::string to;
    std::vector<std::string> models;
    bool allModels = false;
    std::string error = "log";
    std::size_t samples = 4096;
    double within = 2.0; ///< percent
    bool withoutTime = false;
    bool json = false;
    bool allowsOutside = false;
    std::string output;

    ReadingRights rights() const { return {.everything = allowsOutside}; }
};

Checked<Material> presetIn(const std::string& file, const Catalog& catalog,
                           const ReadingRights& rights) {
    auto reading = readPreset(file, catalog, rights);
    if (!reading) {
        return tl::unexpected(reading.error());
    }
    report(reading->notes);
    return std::move(reading->material);
}

/// Returns the materials that fits begin with: the preset's, and those of the models that are asked
/// for, with what they can take over of the wanted material or else their defaults.
Checked<std::vector<Material>> startsOf(const MatchRequest& request, const MatchAim& aim,
                                        const Catalog& catalog) {
    const auto startOf = [&](const Block& model) {
        return matchStart(defaultMaterial(model), aim, model, catalog);
    };
    std::vector<Material> starts;
    if (!request.preset.empty()) {
        const Checked<Material> material = presetIn(request.preset, catalog, request.rights());
        if (!material) {
            return tl::unexpected(material.error());
        }
        starts.push_back(*material);
    }
    if (request.allModels) {
        for (const Block* model : matchedModels(catalog)) {
            starts.push_back(startOf(*model));
        }
    }
    std::vector<std::string> known;
    for (const Block* model : catalog.ofKind(kinds::models)) {
        known.push_back(model->id);
    }
    for (const std::string& id : request.models) {
        const Block* model = catalog.find(kinds::models, id);
        if (model == nullptr) {
            return tl::unexpected(oneError(
                failure(fmt::format("there is no model \"{}\"", id), oneOf(id, known)).value()));
        }
        starts.push_back(startOf(*model));
    }
    return starts;
}

Errors checkRequest(const MatchRequest& request) {
    if (request.preset.empty() && request.models.empty() && !request.allModels) {
        return oneError(
            failure("nothing is to be fitted", "a preset, --model ID or --all-models").value());
    }
    return {};
}

/// Measures how long the fitted materials take per pixel. Without a graphics device the reason is
/// reported, and nothing is returned.
std::map<std::string, double> timesOf(const ModelMatches& matches,
                                      const std::shared_ptr<const Catalog>& catalog,
                                      LongWork& work) {
    const auto context = gl::HeadlessContext::create();
    if (!context) {
        report({context.error()});
        return {};
    }
    AssetClient files;
    CostRequest options;
    options.seconds = timingSeconds;
    options.pairs.min = timingPairs;
    const Tools tools{catalog, files, work};
    const auto subject = prepared({}, options.picture, *catalog, files);
    if (!subject) {
        report(subject.error());
        return {};
    }
    std::vector<Material> materials;
    for (const ModelMatch& row : matches.rows) {
        materials.push_back(row.material);
    }
    const auto measure = [&materials](CostSweep::Subject measured, const CostRequest& how,
                                      LongWork& during) {
        return ranked(std::move(measured), how, during, materials);
    };
    const auto costs = withSubject(*subject, options, tools, measure);
    if (!costs) {
        report(costs.error());
        return {};
    }
    std::map<std::string, double> nanoseconds;
    for (const ModelCost& cost : *costs) {
        nanoseconds[cost.model] = cost.cost.nanosecondsPerPixel;
    }
    return nanoseconds;
}

Result<void> writeBest(const ModelMatches& matches, const MatchRequest& request,
                       const Catalog& catalog) {
    if (request.output.empty() || matches.rows.empty()) {
        return {};
    }
    return writePreset(request.output, matches.rows.front().material, catalog);
}

/// Returns the exit status.
Checked<int> match(const MatchRequest& request) {
    if (const Errors wrong = checkRequest(request); !wrong.empty()) {
        return tl::unexpected(wrong);
    }
    const auto catalog = std::make_shared<const Catalog>(loadCatalog(standardBlockRoots()));
    report(catalog->errors);
    const auto aim = readMatchAim(request.to, *catalog, request.samples, request.rights());
    if (!aim) {
        return tl::unexpected(aim.error());
    }
    report(aim->notes);
    const auto starts = startsOf(request, *aim, *catalog);
    if (!starts) {
        return tl::unexpected(starts.error());
    }
    LongWork work;
    const FitOptions options{.error = *matchErrorOf(request.error)};
    ModelMatches matches =
        fittedMaterials(*starts, aim->target, options, *catalog, [&](double done, const auto&) {
            work.report(fmt::format("{:3.0f} %  fitting {} models ", 100.0 * done, starts->size()));
            return !work.isStopped();
        });
    if (!request.withoutTime && request.allModels && !work.isStopped()) {
        addTimes(matches, timesOf(matches, catalog, work));
    }
    report(matches.problems);
    if (request.json || !matches.rows.empty()) {
        std::cout << (request.json ? writeJson(matchesJson(matches))
                                   : matchesText(matches, request.within / 100.0));
    }
    if (const auto written = writeBest(matches, request, *catalog); !written) {
        return tl::unexpected(oneError(written.error()));
    }
    return work.isStopped() ? LongWork::stoppedStatus : matches.rows.empty() ? 1 : 0;
}

} // namespace

void addMatch(CLI::App& program, int& status) {
    CLI::App* command = program.add_subcommand(
        "match", "Find the values of models that look like another preset or a measured surface");
    auto options = std::make_shared<MatchRequest>();
    command->add_option("preset", options->preset, "Preset whose values are changed");
    command
        ->add_option("--to", options->to,
                     "What is to be matched: a preset, or a file of the MERL (.binary) or RGL "
                     "(.bsdf) collection")
        ->required();
    command->add_option("--model", options->models,
                        "Fit this model; it may be given several times");
    command->add_flag("--all-models", options->allModels,
                      "Fit every model that reflects light, and compare errors and times");
    command
        ->add_option("--error", options->error,
                     "What is made small: log of 1 + pi f cos (the default), relative, linear, or "
                     "lightness as the eye has it")
        ->check(CLI::IsMember(
            std::vector<std::string>(matchErrorWords().begin(), matchErrorWords().end())));
    command->add_option("--samples", options->samples, "Pairs of directions; 4096 without this")
        ->check(CLI::Range(16UL, 1000000UL));
    command
        ->add_option("--within", options->within,
                     "Name the quickest model with at most this error in percent; 2 without this")
        ->check(CLI::Range(0.0, 1000.0));
    command->add_flag("--no-time", options->withoutTime, "Measure no times");
    command->add_flag("--json", options->json, "Print JSON");
    addAllowOutside(*command, options->allowsOutside);
    command->add_option("-o,--output", options->output, "Write the best fit as a preset");
    command->callback([options, &status] {
        const Checked<int> ended = match(*options);
        status = ended.value_or(1);
        if (!ended) {
            report(ended.error());
        }
    });
}

} // namespace patina
