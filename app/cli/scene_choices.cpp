// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/scene_choices.h"

#include <fmt/format.h>

#include "cli/block_assignment.h"
#include "cli/environment_setup.h"
#include "cli/scene_assignment.h"
#include "material/block_values.h"

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

/// "NAME=ID" names one light, "ID" all of them.
struct LightChoice {
    std::string name;
    const Block* block = nullptr; ///< null: none
};

Result<LightChoice> lightChoice(const BlockKind& kind, const std::string& text,
                                const Catalog& catalog) {
    const std::size_t equals = text.find('=');
    const bool isNamed = equals != std::string::npos;
    const std::string id = isNamed ? text.substr(equals + 1) : text;
    LightChoice choice{isNamed ? text.substr(0, equals) : std::string(), nullptr};
    if (id == kind.noneWord) {
        return choice;
    }
    return knownBlock(catalog, kind.folder, id).map([&choice](const Block* block) {
        choice.block = block;
        return choice;
    });
}

/// Values that both kinds of light have carry over.
void giveKind(Light& light, const Block& block, const Catalog& catalog) {
    nlohmann::json left;
    light.block =
        carriedOver(light.block, catalog.find(kinds::lights, light.block.id), block, left);
}

/// The light of the name gets another kind, goes or comes; without a name all are replaced.
void chooseLight(Scene& scene, const LightChoice& choice, bool isFirst, const Catalog& catalog) {
    Light* named = choice.name.empty() ? nullptr : lightNamed(scene, choice.name);
    if (named != nullptr && choice.block != nullptr) {
        giveKind(*named, *choice.block, catalog);
        return;
    }
    if (named != nullptr) {
        scene.lights.erase(scene.lights.begin() + (named - scene.lights.data()));
        return;
    }
    if (choice.name.empty() && isFirst) {
        scene.lights.clear();
    }
    if (choice.block != nullptr) {
        const std::string& name = choice.name.empty() ? choice.block->label : choice.name;
        scene.lights.push_back({name, true, defaultBlockValues(*choice.block)});
    }
}

bool mayCast(const Light& light, const Catalog& catalog) {
    const Block* block = catalog.find(kinds::lights, light.block.id);
    return block != nullptr && block->shadowProjection != ShadowProjection::None;
}

void chooseShadow(Scene& scene, const LightChoice& choice, const Catalog& catalog) {
    const Light* named = lightNamed(scene, choice.name);
    for (Light& light : scene.lights) {
        const bool isMeant = choice.name.empty() || &light == named;
        if (isMeant && choice.block == nullptr) {
            light.shadow.reset();
        } else if (isMeant && mayCast(light, catalog)) {
            light.shadow = defaultBlockValues(*choice.block);
        }
    }
}

Result<void> chooseInLights(Scene& scene, const BlockKind& kind,
                            const std::vector<std::string>& texts, const Catalog& catalog) {
    bool isFirst = true;
    for (const std::string& text : texts) {
        const auto choice = lightChoice(kind, text, catalog);
        if (!choice) {
            return tl::unexpected(choice.error());
        }
        if (kind.folder == kinds::lights) {
            chooseLight(scene, *choice, isFirst, catalog);
        } else {
            chooseShadow(scene, *choice, catalog);
        }
        isFirst = false;
    }
    return {};
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
            done = kind.folder == kinds::environment ? chooseEnvironment(scene, id, catalog)
                                                     : choosePart(scene, kind.folder, id, catalog);
        }
        if (!done) {
            return done;
        }
    }
    return {};
}

} // namespace patina
