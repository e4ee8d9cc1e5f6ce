// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/command.h"

#include <iostream>
#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "assets/asset_client.h"
#include "catalog/json_text.h"
#include "cli/cost_plot.h"
#include "cli/environment_setup.h"
#include "cli/picture.h"
#include "cli/picture_options.h"
#include "cli/scene_meshes.h"
#include "cli/scene_setup.h"
#include "core/display_image.h"
#include "gl/headless_context.h"
#include "measure/cost_sweep.h"
#include "measure/cost_table.h"
#include "measure/error_colors.h"
#include "measure/ranking_table.h"
#include "measure/scaling_sweep.h"
#include "render/texture_loader.h"

namespace patina {
namespace {

constexpr glm::ivec2 usualSize{256, 256};
constexpr glm::ivec2 plotSize{960, 600};

struct Options {
    std::vector<std::string> presets;
    PictureOptions picture;
    std::optional<double> budgetMilliseconds;
    std::optional<double> budgetError;
    bool ofPicture = false;
    bool singles = false;
    bool allModels = false;
    bool scaling = false;
    bool json = false;
    bool csv = false;
    std::string plot;
    std::string errorMap;
    double seconds = 60.0;

    bool hasBudget() const { return budgetMilliseconds || budgetError; }
};

/// A chart, and where the point that the budget buys, or else the fastest one, goes wrong.
struct Sweep {
    CostChart chart;
    std::vector<double> errors; ///< as CostSweep::errorMap(); empty where it is not asked for
};

/// A preset's chart.
struct Measured {
    std::string name;
    CostChart chart;
    std::vector<double> errors;
};

Errors oneError(Error error) {
    return {std::move(error)};
}

CostSweep::Options sweepOptions(const Options& options) {
    CostSweep::Options wanted;
    wanted.size = options.picture.size;
    wanted.scope = options.ofPicture ? Choice::Scope::Picture : Choice::Scope::Material;
    wanted.programCache = programCacheFolder();
    wanted.seconds = options.seconds;
    wanted.combinations = !options.singles;
    return wanted;
}

const CostPoint& mappedPoint(const CostChart& chart, const Options& options) {
    const auto answer =
        bestFor({options.budgetMilliseconds, options.budgetError}, chart.points);
    const bool isAsked = options.hasBudget() && answer;
    return chart.points[isAsked ? answer->point : costFront(chart.points).front()];
}

Checked<Sweep> swept(CostSweep::Subject subject, const Options& options) {
    auto sweep = CostSweep::create(std::move(subject), sweepOptions(options));
    if (!sweep) {
        return tl::unexpected(oneError(sweep.error()));
    }
    while (!(*sweep)->finished()) {
        (*sweep)->step(std::chrono::seconds(1));
    }
    if (!(*sweep)->problems().empty()) {
        return tl::unexpected((*sweep)->problems());
    }
    Sweep made{(*sweep)->chart(), {}};
    if (!options.errorMap.empty()) {
        made.errors = (*sweep)->errorMap(mappedPoint(made.chart, options).levels);
    }
    return made;
}

Checked<std::vector<ScalingCurve>> scaled(CostSweep::Subject subject, const Options& options) {
    ScalingSweep::Options wanted;
    wanted.edge = options.picture.size.x;
    wanted.programCache = programCacheFolder();
    auto sweep = ScalingSweep::create(std::move(subject), wanted);
    if (!sweep) {
        return tl::unexpected(oneError(sweep.error()));
    }
    while (!(*sweep)->finished()) {
        (*sweep)->step();
    }
    return (*sweep)->problems().empty()
               ? Checked<std::vector<ScalingCurve>>((*sweep)->curves())
               : tl::unexpected((*sweep)->problems());
}

Checked<std::vector<ModelCost>> ranked(CostSweep::Subject subject, const Options& options) {
    auto ranking = ModelRanking::create(std::move(subject), sweepOptions(options));
    if (!ranking) {
        return tl::unexpected(oneError(ranking.error()));
    }
    while (!(*ranking)->finished()) {
        (*ranking)->step();
    }
    return (*ranking)->problems().empty()
               ? Checked<std::vector<ModelCost>>((*ranking)->costs())
               : tl::unexpected((*ranking)->problems());
}

/// Calls `measure` with the scene of a preset.
template <class Measure>
auto withSubject(const std::string& preset, const Options& options,
                 const std::shared_ptr<const Catalog>& catalog, const Measure& measure)
    -> decltype(measure(CostSweep::Subject(), options)) {
    AssetClient files;
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
    auto measured = measure({setup->scene, 0, setup->scene.camera,
                             [&loaded](const Object& object) { return loaded->view(object); },
                             catalog, textures.source(), *environment},
                            options);
    report(textures.takeProblems());
    return measured;
}

Result<void> writeShown(const Image& image, const std::string& file) {
    AssetClient files;
    return files.saveImage(file, linearFromDisplay(image));
}

Result<void> writePlot(const CostChart& chart, const std::string& file) {
    const std::vector<PlotShape> shapes = costPlot(chart, plotSize);
    return file.ends_with(".svg") ? writeFileAtomically(file, plotSvg(shapes, plotSize))
                                  : writeShown(plotImage(shapes, plotSize), file);
}

/// The chart and the map, where they are asked for.
Result<void> writePictures(const Measured& measured, const Options& options) {
    if (!options.errorMap.empty()) {
        const Image map = errorPicture(measured.errors, measured.chart.size);
        if (auto written = writeShown(map, options.errorMap); !written) {
            return written;
        }
        std::cerr << options.errorMap << " shows where "
                  << levelsText(mappedPoint(measured.chart, options).levels)
                  << " is wrong: black 1e-6 of the light or less, each colour ten times more\n";
    }
    return options.plot.empty() ? Result<void>() : writePlot(measured.chart, options.plot);
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

Checked<bool> rankModels(const Options& options, const std::shared_ptr<const Catalog>& catalog) {
    const auto costs = withSubject({}, options, catalog, ranked);
    if (!costs) {
        return tl::unexpected(costs.error());
    }
    std::cout << (options.json  ? writeJson(rankingJson(*costs))
                  : options.csv ? rankingCsv(*costs)
                                : rankingText(*costs));
    return true;
}

Checked<bool> scale(const Options& options, const std::shared_ptr<const Catalog>& catalog) {
    const std::string preset = options.presets.empty() ? std::string() : options.presets.front();
    const auto curves = withSubject(preset, options, catalog, scaled);
    if (!curves) {
        return tl::unexpected(curves.error());
    }
    std::cout << (options.json  ? writeJson(scalingJson(*curves))
                  : options.csv ? scalingCsv(*curves)
                                : scalingText(*curves));
    return true;
}

/// The charts of all presets.
Checked<std::vector<Measured>> chartsOf(const std::vector<std::string>& presets,
                                        const Options& options,
                                        const std::shared_ptr<const Catalog>& catalog) {
    std::vector<Measured> all;
    for (const std::string& preset : presets) {
        auto sweep = withSubject(preset, options, catalog, swept);
        if (!sweep) {
            return tl::unexpected(sweep.error());
        }
        all.push_back({preset.empty() ? options.picture.model : preset, std::move(sweep->chart),
                       std::move(sweep->errors)});
    }
    return all;
}

Errors checkRequest(const Options& options) {
    const bool isOfOne = !options.plot.empty() || !options.errorMap.empty() || options.scaling;
    if (isOfOne && options.presets.size() > 1) {
        return oneError(failure("this is of one preset", "a single preset").value());
    }
    const bool isGiven = !options.presets.empty() || !options.picture.model.empty() ||
                         !options.picture.scene.empty() || options.allModels;
    return isGiven ? Errors()
                   : oneError(failure("there is nothing to measure",
                                      "a preset, --model, --scene or --all-models")
                                  .value());
}

/// True when every budget could be met.
Checked<bool> cost(const Options& options) {
    if (const Errors wrong = checkRequest(options); !wrong.empty()) {
        return tl::unexpected(wrong);
    }
    const auto catalog = std::make_shared<const Catalog>(loadCatalog(standardBlockRoots()));
    report(catalog->errors);
    const auto context = gl::HeadlessContext::create();
    if (!context) {
        return tl::unexpected(oneError(context.error()));
    }
    if (options.allModels) {
        return rankModels(options, catalog);
    }
    if (options.scaling) {
        return scale(options, catalog);
    }
    const auto all = chartsOf(options.presets.empty() ? std::vector<std::string>(1)
                                                      : options.presets,
                              options, catalog);
    if (!all) {
        return tl::unexpected(all.error());
    }
    print(*all, options);
    if (const auto written = writePictures(all->front(), options); !written) {
        return tl::unexpected(oneError(written.error()));
    }
    bool met = true;
    for (const Measured& each : *all) {
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
    auto* all = command->add_flag("--all-models", options->allModels,
                                  "Rank all models with their defaults on one scene instead");
    command
        ->add_flag("--scaling", options->scaling,
                   "How the time grows with pixels, lights and objects instead")
        ->excludes(all);
    command->add_option("--plot", options->plot, "Draw the chart into a file: .svg or .png");
    command->add_option("--error-map", options->errorMap,
                        "Draw where the way that the budget buys, or else the fastest one, is "
                        "wrong: .png");
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
