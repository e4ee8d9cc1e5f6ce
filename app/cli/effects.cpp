// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/command.h"

#include <iostream>
#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "assets/asset_client.h"
#include "catalog/json_text.h"
#include "cli/effect_table.h"
#include "cli/environment_setup.h"
#include "cli/marked_source.h"
#include "cli/picture.h"
#include "cli/picture_options.h"
#include "cli/scene_meshes.h"
#include "cli/scene_setup.h"
#include "gl/headless_context.h"
#include "render/scene_depth.h"
#include "render/texture_loader.h"
#include "render/unreached_lights.h"
#include "shading/outline_source.h"
#include "shading/program_source.h"

namespace patina {
namespace {

/// What the frames that are timed have where the command line does not say.
constexpr glm::ivec2 usualSize{384, 384};

struct Options {
    std::string preset;
    PictureOptions picture;
    bool source = false;
    bool json = false;
    bool noCost = false;
};

Errors oneError(Error error) {
    return {std::move(error)};
}

/// The costs; nothing, and a remark, where there is no graphics driver.
Checked<std::optional<EffectCosts>> measured(EffectCostMeter::Subject subject, glm::ivec2 size) {
    const auto context = gl::HeadlessContext::create();
    auto meter = context
                     ? EffectCostMeter::create(std::move(subject), {size, 15, programCacheFolder()})
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
    return costs;
}

std::vector<EffectRow> rowsOf(const Scene& scene, const Catalog& catalog,
                              const MeshSource& meshes) {
    std::vector<EffectRow> rows =
        effectRows(scene, 0, catalog, effectView(scene, scene.camera, meshes));
    for (EffectRow& row : unreachedRows(scene, 0, catalog, meshes)) {
        rows.push_back(std::move(row));
    }
    return rows;
}

Checked<void> printTable(const Scene& scene, const Options& options,
                         const std::shared_ptr<const Catalog>& catalog, const MeshSource& meshes,
                         AssetClient& files) {
    EffectTable table;
    table.rows = rowsOf(scene, *catalog, meshes);
    if (!options.noCost) {
        TextureLoader textures(files);
        const auto environment = environmentPicture(scene, options.picture, *catalog, files);
        if (!environment) {
            return tl::unexpected(oneError(environment.error()));
        }
        auto costs = measured({scene, scene.camera, meshes, table.rows, catalog, textures.source(),
                               *environment},
                              options.picture.size);
        report(textures.takeProblems());
        if (!costs) {
            return tl::unexpected(costs.error());
        }
        table.costs = std::move(*costs);
    }
    std::cout << (options.json ? writeJson(tableJson(table)) : tableText(table));
    return {};
}

/// The object's program, and that of its outline where it has one.
Checked<std::vector<ProgramSource>> programsOf(const EffectSet& set, const Catalog& catalog) {
    std::vector<ProgramSource> programs;
    for (const bool isOutline : {false, true}) {
        if (isOutline && !set.outline) {
            continue;
        }
        auto made = isOutline ? outlineProgram(set, catalog) : surfaceProgram(set, catalog);
        if (!made) {
            return tl::unexpected(made.error());
        }
        programs.push_back(std::move(*made));
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

void printStages(const std::string& name, const ProgramSource& program,
                 const std::vector<EffectLine>& lines) {
    std::cout << markedSource(name + "vertex stage", program.vertex, lines);
    if (program.geometry) {
        std::cout << markedSource(name + "geometry stage", *program.geometry, lines);
    }
    std::cout << markedSource(name + "fragment stage", program.fragment, lines);
}

/// The program for what the table shows: seen from the scene's camera.
Checked<void> printSource(const Scene& scene, const Options& options, const Catalog& catalog,
                          const MeshSource& meshes) {
    const EffectSet set = effectSet(scene.objects.front().material, scene, catalog,
                                    effectView(scene, scene.camera, meshes));
    const auto programs = programsOf(set, catalog);
    if (!programs) {
        return tl::unexpected(programs.error());
    }
    if (options.json) {
        nlohmann::json json = tableJson({rowsOf(scene, catalog, meshes), {}});
        json.update(sourceJson(programs->front()));
        if (set.outline) {
            json["outline"] = sourceJson(programs->back());
        }
        std::cout << writeJson(json);
        return {};
    }
    const std::vector<EffectLine> lines = effectLines(set);
    printStages("", programs->front(), lines);
    if (set.outline) {
        printStages("outline: ", programs->back(), lines);
    }
    return {};
}

Checked<void> effects(const Options& options) {
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
    AssetClient files;
    const auto loaded = SceneMeshes::load(setup->scene, files);
    if (!loaded) {
        return tl::unexpected(loaded.error());
    }
    report(loaded->remarks());
    const auto meshes = [&loaded](const Object& object) { return loaded->view(object); };
    return options.source ? printSource(setup->scene, options, *catalog, meshes)
                          : printTable(setup->scene, options, catalog, meshes, files);
}

} // namespace

void addEffects(CLI::App& program, int& status) {
    CLI::App* command = program.add_subcommand(
        "effects", "List which effects a preset needs in a scene, why, and what each costs");
    auto options = std::make_shared<Options>();
    options->picture.size = usualSize;
    command->add_option("preset", options->preset, "A preset (*.patina.json)");
    addSceneOptions(*command, options->picture);
    addSizeOption(*command, options->picture);
    command->add_flag("--source", options->source, "Print the shader instead, each block marked");
    command->add_flag("--json", options->json, "Print JSON");
    command->add_flag("--no-cost", options->noCost,
                      "Do not draw the frames that show what each effect costs");
    command->callback([options, &status] {
        const auto done = effects(*options);
        status = done ? 0 : 1;
        if (!done) {
            report(done.error());
        }
    });
}

} // namespace patina
