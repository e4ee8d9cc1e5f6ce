// SPDX-License-Identifier: GPL-3.0-or-later
// What each level of each accuracy choice costs per pixel, beside the exact one.
#include <string>

#include <epoxy/gl.h>

#include "benchmarks.h"
#include "gl/headless_context.h"
#include "model_program.h"
#include "pixel_target.h"
#include "statistics.h"

namespace patina::benchmarks {
namespace {

constexpr int rounds = 15;
constexpr int framesPerRound = 1;

/// A level at work, and the exact one with the same values.
struct Contest {
    std::string name;
    ModelProgram exact;
    ModelProgram level;
    std::vector<double> seconds{}; ///< per pixel, without what every program pays
    std::vector<double> ratios{};
};

using Words = std::vector<std::pair<std::string, std::string>>;

/// A model where its choices differ, with the choices that something else decides about.
struct Setting {
    std::string model;
    Words values{};
    std::string filler{}; ///< of its first slot, in place of the slot's own
};

const std::vector<Setting> settings = {
    {"phong"},
    {"blinn-phong"},
    {"heidrich-seidel"},
    {"gaussian"},
    {"lafortune"},
    {"ashikhmin-shirley"},
    {"strauss"},
    {"he-torrance"},
    {"oren-nayar", {{"form", "full"}}},
    {"oren-nayar", {{"form", "interreflection"}}},
    {"oren-nayar", {{"form", "eon"}}},
    {"cook-torrance", {{"distribution", "beckmann"}, {"masking", "smith-correlated"}}},
    {"cook-torrance", {{"distribution", "ggx"}, {"masking", "smith-correlated"}}},
    {"cook-torrance", {{"distribution", "phong"}}},
    {"cook-torrance", {{"distribution", "blinn-gaussian"}}},
    {"cook-torrance", {}, "dielectric"},
    {"cook-torrance", {}, "conductor"},
    {"cook-torrance", {}, "blinn-f0"},
};

ModelProgram linked(const Catalog& catalog, const ModelChoice& choice) {
    Checked<ModelProgram> program = ModelProgram::link(catalog, choice);
    if (!program) {
        fmt::print(stderr, "{}: {}\n", choice.model->id, program.error().front().text());
        std::exit(2);
    }
    return std::move(*program);
}

std::string nameOf(const Setting& setting, const AccuracyChoice& choice, const EnumValue& level) {
    std::string name = setting.filler.empty() ? setting.model : setting.filler;
    for (const auto& [id, value] : setting.values) {
        name += ", " + value;
    }
    return fmt::format("{} | `{}={}`", name, choice.id, level.id);
}

void addContests(std::vector<Contest>& all, const Catalog& catalog, const Setting& setting) {
    ModelChoice exact{catalog.find("models", setting.model), {}, {}, nullptr};
    for (const auto& [id, value] : setting.values) {
        exact.values[id] = value;
    }
    if (!setting.filler.empty()) {
        exact.filler = catalog.find("fresnel", setting.filler);
    }
    const Block& block = exact.filler != nullptr ? *exact.filler : *exact.model;
    for (const AccuracyChoice& choice : block.accuracy) {
        for (const EnumValue& level : choice.values) {
            ModelChoice made = exact;
            made.levels[choice.id] = level.id;
            if (!level.exact && level.table.empty()) { // `patina cost` has those of tables
                all.push_back({nameOf(setting, choice, level), linked(catalog, exact),
                               linked(catalog, made)});
            }
        }
    }
}

void run(Contest& contest, const ModelProgram& empty) {
    const double base = empty.secondsPerPixel(framesPerRound);
    const double exact = contest.exact.secondsPerPixel(framesPerRound) - base;
    const double level = contest.level.secondsPerPixel(framesPerRound) - base;
    contest.seconds.push_back(level);
    contest.ratios.push_back(level / std::max(exact, 1e-12));
}

} // namespace

bool accuracyCost() {
    const auto context = gl::HeadlessContext::create().value();
    const Catalog catalog = loadCatalog(standardBlockRoots());
    const PixelTarget target(ModelProgram::targetSize);
    const ModelProgram empty = ModelProgram::linkEmpty(catalog).value();
    std::vector<Contest> all;
    for (const Setting& setting : settings) {
        addContests(all, catalog, setting);
    }
    for (int round = 0; round < rounds; ++round) {
        for (Contest& contest : all) {
            run(contest, empty);
        }
    }
    for (const Contest& contest : all) {
        const Spread ratio = spreadOf(contest.ratios);
        fmt::print("| {} | {:.2f} | {:.2f} ({:.2f} .. {:.2f}) |\n", contest.name,
                   spreadOf(contest.seconds).median * 1e9, ratio.median, ratio.lower, ratio.upper);
    }
    return true;
}

} // namespace patina::benchmarks
