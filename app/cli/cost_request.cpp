// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/cost_request.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <initializer_list>

#include <unistd.h>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "cli/option_families.h"
#include "cli/option_numbers.h"
#include "core/number_text.h"

namespace patina {
namespace {

namespace fs = std::filesystem;

/// Describes a combination of options that is not allowed.
struct Combination {
    bool isWrong = false;
    const char* problem = "";
    const char* expected = "";
};

/// Tells whether a file can be created, by trying: permissions say too little, as the system may be
/// read-only or not allow files in that folder.
bool canBeMade(const std::string& file) {
    const bool isMade = std::ofstream(file, std::ios::app).is_open();
    std::error_code none;
    return isMade && fs::remove(file, none);
}

/// Says why a file cannot be written; null where it can, and for an empty name, as no file is asked
/// for.
const char* whyUnwritable(const std::string& file) {
    if (file.empty()) {
        return nullptr;
    }
    const fs::path folder = fs::absolute(file).parent_path();
    std::error_code none;
    if (!fs::is_directory(folder, none)) {
        return "there is no folder for the picture";
    }
    if (fs::is_directory(file, none)) {
        return "the picture's name is that of a folder";
    }
    const bool isThere = fs::exists(file, none);
    const bool canWrite = isThere ? ::access(file.c_str(), W_OK) == 0 : canBeMade(file);
    return canWrite ? nullptr : "the picture may not be written there";
}

bool isOneOf(const std::string& ending, std::initializer_list<std::string_view> known) {
    return std::ranges::find(known, ending) != known.end();
}

/// Returns the wrong combinations of options and the files that could not be written.
Errors checkCombinations(const CostRequest& request) {
    const bool isOther = request.allModels || request.scaling;
    const bool isChart = request.hasChartOptions();
    const glm::ivec2 size = request.picture.size;
    const bool isPredicted = !request.families.empty() || request.card;
    const bool isPlot = request.plot.empty() || isOneOf(endingOf(request.plot), {".svg", ".png"});
    const bool isMap =
        request.errorMap.empty() || isOneOf(endingOf(request.errorMap), {".png", ".jpg", ".jpeg"});
    const char* plotProblem = whyUnwritable(request.plot);
    const char* mapProblem = whyUnwritable(request.errorMap);
    const char* place = "a file in a folder that exists and may be written to";
    const std::array wrong{
        Combination{isOther && isChart,
                    "budgets, --plot, --error-map, --error-map-of, --picture, --singles and --at "
                    "are of charts of presets",
                    "--all-models or --scaling without them"},
        Combination{
            request.allModels && (!request.presets.empty() || !request.picture.model.empty()),
            "--all-models ranks models, and no material", "no preset and no --model beside it"},
        Combination{request.scaling && size.x != size.y, "--scaling draws square pictures",
                    "a --size such as 256x256"},
        Combination{isPredicted && (request.scaling || request.ofPicture),
                    "what is predicted is an object's shader: no --scaling, no --picture",
                    "--gpu or --card without them"},
        Combination{request.card && !request.families.empty(),
                    "--card predicts for the family of that card", "--gpu or --card, not both"},
        Combination{request.card && request.allModels,
                    "--card predicts the ways to compute one material", "--gpu for all models"},
        Combination{request.isPredictedOnly() && isChart,
                    "a budget and a chart are for one graphics card",
                    "--card NAME, such as 6600, or one family after --gpu"},
        Combination{request.shown && !request.card,
                    "--at is the size of a picture whose times are predicted", "--card beside it"},
        Combination{request.card && request.asItIs, "a chart has all levels",
                    "--as-it-is without --card"},
        Combination{request.job.isWanted() &&
                        (isOther || !request.plot.empty() || !request.errorMap.empty()),
                    "--results are charts of presets, as JSON",
                    "--results without --all-models, --scaling, --plot and --error-map"},
        Combination{!isPlot, "a chart is drawn as .svg or .png", "such a file"},
        Combination{!isMap, "an error map is drawn as .png or .jpg", "such a file"},
        Combination{plotProblem != nullptr, plotProblem, place},
        Combination{mapProblem != nullptr, mapProblem, place},
    };
    for (const Combination& each : wrong) {
        if (each.isWrong) {
            return oneError(failure(each.problem, each.expected).value());
        }
    }
    return {};
}

/// Reads a number such as "0.25" or "1/255"; returns nothing for what is not a finite number.
std::optional<double> numberOrFraction(std::string_view text) {
    const std::size_t line = text.find('/');
    if (line == std::string_view::npos) {
        return parseNumber(text);
    }
    const std::optional<double> over = parseNumber(text.substr(0, line));
    const std::optional<double> under = parseNumber(text.substr(line + 1));
    const double share = over && under ? *over / *under : std::nan("");
    return std::isfinite(share) ? std::optional(share) : std::nullopt;
}

double budgetIn(const char* option, const std::string& text, bool canBeNothing) {
    return optionNumber(
        option, text,
        {"a budget",
         canBeNothing ? "a share of 0 or more such as 0.004 or 1/255"
                      : "milliseconds above 0 such as 2.5",
         [canBeNothing](double budget) { return budget > 0.0 || (budget == 0.0 && canBeNothing); },
         numberOrFraction});
}

void addBudgets(CLI::App& command, CostRequest& request) {
    command.add_option_function<std::string>(
        "--budget-ms",
        [&request](const std::string& text) {
            request.budgetMilliseconds = budgetIn("--budget-ms", text, false);
        },
        "Pick the most accurate way whose frame takes no longer");
    command.add_option_function<std::string>(
        "--budget-error",
        [&request](const std::string& text) {
            request.budgetError = budgetIn("--budget-error", text, true);
        },
        "Pick the fastest way of which 99 of 100 pixels are off by no greater share, such as "
        "1/255; with --budget-ms the most accurate of those that keep both");
}

/// Returns the pixels of "1440p" or "2560x1440".
glm::ivec2 pictureIn(const std::string& text) {
    struct Named {
        std::string_view name;
        glm::ivec2 size;
    };
    constexpr std::array named{Named{"720p", {1280, 720}}, Named{"1080p", {1920, 1080}},
                               Named{"1440p", {2560, 1440}}, Named{"2160p", {3840, 2160}}};
    const auto found = std::ranges::find(named, text, &Named::name);
    if (found != named.end()) {
        return found->size;
    }
    glm::ivec2 size(0);
    const std::size_t by = std::min(text.find('x'), text.size());
    const auto read = [&text](std::size_t from, std::size_t to) {
        const auto number = parseNumber(std::string_view(text).substr(from, to - from));
        return number && *number >= 1.0 && *number <= 65536.0 && std::trunc(*number) == *number
                   ? static_cast<int>(*number)
                   : 0;
    };
    size = {read(0, by), read(std::min(by + 1, text.size()), text.size())};
    if (size.x == 0 || size.y == 0) {
        throw CLI::ValidationError("--at", fmt::format("not a picture's size: \"{}\"; expected "
                                                       "720p, 1080p, 1440p, 2160p or WxH",
                                                       text));
    }
    return size;
}

/// Adds the graphics card that a chart's times are predicted for.
void addCard(CLI::App& command, CostRequest& request) {
    command.add_option_function<std::string>(
        "--card",
        [&request](const std::string& name) {
            auto found = graphicsCardIn(name);
            if (!found) {
                throw CLI::ValidationError("--card", found.error().text());
            }
            request.card = *found;
        },
        "Predict the times of a chart for this graphics card, which need not be here: a part of "
        "its name, such as \"6600\" or \"steam deck\", or a family, \"RDNA 2\", whose middle card "
        "stands for it; errors are measured here. A budget with --gpu and one family is the same");
    command.add_option_function<std::string>(
        "--at", [&request](const std::string& text) { request.shown = pictureIn(text); },
        "With --card: for pictures of so many pixels that the object fills, 1440p or WxH; "
        "1080p without this");
}

} // namespace

std::string endingOf(const std::string& file) {
    std::string ending = fs::path(file).extension().string();
    std::ranges::transform(ending, ending.begin(), [](unsigned char letter) {
        return static_cast<char>(letter >= 'A' && letter <= 'Z' ? letter - 'A' + 'a' : letter);
    });
    return ending;
}

void addCostOptions(CLI::App& command, CostRequest& request) {
    request.picture.size = glm::ivec2(0);
    command.add_option("presets", request.presets, "Presets (*.patina.json)");
    addSceneOptions(command, request.picture);
    command.remove_option(command.get_option("--samples")); // each level has its own
    addSizeOption(command, request.picture);
    addBudgets(command, request);
    addCard(command, request);
    command.add_flag("--picture", request.ofPicture,
                     "The picture's own choices, such as samples, instead of the material's");
    command.add_flag("--singles", request.singles, "Each choice by itself, no combinations");
    addSecondsOption(command, request.seconds,
                     "No combination and no round is begun after so long; slow frames are drawn "
                     "less often");
    auto* all = command.add_flag("--all-models", request.allModels,
                                 "Rank all models with their defaults on one scene instead");
    command
        .add_flag("--scaling", request.scaling,
                  "How the time grows with pixels, lights and objects instead")
        ->excludes(all);
    command
        .add_flag("--as-it-is", request.asItIs,
                  "With --gpu only the levels that the material has, not each one")
        ->needs(addFamiliesOption(command, request.families));
    command.add_option("--plot", request.plot, "Draw the chart into a file: .svg or .png");
    command.add_option("--error-map", request.errorMap,
                       "Draw where the way that the budget buys, or else the fastest one that is "
                       "worth choosing, is wrong: .png or .jpg");
    command.add_option("--error-map-of", request.errorMapOf,
                       "Of this way instead, named as in the table: \"power=rational\"");
    auto* json = command.add_flag("--json", request.json, "Print an array of charts as JSON");
    auto* csv = command.add_flag("--csv", request.csv, "Print comma-separated values");
    csv->excludes(json);
    addJobOptions(command, request.job)->excludes(json)->excludes(csv);
}

void takeCardOfFamily(CostRequest& request) {
    if (!request.card && request.families.size() == 1 && request.hasChartOptions()) {
        const GpuFamily* family = request.families.front();
        request.card = CardOfFamily{family, &family->middleCard(), true};
        request.families.clear();
    }
}

Errors checkRequest(const CostRequest& request) {
    if (Errors wrong = checkCombinations(request); !wrong.empty()) {
        return wrong;
    }
    if (!request.errorMapOf.empty() && request.errorMap.empty()) {
        return oneError(
            failure("--error-map-of names a way, but there is no map to draw", "--error-map FILE")
                .value());
    }
    const bool isOfOne = !request.plot.empty() || !request.errorMap.empty() || request.scaling;
    if (isOfOne && request.presets.size() > 1) {
        return oneError(failure("this is of one preset", "a single preset").value());
    }
    const bool isGiven = !request.presets.empty() || !request.picture.model.empty() ||
                         !request.picture.scene.empty() || request.allModels;
    return isGiven ? Errors()
                   : oneError(failure("there is nothing to measure",
                                      "a preset, --model, --scene or --all-models")
                                  .value());
}

} // namespace patina
