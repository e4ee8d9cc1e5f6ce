// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/scene_choices.h"

#include <algorithm>
#include <sstream>
#include <utility>

#include <fmt/format.h>

#include "material/block_assignment.h"
#include "material/block_values.h"
#include "scene/environment_choice.h"
#include "scene/scene_assignment.h"

namespace patina {
namespace {

Result<void> choosePart(Scene& scene, std::string_view kind, const std::string& id,
                        const Catalog& catalog) {
    if (id == findKind(kind)->noneWord) {
        scene.setPart(kind, std::nullopt);
        return {};
    }
    const BlockValues* held = scene.part(kind);
    return knownBlock(catalog, kind, id).map([&](const Block* block) {
        if (held == nullptr || held->id != id) {
            scene.setPart(kind, defaultBlockValues(*block));
        }
    });
}

/// Gives the scene the passes of "a,b", in this order; those that it has keep their values.
Result<void> choosePasses(Scene& scene, const BlockKind& kind, const std::string& ids,
                          const Catalog& catalog) {
    std::vector<BlockValues> before = std::exchange(scene.passes, {});
    std::istringstream words(ids);
    for (std::string id; std::getline(words, id, ',');) {
        if (id == kind.noneWord) {
            continue;
        }
        const auto block = knownBlock(catalog, kind.folder, id);
        if (!block) {
            return tl::unexpected(block.error());
        }
        const auto held = std::ranges::find(before, id, &BlockValues::id);
        const bool isHeld = held != before.end();
        scene.passes.push_back(isHeld ? *held : defaultBlockValues(**block));
        if (isHeld) {
            before.erase(held);
        }
    }
    return {};
}

/// Holds a choice for lights: "NAME=ID" names one light, "ID" means all of them.
struct LightChoice {
    std::string text; ///< as it was typed
    std::string name;
    const Block* block = nullptr; ///< is null where "none" is chosen
};

Result<LightChoice> lightChoice(const BlockKind& kind, const std::string& text,
                                const Catalog& catalog) {
    const std::size_t equals = text.find('=');
    const bool isNamed = equals != std::string::npos;
    const std::string id = isNamed ? text.substr(equals + 1) : text;
    LightChoice choice{text, text.substr(0, isNamed ? equals : 0)};
    if (isNamed && choice.name.empty()) {
        return failure(fmt::format("--{} {}: there is no name before the =", kind.singular, text),
                       fmt::format("the name of a light, or {} for all of them", id));
    }
    if (id == kind.noneWord) {
        return choice;
    }
    return knownBlock(catalog, kind.folder, id).map([&choice](const Block* block) {
        choice.block = block;
        return choice;
    });
}

/// Changes the kind of a light; values that both kinds have are kept.
void giveKind(Light& light, const Block& block, const Catalog& catalog) {
    nlohmann::json left;
    light.block =
        carriedOver(light.block, catalog.find(kinds::lights, light.block.id), block, left);
}

tl::unexpected<Error> noSuchLight(const Scene& scene, const BlockKind& kind,
                                  const LightChoice& choice) {
    return failure(
        fmt::format("--{} {}: there is no light \"{}\"", kind.singular, choice.text, choice.name),
        expectedLights(scene, choice.name));
}

/// Changes the kind of the named light, removes it or adds it; without a name it adds a light, or
/// removes all.
Result<void> chooseLight(Scene& scene, const BlockKind& kind, const LightChoice& choice,
                         const Catalog& catalog) {
    Light* named = choice.name.empty() ? nullptr : lightNamed(scene, choice.name);
    if (choice.block == nullptr && choice.name.empty()) {
        scene.lights.clear();
    } else if (choice.block == nullptr && named == nullptr) {
        return noSuchLight(scene, kind, choice);
    } else if (choice.block == nullptr) {
        scene.lights.erase(scene.lights.begin() + (named - scene.lights.data()));
    } else if (named != nullptr) {
        giveKind(*named, *choice.block, catalog);
    } else {
        const std::string& name = choice.name.empty() ? choice.block->label : choice.name;
        scene.lights.push_back({name, true, defaultBlockValues(*choice.block)});
    }
    return {};
}

bool mayHave(const Light& light, const BlockKind& kind, const Catalog& catalog) {
    if (kind.folder != kinds::shadows) {
        return true;
    }
    const Block* block = catalog.find(kinds::lights, light.block.id);
    return block != nullptr && block->shadowProjection != ShadowProjection::None;
}

/// Chooses a part of the named light, or of all; shadows are for those alone that may cast them.
Result<void> chooseLightPart(Scene& scene, const BlockKind& kind, const LightChoice& choice,
                             const Catalog& catalog) {
    const Light* named = lightNamed(scene, choice.name);
    if (named == nullptr && !choice.name.empty()) {
        return noSuchLight(scene, kind, choice);
    }
    for (Light& light : scene.lights) {
        const bool isMeant = choice.name.empty() || &light == named;
        if (isMeant && choice.block == nullptr) {
            light.setPart(kind.folder, std::nullopt);
        } else if (isMeant && mayHave(light, kind, catalog)) {
            light.setPart(kind.folder, defaultBlockValues(*choice.block));
        }
    }
    return {};
}

/// Applies the choices for lights or for parts of theirs. Lights without a name replace those of
/// the scene.
Result<void> chooseInLights(Scene& scene, const BlockKind& kind,
                            const std::vector<std::string>& texts, const Catalog& catalog) {
    std::vector<LightChoice> choices;
    for (const std::string& text : texts) {
        const auto choice = lightChoice(kind, text, catalog);
        if (!choice) {
            return tl::unexpected(choice.error());
        }
        choices.push_back(*choice);
    }
    const bool isOfLights = kind.folder == kinds::lights;
    if (isOfLights && std::ranges::any_of(
                          choices, [](const LightChoice& choice) { return choice.name.empty(); })) {
        scene.lights.clear();
    }
    Result<void> done;
    for (const LightChoice& choice : choices) {
        if (done) {
            done = isOfLights ? chooseLight(scene, kind, choice, catalog)
                              : chooseLightPart(scene, kind, choice, catalog);
        }
    }
    return done;
}

} // namespace

Result<void> chooseSceneBlocks(Scene& scene, const PictureOptions& options,
                               const Catalog& catalog) {
    for (const BlockKind& kind : blockKinds()) {
        Result<void> done;
        if (const auto texts = options.ofLights.find(kind.folder);
            texts != options.ofLights.end()) {
            done = chooseInLights(scene, kind, texts->second, catalog);
        }
        const std::string& id = options.part(kind.folder);
        if (kind.owner == BlockOwner::Scene && !id.empty()) {
            done = kind.isInRow ? choosePasses(scene, kind, id, catalog)
                   : kind.folder == kinds::environment
                       ? chooseEnvironment(scene, id, catalog)
                       : choosePart(scene, kind.folder, id, catalog);
        }
        if (!done) {
            return done;
        }
    }
    return {};
}

} // namespace patina
