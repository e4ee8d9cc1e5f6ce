// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/command.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iostream>
#include <map>
#include <memory>
#include <optional>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "assets/asset_client.h"
#include "catalog/json_text.h"
#include "cli/effect_table.h"
#include "cli/environment_setup.h"
#include "cli/marked_source.h"
#include "cli/option_families.h"
#include "cli/option_numbers.h"
#include "cli/picture.h"
#include "cli/picture_options.h"
#include "cli/scene_meshes.h"
#include "cli/scene_setup.h"
#include "gl/headless_context.h"
#include "measure/prediction/predicted_functions.h"
#include "render/gpu/texture_loader.h"
#include "render/surfaces/object_rows.h"
#include "render/surfaces/scene_depth.h"
#include "shading/effects/effect_set.h"
#include "shading/effects/surface_program.h"
#include "shading/program/program_source.h"

namespace patina {
namespace {

/// Pixels; the size of timed frames where the command line gives none
constexpr glm::ivec2 usualSize{384, 384};

struct EffectsOptions {
    std::string preset;
    PictureOptions picture;
    bool source = false;
    bool json = false;
    bool noCost = false;
    bool hasSize = false; ///< the command line gives the size
    double seconds = 10.0;
    /// Are those that costs are also predicted for.
    std::vector<const GpuFamily*> families;
    /// Is its name, or its number from 1; empty for the first one.
    std::optional<std::string> object;
};

/// Holds a scene and the index of the object that the options name.
struct Shown {
    const Scene& scene;
    std::size_t object = 0;
    const MeshSource& meshes;
};

std::string numbersText(const std::vector<std::size_t>& objects) {
    std::string text;
    for (const std::size_t object : objects) {
        text += fmt::format("{}{}", text.empty() ? "" : ", ", object + 1);
    }
    return text;
}

std::vector<std::size_t> objectsNamed(const Scene& scene, const std::string& name) {
    std::vector<std::size_t> objects;
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        if (scene.objects[i].name == name) {
            objects.push_back(i);
        }
    }
    return objects;
}

/// Returns the number that a whole text is; 0 where it is none.
std::size_t numberIn(const std::string& text) {
    std::size_t number = 0;
    const auto [end, status] = std::from_chars(text.data(), text.data() + text.size(), number);
    return status == std::errc() && end == text.data() + text.size() ? number : 0;
}

/// Finds the object of a name, or else of a number, so that an object called "2" can be named. An
/// empty name finds none.
Result<std::size_t> chosenObject(const Scene& scene, const std::string& wanted) {
    const std::vector<std::size_t> named =
        wanted.empty() ? std::vector<std::size_t>() : objectsNamed(scene, wanted);
    if (named.size() > 1) {
        return failure(
            fmt::format("--object \"{}\": {} objects are called so", wanted, named.size()),
            fmt::format("one of the numbers {}", numbersText(named)));
    }
    if (named.size() == 1) {
        return named.front();
    }
    const std::size_t number = numberIn(wanted);
    if (number >= 1 && number <= scene.objects.size()) {
        return number - 1;
    }
    return failure(fmt::format("--object \"{}\": the scene has no such object", wanted),
                   scene.objects.size() == 1
                       ? std::string("1")
                       : fmt::format("a name, or a number from 1 to {}", scene.objects.size()));
}

/// Reports that the time is too short for certain costs, and what would be enough.
void reportShortTime(const EffectCosts& costs, const EffectsOptions& options) {
    if (costs.secondsNeeded > 0.0) {
        report(oneError(
            failure(fmt::format("--seconds {:g} is too short for certain costs of all effects",
                                options.seconds),
                    fmt::format("about {:.0f} here{}", std::ceil(costs.secondsNeeded),
                                options.hasSize ? ", or a smaller --size" : ""))
                .value()));
    }
}

/// Measures the costs; returns nothing, after a remark, where there is no graphics driver.
Checked<std::optional<EffectCosts>> measured(EffectCostMeter::Subject subject,
                                             const EffectsOptions& options) {
    EffectCostMeter::Options wanted;
    wanted.size = options.picture.size;
    wanted.programCache = programCacheFolder();
    wanted.seconds = options.seconds;
    wanted.mayShrink = !options.hasSize;
    const auto context = gl::HeadlessContext::create();
    auto meter = context ? EffectCostMeter::create(std::move(subject), wanted)
                         : tl::unexpected(context.error());
    if (!meter) {
        report(oneError({{}, 0, 0, "costs are not measured: " + meter.error().text(), {}}));
        return std::nullopt;
    }
    while (!(*meter)->finished()) {
        (*meter)->step();
    }
    EffectCosts costs = (*meter)->costs();
    if (!costs.problems.empty()) {
        return tl::unexpected(costs.problems);
    }
    reportShortTime(costs, options);
    return costs;
}

double aspectOf(const EffectsOptions& options) {
    return double(options.picture.size.x) / double(std::max(options.picture.size.y, 1));
}

ShownObject shownObject(const Shown& subject) {
    return {subject.scene.objects[subject.object].name, subject.object + 1,
            subject.scene.objects.size()};
}

/// Holds the images of a scene.
struct Images {
    TextureLoader textures;
    std::shared_ptr<const EnvironmentImage> environment;

    KnownImages known() {
        return {textures.source(), environment != nullptr && environment->isMissing};
    }
};

Checked<void> printTable(const Shown& subject, const EffectsOptions& options,
                         const std::shared_ptr<const Catalog>& catalog, Images& images) {
    const auto& [scene, object, meshes] = subject;
    EffectTable table;
    table.object = shownObject(subject);
    table.rows = objectRows(scene, object, *catalog, meshes, images.known(), aspectOf(options));
    if (!options.noCost) {
        auto costs = measured({scene, scene.camera, meshes, table.rows, catalog,
                               images.textures.source(), images.environment},
                              options);
        if (!costs) {
            return tl::unexpected(costs.error());
        }
        table.costs = std::move(*costs);
    }
    if (!options.families.empty()) {
        auto predicted =
            predictedEffects({scene, object, meshes, catalog}, table.rows, options.families);
        if (predicted && !predicted->whole) {
            predicted = tl::unexpected(oneError(predicted->whole.error()));
        }
        if (!predicted) {
            return tl::unexpected(predicted.error());
        }
        table.families = options.families;
        table.predicted = std::move(*predicted);
    }
    std::cout << (options.json ? writeJson(tableJson(table)) : tableText(table));
    return {};
}

struct NamedProgram {
    std::string name; ///< is empty for the surface's own
    ProgramSource source;
};

/// Returns the object's program, and those of its fins, its marks and its outline where it has
/// them.
Checked<std::vector<NamedProgram>> programsOf(const EffectSet& set, const Catalog& catalog) {
    std::vector<NamedProgram> programs;
    Errors errors;
    const auto add = [&](const char* name, Checked<ProgramSource> made) {
        if (made) {
            programs.push_back({name, std::move(*made)});
        } else {
            errors = made.error();
        }
    };
    add("", surfaceProgram(set, catalog));
    if (set.shells && hasFins(*set.shells)) {
        add("fins", finsProgram(set, catalog));
    }
    if (set.strokes) {
        add("marks", marksProgram(set, catalog));
    }
    if (set.outline) {
        add("outline", outlineProgram(set, catalog));
    }
    if (!errors.empty()) {
        return tl::unexpected(errors);
    }
    return programs;
}

nlohmann::json sourceJson(const ProgramSource& program) {
    nlohmann::json json{{"vertex", program.vertex.text}, {"fragment", program.fragment.text}};
    if (program.geometry) {
        json["geometry"] = program.geometry->text;
    }
    return json;
}

/// Returns what each function takes on a family as the margin of its line.
std::map<int, std::string> marginsOf(const PredictedFunctions& predicted, const GpuFamily& family) {
    std::map<int, std::string> margins;
    for (const PredictedFunction& function : predicted.functions) {
        if (const auto saving = predicted.savingOf(function, family.id)) {
            margins[function.line] =
                fmt::format("{} {:3} VGPRs {:6.0f} cycles",
                            family.isMali ? std::string(12, ' ')
                                          : fmt::format("{:5} instr.", saving->instructions),
                            saving->registers, saving->cycles);
        }
    }
    return margins;
}

/// Explains the margin, and names the function of a block that takes most registers.
std::string marginLegend(const PredictedFunctions& predicted, const GpuFamily& family) {
    std::string text = fmt::format(
        "// predicted for {} by the compiler of {}: what a function takes, with what is computed "
        "for it alone, so that a function and one that it calls both have the share of that\n",
        family.label, predicted.driver);
    const PredictedFunction* most = predicted.widest(family.id);
    if (most != nullptr) {
        text += fmt::format("// most registers: {} of {} because of {}()\n",
                            predicted.savingOf(*most, family.id)->registers,
                            predicted.whole->at(family.id).fragment.vectorRegisters, most->name);
    }
    return text;
}

nlohmann::json functionsJson(const PredictedFunctions& predicted,
                             std::span<const GpuFamily* const> families) {
    nlohmann::json functions = nlohmann::json::array();
    for (const PredictedFunction& function : predicted.functions) {
        nlohmann::json each{{"function", function.name}, {"line", function.line}};
        for (const GpuFamily* family : families) {
            if (const auto saving = predicted.savingOf(function, family->id)) {
                each["families"][family->id] = {{"instructions", saving->instructions},
                                                {"vgprs", saving->registers},
                                                {"cycles", saving->cycles}};
            }
        }
        functions.push_back(std::move(each));
    }
    return functions;
}

void printStages(const std::string& name, const ProgramSource& program,
                 const std::vector<EffectLine>& lines,
                 const std::map<int, std::string>& margins = {}) {
    std::cout << markedSource(name + "vertex stage", program.vertex, lines);
    if (program.geometry) {
        std::cout << markedSource(name + "geometry stage", *program.geometry, lines);
    }
    std::cout << markedSource(name + "fragment stage", program.fragment, lines, margins);
}

/// Prints the program of the object as it is seen from the scene's camera. Fails for an object that
/// is not drawn.
Checked<void> printSource(const Shown& subject, const EffectsOptions& options,
                          const Catalog& catalog, Images& images) {
    const auto& [scene, object, meshes] = subject;
    if (const std::string why = whyNotDrawn(scene, object, catalog, meshes, aspectOf(options));
        !why.empty()) {
        return tl::unexpected(oneError(
            failure(fmt::format("{} has no shader: {}", objectText(shownObject(subject)), why))
                .value()));
    }
    const Material& material = scene.objects[object].material;
    const EffectView view = objectView(scene, object, catalog, meshes);
    const EffectSet set = effectSet(material, scene, catalog, view);
    const auto programs = programsOf(set, catalog);
    if (!programs) {
        return tl::unexpected(programs.error());
    }
    std::optional<PredictedFunctions> functions;
    if (!options.families.empty()) {
        auto predicted = predictedFunctions(
            {programs->front().source.vertex.text, programs->front().source.fragment.text},
            options.families);
        if (!predicted || !predicted->whole) {
            return tl::unexpected(
                oneError(predicted ? predicted->whole.error() : predicted.error()));
        }
        functions = std::move(*predicted);
    }
    if (options.json) {
        nlohmann::json json = tableJson(
            {shownObject(subject),
             objectRows(scene, object, catalog, meshes, images.known(), aspectOf(options)),
             {}});
        for (const NamedProgram& program : *programs) {
            const nlohmann::json source = sourceJson(program.source);
            if (program.name.empty()) {
                json.update(source);
            } else {
                json[program.name] = source;
            }
        }
        if (functions) {
            json["functions"] = functionsJson(*functions, options.families);
        }
        std::cout << writeJson(json);
        return {};
    }
    const std::vector<EffectLine> lines = effectLines(set, {&material, scene, catalog, view});
    std::cout << "// " << objectText(shownObject(subject)) << '\n';
    std::map<int, std::string> margins;
    if (functions) {
        const GpuFamily& family = *options.families.front();
        std::cout << marginLegend(*functions, family);
        margins = marginsOf(*functions, family);
    }
    for (const NamedProgram& program : *programs) {
        const bool isSurface = program.name.empty();
        printStages(isSurface ? "" : program.name + ": ", program.source, lines,
                    isSurface ? margins : std::map<int, std::string>());
    }
    return {};
}

Checked<void> effects(const EffectsOptions& options) {
    if (options.preset.empty() && options.picture.model.empty() && options.picture.scene.empty()) {
        return tl::unexpected(oneError(
            failure("there is nothing to look at", "a preset, --model or --scene").value()));
    }
    const auto catalog = std::make_shared<const Catalog>(loadCatalog(standardBlockRoots()));
    report(catalog->errors);
    const auto setup = sceneFor(options.preset, options.picture, *catalog);
    if (!setup) {
        return tl::unexpected(setup.error());
    }
    report(setup->notes);
    if (setup->scene.objects.empty()) {
        return tl::unexpected(oneError(
            failure("the scene is empty", "a preset, --model or --mesh beside it").value()));
    }
    const auto object =
        options.object ? chosenObject(setup->scene, *options.object) : Result<std::size_t>(0);
    if (!object) {
        return tl::unexpected(oneError(object.error()));
    }
    AssetClient files;
    files.setRights(setup->rights);
    const auto loaded = SceneMeshes::load(setup->scene, *catalog, files);
    if (!loaded) {
        return tl::unexpected(loaded.error());
    }
    report(loaded->remarks());
    const MeshSource meshes = [&loaded](const Object& each) { return loaded->view(each); };
    const Shown subject{setup->scene, *object, meshes};
    const auto environment = environmentPicture(setup->scene, options.picture, *catalog, files);
    if (!environment) {
        return tl::unexpected(oneError(environment.error()));
    }
    Images images{TextureLoader(files), *environment};
    auto done = options.source ? printSource(subject, options, *catalog, images)
                               : printTable(subject, options, catalog, images);
    report(images.textures.takeProblems());
    return done;
}

} // namespace

void addEffects(CLI::App& program, int& status) {
    CLI::App* command = program.add_subcommand(
        "effects", "List which effects a preset needs in a scene, why, and what each costs");
    auto options = std::make_shared<EffectsOptions>();
    options->picture.size = usualSize;
    command->add_option("preset", options->preset, "A preset (*.patina.json)");
    addSceneOptions(*command, options->picture);
    addSizeOption(*command, options->picture);
    command->add_option("--object", options->object,
                        "The object whose effects are listed: its name, or its number from 1; "
                        "unless given the first one, which has the preset");
    command->add_flag("--source", options->source,
                      "Print the shader instead, each block marked; with --gpu a margin says what "
                      "each function takes there; with --json its stages beside the list, as "
                      "\"vertex\" and \"fragment\"");
    command->add_flag("--json", options->json, "Print JSON");
    command->add_flag("--no-cost", options->noCost,
                      "Do not draw the frames that show what each effect costs");
    addFamiliesOption(*command, options->families);
    addSecondsOption(*command, options->seconds,
                     "No longer than about this frames for the costs are drawn, what programs "
                     "take to be made apart; slow ones are drawn smaller unless --size is given, "
                     "and less often, and costs of too few are marked !");
    command->callback([options, command, &status] {
        options->hasSize = command->count("--size") > 0;
        const auto done = effects(*options);
        status = done ? 0 : 1;
        if (!done) {
            report(done.error());
        }
    });
}

} // namespace patina
