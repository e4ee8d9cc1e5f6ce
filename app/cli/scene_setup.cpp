// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/scene_setup.h"

#include <algorithm>

#include <fmt/format.h>

#include "catalog/fills.h"
#include "cli/scene_choices.h"
#include "cli/texture_text.h"
#include "core/ordinary_file.h"
#include "material/material_assignment.h"
#include "material/measured_preset.h"
#include "material/model_swap.h"
#include "material/preset_file.h"
#include "scene/scene_assignment.h"
#include "scene/scene_file.h"

namespace patina {
namespace {

constexpr std::string_view builtin = "builtin:";

/// Tells whether a block is chosen that the shown object's material would have.
bool choosesPart(const PictureOptions& options) {
    return std::ranges::any_of(partKinds(BlockOwner::Material),
                               [&](std::string_view kind) { return !options.part(kind).empty(); });
}

/// Tells whether an option speaks of the object that is shown.
bool needsObject(const std::string& preset, const PictureOptions& options) {
    return !preset.empty() || !options.model.empty() || !options.mesh.empty() ||
           !options.sets.empty() || choosesPart(options) || !options.textures.empty();
}

/// Withholds the files outside its folder that a file names, and notes how they can be read.
void withhold(SceneSetup& setup, const OutsideFiles& outside, const std::string& by) {
    for (const OutsideFile& each : outside) {
        if (each.kind == OutsideFile::Kind::Mesh || each.kind == OutsideFile::Kind::Picture) {
            setup.rights.withheld.insert(each.file);
        }
    }
    if (!outside.empty()) {
        setup.notes.push_back(
            {by, 0, 0, "names files outside its folder, which are not read", allowOutsideHint});
    }
}

ReadingRights rightsFor(const PictureOptions& options) {
    ReadingRights rights;
    rights.everything = options.allowsOutside;
    return rights;
}

/// Reads the scene; where it has no object and options need one, it gets that of the default scene.
Checked<SceneSetup> startScene(const std::string& preset, const PictureOptions& options,
                               const Catalog& catalog) {
    const auto file =
        options.scene.empty() ? defaultSceneFile() : std::filesystem::path(options.scene);
    const auto reading = readScene(file, catalog, rightsFor(options));
    if (!reading) {
        return tl::unexpected(reading.error());
    }
    SceneSetup setup{reading->scene, reading->notes, {{}, {}, options.allowsOutside}};
    withhold(setup, reading->outside, file.string());
    if (setup.scene.objects.empty() && needsObject(preset, options)) {
        const auto shipped = readScene(defaultSceneFile(), catalog);
        if (!shipped) {
            return tl::unexpected(shipped.error());
        }
        setup.scene.objects.push_back(shipped->scene.objects.front());
    }
    return setup;
}

Checked<void> usePreset(SceneSetup& setup, const std::string& preset, const ReadingRights& rights,
                        const Catalog& catalog) {
    const auto reading = readPreset(preset, catalog, rights);
    if (!reading) {
        return tl::unexpected(reading.error());
    }
    setup.scene.objects.front().material = reading->material;
    setup.notes.insert(setup.notes.end(), reading->notes.begin(), reading->notes.end());
    withhold(setup, reading->outside, preset);
    return {};
}

/// Applies the chosen model and blocks. A preset's values are carried over to another model as in
/// the editor; without a preset the model has its defaults.
Result<void> chooseBlocks(Material& material, bool isPreset, const PictureOptions& options,
                          const Catalog& catalog) {
    if (!options.model.empty()) {
        const auto model = knownBlock(catalog, kinds::models, options.model);
        if (!model) {
            return tl::unexpected(model.error());
        }
        material = isPreset ? swappedModel(material, **model, catalog) : defaultMaterial(**model);
    }
    for (const std::string_view kind : partKinds(BlockOwner::Material)) {
        const std::string& id = options.part(kind);
        const auto chosen =
            id.empty() ? Result<bool>(true) : choosePart(material, std::string(kind), id, catalog);
        if (!chosen) {
            return tl::unexpected(chosen.error());
        }
    }
    return {};
}

/// Adds the assignment as it was typed to its error.
Error namingSet(Error error, const std::string& assignment) {
    error.problem = fmt::format("--set {}: {}", assignment, error.problem);
    return error;
}

bool isShorthandIn(const Block* block, std::string_view id) {
    const Parameter* parameter = block == nullptr ? nullptr : block->parameter(id);
    return parameter != nullptr && isShorthand(*parameter);
}

bool isShorthandSet(Material& material, std::string_view id, const Catalog& catalog) {
    if (isShorthandIn(catalog.find(kinds::models, material.model.id), id)) {
        return true;
    }
    return std::ranges::any_of(partKinds(BlockOwner::Material), [&](std::string_view kind) {
        const BlockValues* part = material.part(kind);
        const bool named = id.starts_with(std::string(kind) + '.');
        return part != nullptr &&
               isShorthandIn(catalog.find(kind, part->id), named ? id.substr(kind.size() + 1) : id);
    });
}

/// Returns the assignments, beginning with those that set several values at once, so that one for a
/// single value wins wherever it stands.
std::vector<std::string> inOrder(std::vector<std::string> sets, Material& material,
                                 const Catalog& catalog) {
    std::stable_partition(sets.begin(), sets.end(), [&](const std::string& assignment) {
        return isShorthandSet(material, assignment.substr(0, assignment.find('=')), catalog);
    });
    return sets;
}

void useMesh(Object& object, const std::string& mesh) {
    object.mesh = mesh;
    object.part.clear();
    object.fitUnitBox = !mesh.starts_with(builtin);
    if (object.fitUnitBox) {
        object.mesh = std::filesystem::absolute(mesh).generic_string();
    }
}

/// Applies the options for the object that is shown.
Checked<void> applyOptions(Object& object, bool isPreset, const PictureOptions& options,
                           const Catalog& catalog) {
    if (auto chosen = chooseBlocks(object.material, isPreset, options, catalog); !chosen) {
        return tl::unexpected(oneError(chosen.error()));
    }
    for (const std::string& assignment : inOrder(options.sets, object.material, catalog)) {
        if (isForScene(assignment, catalog)) {
            continue;
        }
        if (const auto image = textureAssignment(object.material, assignment, catalog)) {
            if (auto applied = applyTexture(object.material, *image, catalog); !applied) {
                return tl::unexpected(oneError(applied.error()));
            }
        } else if (auto applied = assignInMaterial(object.material, assignment, catalog);
                   !applied) {
            return tl::unexpected(Errors{namingSet(applied.error(), assignment)});
        }
    }
    for (const std::string& assignment : options.textures) {
        if (auto applied = applyTexture(object.material, assignment, catalog); !applied) {
            return tl::unexpected(oneError(applied.error()));
        }
    }
    if (!options.mesh.empty()) {
        useMesh(object, options.mesh);
    }
    return {};
}

/// Sets a value of the scene. Who names a picture there agrees that it is read.
Result<void> applyToScene(SceneSetup& setup, const std::string& assignment,
                          const Catalog& catalog) {
    auto done = assignInScene(setup.scene, assignment, catalog);
    const auto cut = assignmentFrom(assignment);
    const Parameter* parameter =
        cut ? parameterIn(setup.scene, cut->id, catalog).parameter : nullptr;
    if (!done || parameter == nullptr || !infoOf(parameter->type).isFile || cut->text.empty()) {
        return done;
    }
    const std::string file = std::filesystem::absolute(cut->text).lexically_normal().string();
    if (const auto opened = OrdinaryFile::open(file, maxAssetBytes); !opened) {
        const Error& why = opened.error();
        return tl::unexpected(Error{why.file, 0, 0, why.problem, "an image"});
    }
    setup.rights.withheld.erase(file);
    return {};
}

Result<void> applyToScene(SceneSetup& setup, const PictureOptions& options,
                          const Catalog& catalog) {
    Result<void> done = chooseSceneBlocks(setup.scene, options, catalog);
    for (const std::string& assignment : options.sets) {
        if (done && isForScene(assignment, catalog)) {
            done = applyToScene(setup, assignment, catalog).map_error([&](const Error& error) {
                return namingSet(error, assignment);
            });
        }
    }
    return done;
}

/// Fails where a measured surface in the scene cannot be read; its grey would be another material.
Checked<void> readMeasured(const SceneSetup& setup, const Catalog& catalog) {
    for (const Object& object : setup.scene.objects) {
        if (const auto read = readMeasuredOf(object.material, catalog); !read) {
            Errors errors = setup.notes; // they say where a file is named that was withheld
            errors.push_back(read.error());
            return tl::unexpected(errors);
        }
    }
    return {};
}

void noteEmptiness(SceneSetup& setup, const PictureOptions& options) {
    const std::vector<Object>& objects = setup.scene.objects;
    if (std::none_of(objects.begin(), objects.end(), [](const Object& o) { return o.visible; })) {
        setup.notes.push_back({options.scene, 0, 0, "the scene shows no object", {}});
    }
}

} // namespace

Checked<SceneSetup> sceneFor(const std::string& preset, const PictureOptions& options,
                             const Catalog& catalog) {
    auto setup = startScene(preset, options, catalog);
    if (!setup) {
        return setup;
    }
    if (!preset.empty()) {
        if (auto used = usePreset(*setup, preset, rightsFor(options), catalog); !used) {
            return tl::unexpected(used.error());
        }
    }
    if (!setup->scene.objects.empty()) {
        Object& object = setup->scene.objects.front();
        const bool isKnown = catalog.find(kinds::models, object.material.model.id) != nullptr;
        if (!isKnown && options.model.empty()) {
            return tl::unexpected(setup->notes); // the notes say where in the file it is named
        }
        if (auto applied = applyOptions(object, !preset.empty(), options, catalog); !applied) {
            return tl::unexpected(applied.error());
        }
    }
    if (auto applied = applyToScene(*setup, options, catalog); !applied) {
        return tl::unexpected(oneError(applied.error()));
    }
    if (auto read = readMeasured(*setup, catalog); !read) {
        return tl::unexpected(read.error());
    }
    if (options.exposure) {
        setup->scene.exposure = *options.exposure;
    }
    for (const std::string& named :
         {options.mesh, options.part(kinds::environment)}) { // named by the user directly
        std::error_code isEmpty;
        setup->rights.withheld.erase(std::filesystem::absolute(named, isEmpty).generic_string());
    }
    noteEmptiness(*setup, options);
    return setup;
}

} // namespace patina
