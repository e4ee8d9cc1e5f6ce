// SPDX-License-Identifier: GPL-3.0-or-later
// What each level of each accuracy choice costs beside the exact one, and how far off it is:
// written into docs/accuracy-cost.md, with the machine.
#include <chrono>
#include <cstdlib>
#include <string>

#include "benchmarks.h"
#include "catalog/value_json.h"
#include "gl/headless_context.h"
#include "machine_text.h"
#include "measure/cost/cost_sweep.h"
#include "primitive_meshes.h"
#include "statistics.h"

namespace patina::benchmarks {
namespace {

constexpr glm::ivec2 usualSize{256, 256};
constexpr glm::ivec2 smallSize{32, 32}; ///< where 4096 directions are looked into

/// Limits the levels of a setting: pairs of slow frames get fewer.
constexpr double longestSeconds = 30.0;

/// A model where its choices differ, with the choices that something else decides about.
struct Setting {
    std::string model;
    std::vector<std::pair<std::string, Value>> values{};
    std::string filler{}; ///< in its Fresnel slot; its choices are measured, not the model's
};

Value word(const char* id) {
    return std::string(id);
}

const std::vector<Setting> settings = {
    {"phong"},
    {"blinn-phong"},
    {"heidrich-seidel"},
    {"gaussian"},
    {"lafortune"},
    {"ashikhmin-shirley"},
    {"strauss"},
    {"he-torrance"},
    {"oren-nayar", {{"form", word("full")}}},
    {"oren-nayar", {{"form", word("interreflection")}}},
    {"oren-nayar", {{"form", word("eon")}}},
    {"cook-torrance", {{"distribution", word("beckmann")}, {"masking", word("smith-correlated")}}},
    {"cook-torrance", {{"distribution", word("ggx")}, {"masking", word("smith-correlated")}}},
    {"cook-torrance", {{"distribution", word("phong")}}},
    {"cook-torrance", {{"distribution", word("blinn-gaussian")}}},
    {"cook-torrance", {}, "dielectric"},
    {"cook-torrance", {}, "conductor"},
    {"cook-torrance", {}, "blinn-f0"},
};

BlockValues defaultsOf(const Catalog& catalog, const std::string& kind, const std::string& id) {
    const Block& block = *catalog.find(kind, id);
    BlockValues values;
    values.id = id;
    values.version = block.version;
    values.parameters = defaultValues(block);
    return values;
}

/// Three lights on a ball.
Scene ballScene(const Catalog& catalog, const std::string& model) {
    Scene scene;
    scene.objects.emplace_back().material = defaultMaterial(*catalog.find("models", model));
    for (const glm::dvec3& direction :
         {glm::dvec3(0.55, -0.8, -0.75), glm::dvec3(-1.0, -0.2, -0.35),
          glm::dvec3(-0.35, -0.5, 1.0)}) {
        Light& light = scene.lights.emplace_back();
        light.block = defaultsOf(catalog, "lights", "directional");
        light.block.parameters["direction"] = direction;
    }
    scene.camera.distance = 3.6;
    return scene;
}

Scene sceneOf(const Catalog& catalog, const Setting& setting) {
    Scene scene = ballScene(catalog, setting.model);
    Material& material = scene.objects.front().material;
    for (const auto& [id, value] : setting.values) {
        material.model.parameters[id] = value;
    }
    if (!setting.filler.empty()) {
        material.parts["fresnel"] = defaultsOf(catalog, "fresnel", setting.filler);
    }
    return scene;
}

/// Everything that a picture's choices are about, but an environment.
Scene pictureScene(const Catalog& catalog) {
    Scene scene = ballScene(catalog, "blinn-phong");
    scene.lights.front().setPart(kinds::shadows, defaultsOf(catalog, "shadows", "filtered"));
    scene.setPart(kinds::fog, defaultsOf(catalog, "fog", "exponential"));
    scene.setPart(kinds::transparency, defaultsOf(catalog, "transparency", "peeled"));
    Object pane = scene.objects.front();
    pane.mesh = "builtin:torus";
    pane.scale = glm::dvec3(1.6); // around the ball
    pane.material.opacity = 0.5;
    scene.objects.push_back(pane);
    return scene;
}

Scene environmentScene(const Catalog& catalog) {
    Scene scene = ballScene(catalog, "cook-torrance");
    scene.lights.clear();
    scene.setPart(kinds::environment, defaultsOf(catalog, "environment", "studio"));
    return scene;
}

/// What is measured, and how its rows begin.
struct Job {
    std::string name;
    Scene scene;
    Choice::Scope scope = Choice::Scope::Material;
    std::vector<std::string> only{};
    glm::ivec2 size = usualSize;
};

std::string nameOf(const Catalog& catalog, const Setting& setting) {
    std::string name = setting.filler.empty() ? catalog.find("models", setting.model)->label
                                              : catalog.find("fresnel", setting.filler)->label;
    for (const auto& [id, value] : setting.values) {
        const auto* chosen = std::get_if<std::string>(&value);
        name += ", " + (chosen != nullptr ? *chosen : id + ' ' + textOf(value));
    }
    return name;
}

/// Choice::id of all choices of the block that is asked about.
std::vector<std::string> choicesOf(const Catalog& catalog, const Setting& setting) {
    const bool ofFiller = !setting.filler.empty();
    const Block& block = ofFiller ? *catalog.find("fresnel", setting.filler)
                                  : *catalog.find("models", setting.model);
    std::vector<std::string> ids;
    for (const AccuracyChoice& choice : block.accuracy) {
        ids.push_back(ofFiller ? "fresnel." + choice.id : choice.id);
    }
    return ids;
}

CostChart measured(const Job& job, const std::shared_ptr<const Catalog>& catalog) {
    PrimitiveMeshes meshes;
    const MeshSource source = meshes.source();
    CostSweep::Options options;
    options.size = job.size;
    options.scope = job.scope;
    options.only = job.only;
    options.combinations = false;
    options.seconds = longestSeconds;
    auto sweep = CostSweep::create({job.scene, 0, job.scene.camera, source, catalog}, options);
    if (!sweep) {
        fmt::print(stderr, "{}: {}\n", job.name, sweep.error().text());
        std::exit(2);
    }
    while (!(*sweep)->finished()) {
        (*sweep)->step(std::chrono::seconds(1));
    }
    if (!(*sweep)->problems().empty()) {
        fmt::print(stderr, "{}: {}\n", job.name, (*sweep)->problems().front().text());
        std::exit(2);
    }
    return (*sweep)->chart();
}

std::string row(const std::string& name, const CostPoint& point) {
    const MedianInterval& ratio = point.cost.ratio;
    const std::string instructions =
        point.instructions ? std::to_string(point.instructions->total()) : "-";
    const std::string level = point.isExact() ? "exact" : '`' + levelsText(point.levels) + '`';
    return fmt::format("| {} | {} | {:.1f} | {:.2f} ({:.2f} .. {:.2f}) | {:.1e} | {:.1e} | {:.1e} "
                       "| {:.2f} % | {} |\n",
                       name, level, point.cost.nanosecondsPerPixel, ratio.median, ratio.lower,
                       ratio.upper, point.error.p99, point.error.mean, point.error.max,
                       100.0 * point.error.stepShare, instructions);
}

std::string rowsOf(const Job& job, const std::shared_ptr<const Catalog>& catalog) {
    const CostChart chart = measured(job, catalog);
    std::string rows;
    for (const CostPoint& point : chart.points) {
        rows += row(&point == &chart.points.front() ? job.name : std::string(), point);
    }
    if (const std::string same = sameText(chart); !same.empty()) {
        rows += fmt::format("|  | {} | | | | | | | |\n", same);
    }
    fmt::print("{}", rows);
    std::fflush(stdout);
    return rows;
}

constexpr const char* head =
    "| | level | ns per pixel | of the exact time | error, 99 of 100 pixels | mean | worst | off "
    "by a step of 8 bits | instructions |\n"
    "| --- | --- | --- | --- | --- | --- | --- | --- | --- |\n";

std::vector<Job> materialJobs(const Catalog& catalog) {
    std::vector<Job> jobs;
    for (const Setting& setting : settings) {
        jobs.push_back({nameOf(catalog, setting), sceneOf(catalog, setting),
                        Choice::Scope::Material, choicesOf(catalog, setting)});
    }
    return jobs;
}

std::string tableOf(const std::vector<Job>& jobs, const std::shared_ptr<const Catalog>& catalog) {
    std::string table = head;
    for (const Job& job : jobs) {
        table += rowsOf(job, catalog);
    }
    return table;
}

} // namespace

bool accuracyCost() {
    const auto context = gl::HeadlessContext::create().value();
    const auto catalog = std::make_shared<const Catalog>(loadCatalog(standardBlockRoots()));
    const double before = load();
    const std::string materials = tableOf(materialJobs(*catalog), catalog);
    const std::string pictures = tableOf({{"A ball and a clear ring, fog and shadows",
                                           pictureScene(*catalog), Choice::Scope::Picture},
                                          {"A ball in the studio, 32 x 32 pixels",
                                           environmentScene(*catalog),
                                           Choice::Scope::Picture,
                                           {"picture.environment"},
                                           smallSize}},
                                         catalog);
    const std::string text = fmt::format(
        "# What accuracy choices cost\n\n"
        "Written by `./packaging/benchmark accuracy-cost` on {}: {}. The load was "
        "{:.1f} when it began and {:.1f} when it ended: above 1 other things\nwere at work, and "
        "intervals are wide.\n\n"
        "Each level by itself, beside the exact one with which it alternates, in pictures of\n"
        "{} x {} pixels of a ball under three lights, without what the frame takes where nothing\n"
        "of it is shaded; the interval holds the ratio with a probability of 95 %. Errors are\n"
        "relative, in linear light. Of a level that draws the exact picture, bit for bit, with as\n"
        "many instructions, no time is taken: it has nothing to do there.\n\n"
        "## Of materials\n\nAgainst the same frame in double precision.\n\n{}\n"
        "## Of the picture\n\nAgainst the finest picture that the device draws, over all pixels of "
        "objects.\n\n{}",
        today(), machineText(), before, load(), usualSize.x, usualSize.y, materials, pictures);
    return writeDocument("accuracy-cost.md", text);
}

} // namespace patina::benchmarks
