// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/command.h"

#include <iostream>
#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "assets/asset_client.h"
#include "catalog/json_text.h"
#include "cli/cost_table.h"
#include "cli/environment_setup.h"
#include "cli/picture.h"
#include "cli/picture_options.h"
#include "cli/scene_meshes.h"
#include "cli/scene_setup.h"
#include "gl/headless_context.h"
#include "measure/cost_sweep.h"
#include "render/texture_loader.h"

namespace patina {
namespace {

constexpr glm::ivec2 usualSize{256, 256};

struct Options {
    std::vector<std::string> presets;
    PictureOptions picture;
    std::optional<double> budgetMilliseconds;
    std::optional<double> budgetError;
    bool ofPicture = false;
    bool singles = false;
    bool json = false;
    bool csv = false;
    double seconds = 60.0;

    bool hasBudget() const { return budgetMilliseconds || budgetError; }
};

/// A preset's chart.
struct Measured {
    std::string name;
    CostChart chart;
};

Errors oneError(Error error) {
    return {std::move(error)};
}

Checked<CostChart> swept(CostSweep::Subject subject, const Options& options) {
    CostSweep::Options wanted;
    wanted.size = options.picture.size;
    wanted.scope = options.ofPicture ? Choice::Scope::Picture : Choice::Scope::Material;
    wanted.programCache = programCacheFolder();
    wanted.seconds = options.seconds;
    wanted.combinations = !options.singles;
    auto sweep = CostSweep::create(std::move(subject), wanted);
    if (!sweep) {
        return tl::unexpected(oneError(sweep.error()));
    }
    while (!(*sweep)->finished()) {
        (*sweep)->step(std::chrono::seconds(1));
    }
    return (*sweep)->problems().empty() ? Checked<CostChart>((*sweep)->chart())
                                        : tl::unexpected((*sweep)->problems());
}

Checked<CostChart> chartOf(const std::string& preset, const Options& options,
                           const std::shared_ptr<const Catalog>& catalog, AssetClient& files) {
    const auto setup = sceneFor(preset, options.picture, *catalog);
    if (!setup) {
        return tl::unexpected(setup.error());
    }
    report(setup->notes);
    const auto loaded = SceneMeshes::load(setup->scene, files);
    if (!loaded) {
        return tl::unexpected(loaded.error());
    }
    report(loaded->remarks());
    TextureLoader textures(files);
    const auto environment = environmentPicture(setup->scene, options.picture, *catalog, files);
    if (!environment) {
        return tl::unexpected(oneError(environment.error()));
    }
    auto chart = swept({setup->scene, 0, setup->scene.camera,
                        [&loaded](const Object& object) { return loaded->view(object); }, catalog,
                        textures.source(), *environment},
                       options);
    report(textures.takeProblems());
    return chart;
}

std::string budgetText(const CostPoint& point, const BudgetAnswer& answer) {
    return fmt::format("{}: {}, {:.3f} ms, error {:.2e}\n",
                       answer.fits ? "the budget buys" : "no point fits the budget; the nearest is",
                       levelsText(point.levels), point.cost.milliseconds.median, errorOf(point));
}

/// False when nothing fits the budget.
bool printBudget(const CostChart& chart, const Options& options) {
    const auto answer =
        bestFor({options.budgetMilliseconds, options.budgetError}, chart.points);
    if (!answer) {
        return false;
    }
    (answer->fits && !options.json && !options.csv ? std::cout : std::cerr)
        << budgetText(chart.points[answer->point], *answer);
    return answer->fits;
}

nlohmann::json jsonOf(const Measured& measured, const Options& options) {
    nlohmann::json json = costJson(measured.chart);
    json["preset"] = measured.name;
    const auto answer =
        bestFor({options.budgetMilliseconds, options.budgetError}, measured.chart.points);
    if (options.hasBudget() && answer) {
        json["budget"] = {{"fits", answer->fits}, {"index", answer->point}};
    }
    return json;
}

void print(const std::vector<Measured>& all, const Options& options) {
    if (options.json) {
        nlohmann::json json = nlohmann::json::array();
        for (const Measured& each : all) {
            json.push_back(jsonOf(each, options));
        }
        std::cout << writeJson(json);
        return;
    }
    for (const Measured& each : all) {
        if (options.csv) {
            std::cout << costCsv(each.chart, each.name, &each == &all.front());
        } else {
            std::cout << each.name << '\n' << costText(each.chart);
        }
    }
}

/// True when every budget could be met.
Checked<bool> cost(const Options& options) {
    std::vector<std::string> presets = options.presets;
    if (presets.empty()) {
        if (options.picture.model.empty() && options.picture.scene.empty()) {
            return tl::unexpected(oneError(
                failure("there is nothing to measure", "a preset, --model or --scene").value()));
        }
        presets.emplace_back();
    }
    const auto catalog = std::make_shared<const Catalog>(loadCatalog(standardBlockRoots()));
    report(catalog->errors);
    const auto context = gl::HeadlessContext::create();
    if (!context) {
        return tl::unexpected(oneError(context.error()));
    }
    AssetClient files;
    std::vector<Measured> all;
    for (const std::string& preset : presets) {
        auto chart = chartOf(preset, options, catalog, files);
        if (!chart) {
            return tl::unexpected(chart.error());
        }
        all.push_back({preset.empty() ? options.picture.model : preset, std::move(*chart)});
    }
    print(all, options);
    bool met = true;
    for (const Measured& each : all) {
        met = (!options.hasBudget() || printBudget(each.chart, options)) && met;
    }
    return met;
}

void addBudgets(CLI::App& command, Options& options) {
    auto* time = command
                     .add_option("--budget-ms", options.budgetMilliseconds,
                                 "Pick the most accurate way whose frame takes no longer")
                     ->check(CLI::PositiveNumber);
    command
        .add_option("--budget-error", options.budgetError,
                    "Pick the fastest way of which 99 of 100 pixels are off by no greater share")
        ->check(CLI::NonNegativeNumber)
        ->excludes(time);
}

} // namespace

void addCost(CLI::App& program, int& status) {
    CLI::App* command = program.add_subcommand(
        "cost", "Measure what every accuracy choice of a preset costs and how wrong it is");
    auto options = std::make_shared<Options>();
    options->picture.size = usualSize;
    command->add_option("presets", options->presets, "Presets (*.patina.json)");
    addSceneOptions(*command, options->picture);
    addSizeOption(*command, options->picture);
    addBudgets(*command, *options);
    command->add_flag("--picture", options->ofPicture,
                      "The picture's own choices, such as samples, instead of the material's");
    command->add_flag("--singles", options->singles, "Each choice by itself, no combinations");
    command
        ->add_option("--seconds", options->seconds,
                     "No combination is begun after so long; slow frames are drawn less often")
        ->check(CLI::PositiveNumber)
        ->capture_default_str();
    auto* json = command->add_flag("--json", options->json, "Print an array of charts as JSON");
    command->add_flag("--csv", options->csv, "Print comma-separated values")->excludes(json);
    command->callback([options, &status] {
        const auto done = cost(*options);
        status = done && *done ? 0 : 1;
        if (!done) {
            report(done.error());
        }
    });
}

} // namespace patina
