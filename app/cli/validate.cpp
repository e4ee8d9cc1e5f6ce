// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/command.h"

#include <algorithm>
#include <iostream>
#include <memory>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "catalog/catalog.h"
#include "catalog/descriptor.h"
#include "catalog/descriptor_checks.h"
#include "catalog/json_reader.h"
#include "catalog/json_schema.h"
#include "catalog/shader_names.h"
#include "catalog/value_json.h"
#include "cli/job.h"
#include "cli/long_work.h"
#include "cli/shader_mistakes.h"
#include "material/measured_preset.h"
#include "material/preset_file.h"
#include "material/reading_rights.h"
#include "measured/measured_reflectance.h"
#include "scene/mesh_path.h"
#include "scene/scene_file.h"
#include "scene/scene_limits.h"
#include "sheet/sheet_file.h"

namespace patina {
namespace {

namespace fs = std::filesystem;

template <class Reading>
Errors mistakesOf(const Checked<Reading>& reading) {
    return reading ? reading->notes : reading.error();
}

/// Returns the ids that a slot may name: those of the catalogue, and those in the folder of the
/// kind beside the file's own folder.
std::vector<std::string> idsOfKind(const std::string& kind, const fs::path& file,
                                   const Catalog& catalog) {
    std::vector<std::string> ids;
    for (const Block* block : catalog.ofKind(kind)) {
        ids.push_back(block->id);
    }
    std::error_code absent; // leaves the list empty
    const fs::path folder = fs::absolute(file).lexically_normal().parent_path().parent_path();
    for (const auto& entry : fs::directory_iterator(folder / kind, absent)) {
        if (entry.path().extension() == ".json") {
            ids.push_back(entry.path().stem().string());
        }
    }
    return ids;
}

Errors descriptorMistakesIn(const fs::path& file, const Catalog& catalog, ShaderMistakes& shaders) {
    const Result<JsonSchema> schema = JsonSchema::load("descriptor");
    if (!schema) {
        return {schema.error()};
    }
    const Checked<Descriptor> descriptor = readDescriptor(file, *schema);
    if (!descriptor) {
        return descriptor.error();
    }
    Errors mistakes = slotMistakes(
        *descriptor, [&](const std::string& kind) { return idsOfKind(kind, file, catalog); });
    const Errors names = nameMistakes(*descriptor, shaderNames(dataFolder() / "shaders"));
    mistakes.insert(mistakes.end(), names.begin(), names.end());
    sortByPlace(mistakes);
    return mistakes.empty() ? shaders.of(file) : mistakes;
}

/// Tells whether the file of a mesh is missing; names of meshes made by code are checked by the
/// reader.
bool isMissing(const std::string& mesh) {
    std::error_code absent;
    return !builtinName(mesh) && !fs::is_regular_file(mesh, absent);
}

/// Adds an error for each image that is missing, of a material written at `place` (a JSON pointer).
void addImageMistakes(Errors& errors, const LocatedJson& document, const std::string& place,
                      const Material& material) {
    for (const auto& [key, use] : material.textures) {
        std::error_code absent;
        if (!use.outside && !isVertexColors(use.file) && !fs::is_regular_file(use.file, absent)) {
            errors.push_back(
                document.error(fmt::format("{}/textures/{}/file", place, escapedToken(key)),
                               fmt::format("there is no image \"{}\"", use.file),
                               "a path from the folder of this file"));
        }
    }
}

/// Adds an error where a material shows a measured surface whose file cannot be read.
void addMeasuredMistake(Errors& errors, const LocatedJson& document, const std::string& place,
                        const Material& material, const Catalog& catalog) {
    const Block* model = catalog.find(kinds::models, material.model.id);
    const Parameter* parameter = model != nullptr ? tableParameter(*model) : nullptr;
    if (parameter == nullptr || !material.model.parameters.contains(parameter->id)) {
        return;
    }
    const auto& file = std::get<std::string>(material.model.parameters.at(parameter->id));
    if (file.empty()) {
        return;
    }
    if (const auto read = readMeasured(file); !read) {
        errors.push_back(document.error(
            fmt::format("{}/parameters/{}", place, escapedToken(parameter->id)),
            fmt::format("\"{}\" {}", file, read.error().problem), read.error().expected));
    }
}

/// Adds errors for the pictures that blocks of a scene name and that are missing.
class MissingPictures {
  public:
    MissingPictures(Errors& errors, const LocatedJson& document, const Catalog& catalog,
                    const OutsideFiles& outside)
        : errors_(errors), document_(document), catalog_(catalog), outside_(outside) {}

    void addOf(const Scene& scene) {
        addOf(scene.parts, {});
        for (std::size_t i = 0; i < scene.passes.size(); ++i) {
            addOf(scene.passes[i], kinds::pass, fmt::format("/passes/{}", i));
        }
        for (std::size_t i = 0; i < scene.lights.size(); ++i) {
            const std::string place = fmt::format("/lights/{}", i);
            addOf(scene.lights[i].block, kinds::lights, place);
            addOf(scene.lights[i].parts, place);
        }
    }

  private:
    void addOf(const BlockParts& parts, const std::string& place) {
        for (const auto& [kind, values] : parts) {
            addOf(values, kind, fmt::format("{}/{}", place, findKind(kind)->singular));
        }
    }

    void addOf(const BlockValues& values, std::string_view kind, const std::string& place) {
        const Block* block = catalog_.find(kind, values.id);
        for (std::size_t i = 0; block != nullptr && i < block->parameters.size(); ++i) {
            const Parameter& parameter = block->parameters[i];
            const auto value = values.parameters.find(parameter.id);
            if (infoOf(parameter.type).isFile && value != values.parameters.end()) {
                add(std::get<std::string>(value->second),
                    fmt::format("{}/parameters/{}", place, escapedToken(parameter.id)));
            }
        }
    }

    void add(const std::string& picture, const std::string& place) {
        std::error_code absent;
        const fs::path path = referenceFolder(document_.file) / picture;
        const bool isOutside = std::ranges::any_of(
            outside_, [&](const OutsideFile& each) { return each.file == path.generic_string(); });
        if (!picture.empty() && !isOutside && !fs::is_regular_file(path, absent)) {
            errors_.push_back(document_.error(place,
                                              fmt::format("there is no picture \"{}\"", picture),
                                              "a path from the scene's folder"));
        }
    }

    Errors& errors_;
    const LocatedJson& document_;
    const Catalog& catalog_;
    const OutsideFiles& outside_; ///< are told as such
};

/// Returns an error for each file that a scene names and that is missing.
Errors absentFiles(const fs::path& file, const SceneReading& reading, const Catalog& catalog) {
    const Result<LocatedJson> document = readJson(file, sceneLimits);
    Errors errors;
    if (document) {
        MissingPictures(errors, *document, catalog, reading.outside).addOf(reading.scene);
    }
    const Scene& scene = reading.scene;
    for (std::size_t i = 0; document && i < scene.objects.size(); ++i) {
        const Object& object = scene.objects[i];
        if (isMissing(object.mesh)) {
            errors.push_back(document->error(fmt::format("/objects/{}/mesh", i),
                                             fmt::format("there is no file \"{}\"", object.mesh),
                                             "a path from the scene's folder, or builtin:<name>"));
        }
        const std::string preset = fmt::format("/objects/{}/preset", i);
        addImageMistakes(errors, *document, preset, object.material);
        addMeasuredMistake(errors, *document, preset, object.material, catalog);
    }
    return errors;
}

Errors presetMistakesIn(const fs::path& file, const Catalog& catalog) {
    const auto reading = readPreset(file, catalog);
    Errors errors = mistakesOf(reading);
    const Result<LocatedJson> document = readJson(file, sceneLimits);
    if (reading && document) {
        addImageMistakes(errors, *document, {}, reading->material);
        addMeasuredMistake(errors, *document, {}, reading->material, catalog);
    }
    return errors;
}

Errors sceneMistakesIn(const fs::path& file, const Catalog& catalog) {
    const auto reading = readScene(file, catalog);
    Errors errors = mistakesOf(reading);
    if (reading) {
        const Errors absent = absentFiles(file, *reading, catalog);
        errors.insert(errors.end(), absent.begin(), absent.end());
    }
    return errors;
}

Errors sheetMistakesIn(const fs::path& file) {
    const auto reading = readSheet(file);
    Errors errors = mistakesOf(reading);
    const Result<LocatedJson> document = readJson(file);
    std::error_code absent;
    if (reading && document && !reading->sheet.preset.empty() &&
        !fs::is_regular_file(reading->sheet.preset, absent)) {
        errors.push_back(document->error(
            "/preset", fmt::format("there is no preset \"{}\"", reading->sheet.preset),
            "a path from the folder of this file"));
    }
    return errors;
}

/// Returns the format that the file's name tells, or else its "format".
std::string formatOf(const fs::path& file) {
    const std::string name = file.filename().string();
    const auto endsWith = [&name](std::string_view ending) {
        return name.size() >= ending.size() &&
               name.compare(name.size() - ending.size(), ending.size(), ending) == 0;
    };
    if (endsWith(".patina-scene.json")) {
        return "patina.scene";
    }
    if (endsWith(sheetEnding)) {
        return std::string(sheetFormat.name);
    }
    if (endsWith(".patina.json")) {
        return "patina.preset";
    }
    const Result<LocatedJson> document = readJson(file, sceneLimits);
    const bool says = document && document->value.is_object() &&
                      document->value.contains("format") && document->value["format"].is_string();
    return says ? document->value["format"].get<std::string>() : std::string();
}

Errors mistakesIn(const fs::path& file, const Catalog& catalog, ShaderMistakes& shaders) {
    const std::string format = formatOf(file);
    if (format == "patina.scene") {
        return sceneMistakesIn(file, catalog);
    }
    if (format == sheetFormat.name) {
        return sheetMistakesIn(file);
    }
    return format.empty() ? descriptorMistakesIn(file, catalog, shaders)
                          : presetMistakesIn(file, catalog);
}

nlohmann::json toJson(const Error& error) {
    return {{"file", error.file},
            {"line", error.line},
            {"column", error.column},
            {"problem", error.problem},
            {"expected", error.expected}};
}

struct ValidateOptions {
    std::vector<std::string> files;
    bool json = false;
    JobOptions job;
};

nlohmann::json toJson(const Errors& mistakes) {
    nlohmann::json errors = nlohmann::json::array();
    for (const Error& error : mistakes) {
        errors.push_back(toJson(error));
    }
    return {{"valid", mistakes.empty()}, {"errors", errors}};
}

/// Checks the files of a job.
class ValidateWork : public JobWork {
  public:
    explicit ValidateWork(const Catalog& catalog) : catalog_(catalog), shaders_(catalog) {}

    Checked<nlohmann::json> resultOf(const std::string& file) override {
        const Errors mistakes = mistakesIn(file, catalog_, shaders_);
        report(mistakes);
        return toJson(mistakes);
    }

    bool isGood(const nlohmann::json& result) const override {
        return result.value("valid", false);
    }

  private:
    const Catalog& catalog_;
    ShaderMistakes shaders_;
};

void print(const ValidateOptions& options, const std::vector<Errors>& mistakes) {
    nlohmann::json array = nlohmann::json::array();
    for (std::size_t i = 0; i < mistakes.size(); ++i) {
        array.push_back(toJson(mistakes[i]));
        array.back()["file"] = options.files[i];
    }
    std::cout << writeJson(array);
}

/// Returns the exit status.
Checked<int> validate(const CLI::App& command, const ValidateOptions& options) {
    const Catalog catalog = loadCatalog(standardBlockRoots());
    if (options.job.isWanted()) {
        ValidateWork work(catalog);
        LongWork longWork;
        return runJob({command, options.job, options.files, catalog}, work, longWork);
    }
    ShaderMistakes shaders(catalog);
    bool valid = true;
    std::vector<Errors> mistakes;
    for (const std::string& file : options.files) {
        mistakes.push_back(mistakesIn(file, catalog, shaders));
        valid = valid && mistakes.back().empty();
        report(mistakes.back());
        if (!options.json && mistakes.back().empty()) {
            std::cout << file << ": valid\n";
        }
    }
    if (options.json) {
        print(options, mistakes);
    }
    return valid ? 0 : 1;
}

} // namespace

void addValidate(CLI::App& program, int& status) {
    CLI::App* command = program.add_subcommand(
        "validate",
        "Check presets, scenes, sheets and blocks, descriptor and GLSL; every mistake with its "
        "place");
    auto options = std::make_shared<ValidateOptions>();
    command->add_option("files", options->files, "The files")->required();
    auto* json = command->add_flag("--json", options->json, "Print the mistakes as JSON");
    addJobOptions(*command, options->job)->excludes(json);
    command->callback([command, options, &status] {
        const Checked<int> ended = validate(*command, *options);
        status = ended.value_or(1);
        if (!ended) {
            report(ended.error());
        }
    });
}

} // namespace patina
