// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/command.h"

#include <iostream>
#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "assets/asset_client.h"
#include "catalog/json_text.h"
#include "cli/cost_drawing.h"
#include "cli/cost_prediction.h"
#include "cli/cost_sweeps.h"
#include "cli/prepared_subject.h"
#include "core/display_image.h"
#include "gl/headless_context.h"
#include "measure/cost/cost_table.h"
#include "measure/cost/ranking_table.h"
#include "measure/error/error_colors.h"
#include "render/gpu/hdr_target.h"

namespace patina {
namespace {

constexpr glm::ivec2 plotSize{960, 600};

/// Holds a preset's chart and error map.
struct Measured {
    std::string name;
    CostChart chart;
    ChosenLevels mapped;
    std::vector<double> errors;
};

Result<void> writeShown(const Image& image, const std::string& file) {
    AssetClient files;
    return files.saveImage(file, linearFromDisplay(image));
}

Result<void> writePlot(const CostChart& chart, const std::string& file) {
    return writeDrawing(costPlot(chart, plotSize), plotSize, file);
}

/// Says what the error map compares with.
std::string groundTruthOf(const Measured& measured) {
    const CostPoint* point = measured.chart.find(measured.mapped);
    return point != nullptr && measured.chart.isAgainstConverged(*point)
               ? fmt::format("a converged render of {} directions",
                             measured.chart.converged->directions)
               : measured.chart.groundTruth;
}

/// Writes the plot and the error map, where they are asked for.
Result<void> writePictures(const Measured& measured, const CostRequest& options) {
    if (!options.errorMap.empty()) {
        const Image map = errorPicture(measured.errors, measured.chart.size);
        if (auto written = writeShown(map, options.errorMap); !written) {
            return written;
        }
        std::cerr << options.errorMap << " shows where " << levelsText(measured.mapped)
                  << " is wrong, against " << groundTruthOf(measured)
                  << ": black 1e-6 of the light or less, each colour ten times more\n";
    }
    return options.plot.empty() ? Result<void>() : writePlot(measured.chart, options.plot);
}

std::string budgetText(const CostPoint& point, const BudgetAnswer& answer) {
    return fmt::format("{}: {}, {}{:.3f} ms, error {:.2e}\n",
                       answer.fits ? "the budget buys" : "no point fits the budget; the nearest is",
                       levelsText(point.levels), point.cost.belowNoise ? "at most " : "",
                       point.cost.milliseconds.median, errorOf(point));
}

/// Prints the best point within the budget; returns false when none fits. `name` tells charts apart
/// where there are several, and is else empty.
bool printBudget(const CostChart& chart, const CostRequest& options, const std::string& name) {
    const auto answer = bestFor({options.budgetMilliseconds, options.budgetError}, chart.points);
    if (!answer) {
        return false;
    }
    (answer->fits && !options.json && !options.csv ? std::cout : std::cerr)
        << (name.empty() ? "" : name + ": ") << budgetText(chart.points[answer->point], *answer);
    return answer->fits;
}

nlohmann::json jsonOf(const Measured& measured, const CostRequest& options) {
    nlohmann::json json = costJson(measured.chart);
    json["preset"] = measured.name;
    const auto answer =
        bestFor({options.budgetMilliseconds, options.budgetError}, measured.chart.points);
    if (options.hasBudget() && answer) {
        json["budget"] = {{"fits", answer->fits}, {"index", answer->point}};
    }
    return json;
}

void print(const std::vector<Measured>& all, const CostRequest& options) {
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

Checked<bool> rankModels(const CostRequest& options, const Tools& tools) {
    const auto subject = prepared({}, options.picture, *tools.catalog, tools.files);
    if (!subject) {
        return tl::unexpected(subject.error());
    }
    const auto costs = withSubject(*subject, options, tools, rankedModels);
    if (!costs) {
        return tl::unexpected(costs.error());
    }
    std::cout << (options.json  ? writeJson(rankingJson(*costs))
                  : options.csv ? rankingCsv(*costs)
                                : rankingText(*costs));
    return true;
}

Checked<bool> scale(const CostRequest& options, const Tools& tools) {
    const std::string preset = options.presets.empty() ? std::string() : options.presets.front();
    const auto subject = prepared(preset, options.picture, *tools.catalog, tools.files);
    if (!subject) {
        return tl::unexpected(subject.error());
    }
    const auto curves = withSubject(*subject, options, tools, scaled);
    if (!curves) {
        return tl::unexpected(curves.error());
    }
    std::cout << (options.json  ? writeJson(scalingJson(*curves))
                  : options.csv ? scalingCsv(*curves)
                                : scalingText(*curves));
    return true;
}

/// Measures the charts of all presets, or those begun before it was stopped.
Checked<std::vector<Measured>> chartsOf(const std::vector<std::string>& presets,
                                        const CostRequest& options, const Tools& tools) {
    const auto subjects = allPrepared(presets, options, *tools.catalog, tools.files);
    if (!subjects) {
        return tl::unexpected(subjects.error());
    }
    std::vector<Measured> all;
    for (const Prepared& subject : *subjects) {
        auto sweep = withSubject(subject, options, tools, swept);
        if (!sweep && tools.work.isStopped() && !all.empty()) {
            break;
        }
        if (!sweep) {
            return tl::unexpected(sweep.error());
        }
        all.push_back({nameOf(subject, options), std::move(sweep->chart), std::move(sweep->mapped),
                       std::move(sweep->errors)});
    }
    return all;
}

/// Measures and prints charts; returns true when every budget could be met.
Checked<bool> chart(const CostRequest& options, const Tools& tools) {
    const auto all = chartsOf(
        options.presets.empty() ? std::vector<std::string>(1) : options.presets, options, tools);
    if (!all) {
        return tl::unexpected(all.error());
    }
    print(*all, options);
    if (tools.work.isStopped()) {
        return true;
    }
    if (const auto written = writePictures(all->front(), options); !written) {
        return tl::unexpected(oneError(written.error()));
    }
    bool met = true;
    for (const Measured& each : *all) {
        const std::string name = all->size() > 1 ? each.name : std::string();
        met = (!options.hasBudget() || printBudget(each.chart, options, name)) && met;
    }
    return met;
}

/// Measures the charts of a job's presets.
class CostWork : public JobWork {
  public:
    CostWork(const CostRequest& options, const Tools& tools) : options_(options), tools_(tools) {}

    Checked<nlohmann::json> resultOf(const std::string& preset) override {
        const auto subject = prepared(preset, options_.picture, *tools_.catalog, tools_.files);
        if (!subject) {
            return tl::unexpected(subject.error());
        }
        auto sweep = withSubject(*subject, options_, tools_, swept);
        if (!sweep) {
            return tl::unexpected(sweep.error());
        }
        return jsonOf({preset, std::move(sweep->chart), {}, {}}, options_);
    }

    bool isGood(const nlohmann::json& result) const override {
        const auto budget = result.find("budget");
        return budget == result.end() || !budget->is_object() || budget->value("fits", true);
    }

  private:
    const CostRequest& options_;
    const Tools& tools_;
};

/// Measures charts into the file of a job; returns true when every one could be made and every
/// budget be met.
Checked<bool> chartsOfJob(const CLI::App& command, const CostRequest& options, const Tools& tools) {
    CostWork work(options, tools);
    return runJob({command, options.job, options.presets, *tools.catalog,
                   options.picture.allowsOutside},
                  work, tools.work)
        .map([](int status) { return status == 0; });
}

/// Measures what is asked for, with a context that stays current meanwhile.
Checked<bool> measured(const CLI::App& command, const CostRequest& options, LongWork& work) {
    const auto catalog = std::make_shared<const Catalog>(loadCatalog(standardBlockRoots()));
    report(catalog->errors);
    const auto context = gl::HeadlessContext::create();
    if (!context) {
        return tl::unexpected(oneError(context.error()));
    }
    const glm::ivec2 size = options.picture.size;
    if (const auto checked = size.x > 0 ? checkPictureSize(size) : Result<void>(); !checked) {
        return tl::unexpected(oneError(checked.error()));
    }
    AssetClient files;
    const Tools tools{catalog, files, work};
    return options.allModels        ? rankModels(options, tools)
           : options.scaling        ? scale(options, tools)
           : options.job.isWanted() ? chartsOfJob(command, options, tools)
                                    : chart(options, tools);
}

/// Returns the exit status of the command.
int cost(const CLI::App& command, const CostRequest& options) {
    if (const Errors wrong = checkRequest(options); !wrong.empty()) {
        report(wrong);
        return 1;
    }
    if (options.card && options.card->standsForFamily) {
        std::cerr << fmt::format("{} stands for {}; --card takes another one\n",
                                 options.card->card->name, options.card->family->label);
    }
    bool isStopped = false;
    Checked<bool> done = false;
    {
        LongWork work;
        done = options.isPredictedOnly() ? predictCosts(command, options, work)
                                         : measured(command, options, work);
        isStopped = work.isStopped();
    }
    if (!done) {
        report(done.error());
    } else if (isStopped) {
        std::cerr << "stopped: this is what was measured so far\n";
    }
    return isStopped ? LongWork::stoppedStatus : done && *done ? 0 : 1;
}

} // namespace

void addCost(CLI::App& program, int& status) {
    CLI::App* command = program.add_subcommand(
        "cost", "Measure what every accuracy choice of a preset costs and how wrong it is");
    auto options = std::make_shared<CostRequest>();
    addCostOptions(*command, *options);
    command->callback([command, options, &status] {
        takeCardOfFamily(*options);
        status = cost(*command, *options);
    });
}

} // namespace patina
