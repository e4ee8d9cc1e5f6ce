// SPDX-License-Identifier: GPL-3.0-or-later
// What each model costs per pixel: beside the matte surface, and beside the same formula written as
// books print it.
#include <filesystem>
#include <map>
#include <string>
#include <string_view>

#include <epoxy/gl.h>

#include "benchmarks.h"
#include "gl/headless_context.h"
#include "model_program.h"
#include "pixel_target.h"
#include "statistics.h"

namespace patina::benchmarks {
namespace {

constexpr int rounds = 31;
constexpr int framesPerRound = 3;

/// The most that a stable form may cost of its textbook form; the others only count for the median.
const std::map<std::string_view, double> limits = {
    {"ashikhmin-shirley", 1.0}, {"blinn-phong", 1.45},     {"cook-torrance", 1.0},
    {"gaussian", 1.45},         {"heidrich-seidel", 1.45}, {"oren-nayar", 1.0},
    {"phong", 1.45},            {"schlick", 1.45},         {"strauss", 1.45},
    {"ward", 1.0}};
constexpr double medianLimit = 1.0;

struct Contest {
    const Block* model = nullptr;
    std::string name; ///< the model, and the choice that is not its first
    ModelProgram stable;
    ModelProgram textbook;
    std::vector<double> gross;  ///< seconds per pixel
    std::vector<double> ratios; ///< to the textbook form, both without what every program pays
    std::vector<double> toMatte{}; ///< to Lambert's whole pixel beside it in each round
};

ModelProgram linkedOrExit(Checked<ModelProgram> program, const std::string& name) {
    if (!program) {
        for (const Error& error : program.error()) {
            fmt::print(stderr, "{}: {}\n", name, error.text());
        }
        std::exit(2);
    }
    return std::move(*program);
}

/// The model as it starts, and then each of its compiled choices in turn.
std::vector<ModelChoice> choicesOf(const Block& model) {
    std::vector<ModelChoice> choices = {{&model, {}, {}, nullptr}};
    for (const Parameter& parameter : model.parameters) {
        for (const EnumValue& value : parameter.values) {
            if (parameter.compiled != Compiled::No && Value(value.id) != parameter.defaultValue) {
                choices.push_back({&model, {{parameter.id, value.id}}, {}, nullptr});
            }
        }
    }
    return choices;
}

std::string nameOf(const ModelChoice& choice) {
    std::string name = choice.model->id;
    for (const auto& [id, value] : choice.values) {
        name += ' ' + id + '=' + std::get<std::string>(value);
    }
    return name;
}

std::filesystem::path textbookOf(const Block& model) {
    return std::filesystem::path(PATINA_SOURCE_DIR) / "tests" / "benchmarks" / "textbook"
        / (model.id + ".glsl");
}

Contest contestOf(const Catalog& catalog, const ModelChoice& choice) {
    const auto file = textbookOf(*choice.model);
    const std::string name = nameOf(choice);
    return {choice.model,
            name,
            linkedOrExit(ModelProgram::link(catalog, choice), name),
            linkedOrExit(ModelProgram::link(catalog, choice, file), name),
            {},
            {}};
}

/// A model of one's own has no textbook form.
bool hasTextbook(const Block& model) {
    const bool has = std::filesystem::exists(textbookOf(model));
    if (!has) {
        fmt::print("{}: left out, there is no {}\n", model.id, textbookOf(model).string());
    }
    return has;
}

std::vector<Contest> contests(const Catalog& catalog) {
    std::vector<Contest> all;
    for (const Block* model : catalog.ofKind("models")) {
        if (!hasTextbook(*model)) {
            continue;
        }
        for (const ModelChoice& choice : choicesOf(*model)) {
            all.push_back(contestOf(catalog, choice));
        }
    }
    return all;
}

/// Lambert's own part of a pixel is smaller than the noise, so beside it whole pixels are compared.
void run(Contest& contest, const ModelProgram& empty, const ModelProgram& matte) {
    const double base = empty.secondsPerPixel(framesPerRound);
    const double lambert = matte.secondsPerPixel(framesPerRound);
    const double stable = contest.stable.secondsPerPixel(framesPerRound);
    contest.gross.push_back(stable);
    contest.toMatte.push_back(stable / lambert);
    const double textbook = contest.textbook.secondsPerPixel(framesPerRound) - base;
    contest.ratios.push_back((stable - base) / std::max(textbook, 1e-12));
}

bool printContest(const Contest& contest) {
    const Spread gross = spreadOf(contest.gross);
    const Spread ratio = spreadOf(contest.ratios);
    const auto limit = limits.find(contest.model->id);
    const bool kept = limit == limits.end() || ratio.median <= limit->second;
    report(contest.name,
           fmt::format("{:6.1f} ns, {:5.2f} x lambert; / textbook {}", gross.median * 1e9,
                       spreadOf(contest.toMatte).median, text(ratio, 1.0, "")),
           kept, limit == limits.end() ? "" : fmt::format("<= {}", limit->second));
    return kept;
}

/// Returns the mean of the two in the middle for an even count.
double medianOf(std::vector<double> numbers) {
    std::ranges::sort(numbers);
    return 0.5 * (numbers[(numbers.size() - 1) / 2] + numbers[numbers.size() / 2]);
}

/// The median of the medians, over the models as they start or over all choices.
bool printMedian(const std::vector<Contest>& all, const char* name, bool startsOnly) {
    std::vector<double> medians;
    for (const Contest& contest : all) {
        if (!startsOnly || contest.name == contest.model->id) {
            medians.push_back(spreadOf(contest.ratios).median);
        }
    }
    const double middle = medianOf(medians);
    const bool kept = middle <= medianLimit;
    report(fmt::format("{} {} / textbook", medians.size(), name),
           fmt::format("median {:.3f}", middle), kept, fmt::format("<= {}", medianLimit));
    return kept;
}

bool print(const std::vector<Contest>& all) {
    bool kept = true;
    for (const Contest& contest : all) {
        kept = printContest(contest) && kept;
    }
    kept = printMedian(all, "models as they start", true) && kept;
    return printMedian(all, "choices of all models", false) && kept;
}

} // namespace

bool modelCost() {
    const auto context = gl::HeadlessContext::create().value();
    const Catalog catalog = loadCatalog(standardBlockRoots());
    const PixelTarget target(ModelProgram::targetSize);
    const ModelProgram empty = linkedOrExit(ModelProgram::linkEmpty(catalog), "model_cost.frag");
    std::vector<Contest> all = contests(catalog);
    const auto matte =
        std::ranges::find(all, "lambert", [](const Contest& contest) { return contest.name; });
    for (int round = 0; round < rounds; ++round) {
        for (Contest& contest : all) {
            run(contest, empty, matte->stable);
        }
    }
    return print(all);
}

} // namespace patina::benchmarks
