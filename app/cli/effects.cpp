// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/command.h"

#include <charconv>
#include <filesystem>
#include <iostream>
#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "catalog/json_text.h"
#include "cli/picture_options.h"
#include "cli/scene_setup.h"
#include "shading/effect_set.h"
#include "shading/program_source.h"

namespace patina {
namespace {

struct Options {
    std::string preset;
    PictureOptions picture;
    bool source = false;
    bool json = false;
};

Errors oneError(Error error) {
    return {std::move(error)};
}

void printList(const EffectSet& set) {
    for (const EffectLine& line : effectLines(set)) {
        const std::string detail = line.detail.empty() ? "" : " (" + line.detail + ")";
        std::cout << fmt::format("{}{}: {}\n", line.effect, detail, line.reason);
    }
    for (const auto* list : {&set.leftOut, &set.scene.leftOut}) {
        for (const LeftOut& left : *list) {
            std::cout << fmt::format("not in: {}: {}\n", left.what, left.reason);
        }
    }
}

nlohmann::json leftOutJson(const EffectSet& set) {
    nlohmann::json array = nlohmann::json::array();
    for (const auto* list : {&set.leftOut, &set.scene.leftOut}) {
        for (const LeftOut& left : *list) {
            array.push_back({{"what", left.what}, {"reason", left.reason}});
        }
    }
    return array;
}

nlohmann::json toJson(const EffectSet& set) {
    nlohmann::json effects = nlohmann::json::array();
    for (const EffectLine& line : effectLines(set)) {
        effects.push_back(
            {{"effect", line.effect}, {"detail", line.detail}, {"reason", line.reason}});
    }
    return {{"effects", effects}, {"leftOut", leftOutJson(set)}};
}

/// The file that a "#line N S" starts, or nullptr for any other line.
const std::string* fileStarting(std::string_view line, const ShaderSource& source) {
    if (!line.starts_with("#line ")) {
        return nullptr;
    }
    const std::string_view number = line.substr(line.rfind(' ') + 1);
    std::size_t index = 0;
    std::from_chars(number.data(), number.data() + number.size(), index);
    return index < source.files.size() ? &source.files[index] : nullptr;
}

std::string shortName(const std::string& file) {
    const std::filesystem::path path(file);
    return (path.parent_path().filename() / path.filename()).generic_string();
}

/// The stage's text, with a comment where a file's part begins instead of line directives.
void printStage(const char* title, const ShaderSource& source) {
    std::cout << "// ======== " << title << '\n';
    std::string_view rest = source.text;
    const std::string* current = nullptr;
    while (!rest.empty()) {
        const std::size_t end = rest.find('\n');
        const std::string_view line = rest.substr(0, end);
        const std::string* file = fileStarting(line, source);
        if (file == nullptr) {
            std::cout << line << '\n';
        } else if (file != current) {
            std::cout << "// ---- " << shortName(*file) << '\n';
            current = file;
        }
        rest.remove_prefix(end == std::string_view::npos ? rest.size() : end + 1);
    }
}

Checked<void> print(const EffectSet& set, const Options& options, const Catalog& catalog) {
    if (!options.source) {
        options.json ? void(std::cout << writeJson(toJson(set))) : printList(set);
        return {};
    }
    const auto program = surfaceProgram(set, catalog);
    if (!program) {
        return tl::unexpected(program.error());
    }
    if (options.json) {
        nlohmann::json json = toJson(set);
        json["vertex"] = program->vertex.text;
        json["fragment"] = program->fragment.text;
        std::cout << writeJson(json);
        return {};
    }
    printStage("vertex stage", program->vertex);
    printStage("fragment stage", program->fragment);
    return {};
}

Checked<void> effects(const Options& options) {
    if (options.preset.empty() && options.picture.model.empty() && options.picture.scene.empty()) {
        return tl::unexpected(oneError(
            failure("there is nothing to look at", "a preset, --model or --scene").value()));
    }
    const Catalog catalog = loadCatalog(standardBlockRoots());
    report(catalog.errors);
    const auto setup = sceneFor(options.preset, options.picture, catalog);
    if (!setup) {
        return tl::unexpected(setup.error());
    }
    report(setup->notes);
    if (setup->scene.objects.empty()) {
        return tl::unexpected(oneError(
            failure("the scene is empty", "a preset, --model or --mesh beside it").value()));
    }
    const Material& material = setup->scene.objects.front().material;
    return print(effectSet(material, setup->scene, catalog), options, catalog);
}

} // namespace

void addEffects(CLI::App& program, int& status) {
    CLI::App* command =
        program.add_subcommand("effects", "List which effects a preset needs in a scene and why");
    auto options = std::make_shared<Options>();
    command->add_option("preset", options->preset, "A preset (*.patina.json)");
    addSceneOptions(*command, options->picture);
    command->add_flag("--source", options->source, "Print the shader instead, each block marked");
    command->add_flag("--json", options->json, "Print JSON");
    command->callback([options, &status] {
        const auto done = effects(*options);
        status = done ? 0 : 1;
        if (!done) {
            report(done.error());
        }
    });
}

} // namespace patina
