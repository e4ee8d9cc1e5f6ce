// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/scene_setup.h"

#include <algorithm>

#include <fmt/format.h>

#include "catalog/fills.h"
#include "cli/accuracy_text.h"
#include "cli/environment_setup.h"
#include "cli/picture_levels.h"
#include "cli/scene_block.h"
#include "cli/texture_text.h"
#include "cli/transparency_setup.h"
#include "cli/typed_value.h"
#include "core/number_text.h"
#include "material/model_swap.h"
#include "material/preset_file.h"
#include "scene/scene_file.h"

namespace patina {
namespace {

constexpr std::string_view builtin = "builtin:";

/// Whether an option speaks of the object that is shown.
bool needsObject(const std::string& preset, const PictureOptions& options) {
    return !preset.empty() || !options.model.empty() || !options.mesh.empty() ||
           !options.sets.empty() || !options.parts.empty() || !options.textures.empty();
}

/// Notes what a file named that is not read, and how it would be.
void withhold(SceneSetup& setup, const OutsideFiles& outside, const std::string& by) {
    for (const OutsideFile& each : outside) {
        if (each.kind == OutsideFile::Kind::Mesh || each.kind == OutsideFile::Kind::Picture) {
            setup.withheld.insert(each.file);
        }
    }
    if (!outside.empty()) {
        setup.notes.push_back({by, 0, 0, "names files outside its folder, which are not read",
                               "--allow-outside, where you trust it"});
    }
}

ReadingRights rightsFor(const PictureOptions& options) {
    ReadingRights rights;
    rights.everything = options.allowsOutside;
    return rights;
}

/// The scene; where it is empty and options speak of an object, with that of the default scene.
Checked<SceneSetup> startScene(const std::string& preset, const PictureOptions& options,
                               const Catalog& catalog) {
    const auto file =
        options.scene.empty() ? defaultSceneFile() : std::filesystem::path(options.scene);
    const auto reading = readScene(file, catalog, rightsFor(options));
    if (!reading) {
        return tl::unexpected(reading.error());
    }
    SceneSetup setup{reading->scene, reading->notes, {}};
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

Result<const Block*> knownBlock(const Catalog& catalog, const std::string& kind,
                                const std::string& id) {
    if (const Block* block = catalog.find(kind, id)) {
        return block;
    }
    std::string known;
    for (const Block* block : catalog.ofKind(kind)) {
        known += (known.empty() ? "one of " : ", ") + block->id;
    }
    return failure(fmt::format("{}: no block \"{}\" is known", kind, id), known);
}

/// Another block of a kind beside the model; values that both have carry over.
Result<bool> choosePart(Material& material, const std::string& kind, const std::string& id,
                        const Catalog& catalog) {
    const auto block = knownBlock(catalog, kind, id);
    if (!block) {
        return tl::unexpected(block.error());
    }
    const Block* model = catalog.find(kinds::models, material.model.id);
    if (model != nullptr && !hasPlaceFor(*model, kind)) {
        return failure(
            fmt::format("{} {}: the model \"{}\" has no place for it", kind, id, material.model.id),
            fmt::format("a model with a {} slot", kind));
    }
    const BlockValues* held = material.part(kind);
    const Block* before = held == nullptr ? nullptr : catalog.find(kind, held->id);
    material = withPart(material, kind, before, *block);
    return true;
}

/// Another model than a preset's is swapped as in the editor; without a preset it starts afresh.
Result<void> chooseBlocks(Material& material, bool isPreset, const PictureOptions& options,
                          const Catalog& catalog) {
    if (!options.model.empty()) {
        const auto model = knownBlock(catalog, std::string(kinds::models), options.model);
        if (!model) {
            return tl::unexpected(model.error());
        }
        material = isPreset ? swappedModel(material, **model, catalog) : defaultMaterial(**model);
    }
    for (const auto& [kind, id] : options.parts) {
        if (auto chosen = choosePart(material, kind, id, catalog); !chosen) {
            return tl::unexpected(chosen.error());
        }
    }
    return {};
}

/// Sets a parameter of a block; false when the block has none of this id.
Result<bool> setIn(const Block* block, BlockValues* values, const std::string& id,
                   const std::string& text) {
    const Parameter* parameter = block == nullptr ? nullptr : block->parameter(id);
    if (parameter == nullptr) {
        return false;
    }
    const auto value = valueFromText(*parameter, text);
    if (!value) {
        return tl::unexpected(value.error());
    }
    for (const auto& [changed, held] : afterEdit(*block, values->parameters, *parameter, *value)) {
        values->parameters.insert_or_assign(changed, held);
    }
    return true;
}

Result<bool> setOpacity(Material& material, const std::string& text) {
    const auto number = parseNumber(text);
    if (!number || *number < 0.0 || *number > 1.0) {
        return failure(fmt::format("opacity: \"{}\" is not a value for it", text),
                       "a number, 0 .. 1");
    }
    material.opacity = *number;
    return true;
}

/// "<kind>" chooses a part, "<kind>.<id>" or the id alone sets one of its parameters.
Result<bool> setInParts(Material& material, const std::string& id, const std::string& text,
                        const Catalog& catalog) {
    for (const std::string_view kind : partKinds(BlockOwner::Material)) {
        if (id == kind) {
            return choosePart(material, id, text, catalog);
        }
        BlockValues* part = material.part(kind);
        const Block* block = part == nullptr ? nullptr : catalog.find(kind, part->id);
        const bool named = id.starts_with(std::string(kind) + '.');
        Result<bool> done =
            named ? setIn(block, part, id.substr(kind.size() + 1), text) : Result<bool>(false);
        if (done && !*done) {
            done = setIn(block, part, id, text);
        }
        if (!done || *done) {
            return done;
        }
    }
    return false;
}

Result<void> applySet(Material& material, const std::string& assignment, const Catalog& catalog) {
    const std::size_t equals = assignment.find('=');
    const std::string id = assignment.substr(0, equals);
    if (equals == std::string::npos || id.empty()) {
        return failure(fmt::format("--set {}: this sets nothing", assignment), "id=value");
    }
    const std::string text = assignment.substr(equals + 1);
    const Block* model = catalog.find(kinds::models, material.model.id);
    Result<bool> done =
        id == "opacity" ? setOpacity(material, text) : setIn(model, &material.model, id, text);
    if (done && !*done) {
        done = setLevel(material, id, text, catalog);
    }
    if (done && !*done) {
        done = setInParts(material, id, text, catalog);
    }
    if (!done) {
        return tl::unexpected(done.error());
    }
    if (!*done) {
        return failure(
            fmt::format("{}: the model \"{}\" has no such parameter", id, material.model.id),
            "an id that `patina models` lists");
    }
    return {};
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

/// The assignments, those first that set several values at once: one given for a single value
/// wins wherever it stands.
std::vector<std::string> inOrder(std::vector<std::string> sets, Material& material,
                                 const Catalog& catalog) {
    std::stable_partition(sets.begin(), sets.end(), [&](const std::string& assignment) {
        return isShorthandSet(material, assignment.substr(0, assignment.find('=')), catalog);
    });
    return sets;
}

void useMesh(Object& object, const std::string& mesh) {
    object.mesh = mesh;
    object.fitUnitBox = !mesh.starts_with(builtin);
    if (object.fitUnitBox) {
        object.mesh = std::filesystem::absolute(mesh).generic_string();
    }
}

/// What the options say of the object that is shown.
Checked<void> applyOptions(Object& object, bool isPreset, const PictureOptions& options,
                           const Catalog& catalog) {
    if (auto chosen = chooseBlocks(object.material, isPreset, options, catalog); !chosen) {
        return tl::unexpected(oneError(chosen.error()));
    }
    for (const std::string& assignment : inOrder(options.sets, object.material, catalog)) {
        if (isForScene(assignment)) {
            continue;
        }
        if (auto applied = applySet(object.material, assignment, catalog); !applied) {
            return tl::unexpected(oneError(applied.error()));
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
            return tl::unexpected(setup->notes); // they say where in the file it is named
        }
        if (auto applied = applyOptions(object, !preset.empty(), options, catalog); !applied) {
            return tl::unexpected(applied.error());
        }
    }
    if (auto chosen = chooseEnvironment(setup->scene, options, catalog); !chosen) {
        return tl::unexpected(oneError(chosen.error()));
    }
    if (auto chosen = chooseTransparency(setup->scene, options, catalog); !chosen) {
        return tl::unexpected(oneError(chosen.error()));
    }
    if (auto chosen = choosePictureAccuracy(setup->scene, options.sets); !chosen) {
        return tl::unexpected(oneError(chosen.error()));
    }
    if (options.exposure) {
        setup->scene.exposure = *options.exposure;
    }
    for (const std::string& named : {options.mesh, options.environment}) { // by the user himself
        std::error_code isEmpty;
        setup->withheld.erase(std::filesystem::absolute(named, isEmpty).generic_string());
    }
    noteEmptiness(*setup, options);
    return setup;
}

} // namespace patina
