// SPDX-License-Identifier: GPL-3.0-or-later
#include "material/material_assignment.h"

#include <fmt/format.h>

#include "catalog/settings.h"
#include "catalog/suggestion.h"
#include "catalog/typed_value.h"
#include "material/accuracy_text.h"
#include "material/blocks_in_use.h"
#include "material/material_settings.h"
#include "material/model_swap.h"

namespace patina {
namespace {

/// Sets what every material has, by its id alone or after "material."; false where it is none.
Result<bool> setOwn(Material& material, const Assignment& assignment) {
    const std::string named = assignment.inside(settings::material);
    const std::string& id = named.empty() ? assignment.id : named;
    const Parameter* parameter = settingsBlock(settings::material)->parameter(id);
    if (parameter == nullptr) {
        return false;
    }
    return valueFromText(*parameter, assignment.text).map([&](const Value& value) {
        storeSetting(material, id, value);
        return true;
    });
}

Result<bool> setIn(const Block* block, BlockValues* values, const std::string& id,
                   const std::string& text) {
    return block == nullptr ? Result<bool>(false)
                            : assignIn(*block, values->parameters, {id, text});
}

/// Chooses a part by "<kind>", or sets one of its parameters by "<kind>.<id>" or the id alone.
/// Returns false where no part has the id.
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

/// Returns all ids that may be set in a material, for an error message.
std::vector<std::string> knownIds(const Material& material, const Catalog& catalog) {
    std::vector<std::string> ids = parameterIds(*settingsBlock(settings::material));
    for (const Block* block : blocksInUse(material, catalog)) {
        const bool isModel = block->kind == kinds::models;
        const auto more = parameterIds(*block, isModel ? std::string() : block->kind + '.');
        ids.insert(ids.end(), more.begin(), more.end());
        for (const AccuracyChoice& choice : block->accuracy) {
            ids.push_back(choice.id);
        }
    }
    return ids;
}

/// Says why "<kind>.<id>" sets nothing: the part is not there, or has no such parameter.
tl::unexpected<Error> failureInPart(const Material& material, const BlockKind& kind,
                                    const std::string& id, const Catalog& catalog) {
    const BlockValues* part = material.part(kind.folder);
    const Block* block = part == nullptr ? nullptr : catalog.find(kind.folder, part->id);
    return block == nullptr
               ? failure(fmt::format("the material has no {}", kind.singular),
                         fmt::format("--{}", kind.singular))
               : failure(
                     fmt::format("the {} \"{}\" has no such parameter", kind.singular, block->id),
                     oneOf(id, parameterIds(*block, std::string(kind.folder) + '.')));
}

} // namespace

Result<bool> choosePart(Material& material, const std::string& kind, const std::string& id,
                        const Catalog& catalog) {
    const bool isNone = id == findKind(kind)->noneWord;
    const auto block = isNone ? Result<const Block*>(nullptr) : knownBlock(catalog, kind, id);
    if (!block) {
        return tl::unexpected(block.error());
    }
    const Block* model = catalog.find(kinds::models, material.model.id);
    if (!isNone && model != nullptr && !hasPlaceFor(*model, kind)) {
        return failure(
            fmt::format("{} {}: the model \"{}\" has no place for it", kind, id, material.model.id),
            fmt::format("a model with a {} slot", kind));
    }
    const BlockValues* held = material.part(kind);
    const Block* before = held == nullptr ? nullptr : catalog.find(kind, held->id);
    material = withPart(material, kind, before, *block);
    return true;
}

Result<void> assignInMaterial(Material& material, const std::string& text, const Catalog& catalog) {
    const auto assignment = assignmentFrom(text);
    if (!assignment) {
        return tl::unexpected(assignment.error());
    }
    const std::string& id = assignment->id;
    const Block* model = catalog.find(kinds::models, material.model.id);
    Result<bool> done = setIn(model, &material.model, id, assignment->text);
    if (done && !*done) {
        done = setOwn(material, *assignment);
    }
    if (done && !*done) {
        done = setLevel(material, id, assignment->text, catalog);
    }
    if (done && !*done) {
        done = setInParts(material, id, assignment->text, catalog);
    }
    if (!done) {
        return tl::unexpected(done.error());
    }
    if (*done) {
        return {};
    }
    if (const BlockKind* kind = kindCalled(id)) {
        return failure(fmt::format("a {} is chosen by an option of its own", kind->singular),
                       fmt::format("--{} {}", kind->singular, assignment->text));
    }
    if (const BlockKind* kind = kindCalled(id.substr(0, id.find('.')));
        kind != nullptr && kind->owner == BlockOwner::Material && kind->folder != kinds::models) {
        return failureInPart(material, *kind, id, catalog);
    }
    return failure(fmt::format("the model \"{}\" has no such parameter", material.model.id),
                   oneOf(id, knownIds(material, catalog)) + "; `patina models` lists all");
}

const Parameter* parameterIn(const Material& material, std::string_view id,
                             const Catalog& catalog) {
    const Block* model = catalog.find(kinds::models, material.model.id);
    if (const Parameter* own = model == nullptr ? nullptr : model->parameter(id)) {
        return own;
    }
    const Assignment named{std::string(id), {}};
    const std::string inside = named.inside(settings::material);
    if (const Parameter* setting =
            settingsBlock(settings::material)->parameter(inside.empty() ? named.id : inside)) {
        return setting;
    }
    for (const std::string_view kind : partKinds(BlockOwner::Material)) {
        const Block* block = blockOf(material.parts, kind, catalog);
        const std::string ofKind = named.inside(kind);
        const Parameter* found =
            block == nullptr || ofKind.empty() ? nullptr : block->parameter(ofKind);
        found = block == nullptr || found != nullptr ? found : block->parameter(id);
        if (found != nullptr) {
            return found;
        }
    }
    return nullptr;
}

} // namespace patina
