// SPDX-License-Identifier: GPL-3.0-or-later
#include "shading/effects/light_effects.h"

#include <algorithm>
#include <tuple>

#include <fmt/format.h>

#include "shading/effects/block_use.h"
#include "shading/effects/effect_choice.h"
#include "shading/effects/effect_key.h"
#include "shading/effects/light_lines.h"
#include "shading/effects/light_reach.h"
#include "shading/effects/neutral_values.h"

namespace patina {
namespace {

void addGroup(SceneEffects& effects, LightGroup made) {
    const auto group =
        std::find_if(effects.lights.begin(), effects.lights.end(),
                     [&made](const LightGroup& known) { return known.key == made.key; });
    if (group == effects.lights.end()) {
        effects.lights.push_back(std::move(made));
        return;
    }
    ++group->count;
    group->names.push_back(std::move(made.names.front()));
}

bool before(const BlockUse& a, const BlockUse& b) {
    const auto key = [](const CompiledValue& value) { return std::tie(value.id, value.value); };
    if (a.id != b.id) {
        return a.id < b.id;
    }
    return std::lexicographical_compare(
        a.compiled.begin(), a.compiled.end(), b.compiled.begin(), b.compiled.end(),
        [&key](const CompiledValue& x, const CompiledValue& y) { return key(x) < key(y); });
}

bool groupBefore(const LightGroup& a, const LightGroup& b) {
    if (before(a.block, b.block) || before(b.block, a.block)) {
        return before(a.block, b.block);
    }
    return b.shadow && (!a.shadow || before(*a.shadow, *b.shadow));
}

/// Why a light is not in the program; empty when it is.
std::string whyNoLight(const Light& light, const Block* block) {
    if (!light.enabled) {
        return "It is switched off.";
    }
    if (block == nullptr) {
        return fmt::format("No light \"{}\" is known.", light.block.id);
    }
    return whyNeutral(*block, light.block.parameters);
}

/// "1 is hidden, 2 cast none and 1 is transparent": what keeps the objects from casting shadows.
std::string nonCastersText(const Scene& scene) {
    std::size_t hidden = 0;
    std::size_t exempt = 0;
    for (const Object& object : scene.objects) {
        hidden += object.visible ? 0 : 1;
        exempt += object.visible && !object.castsShadow ? 1 : 0;
    }
    const std::size_t clear = scene.objects.size() - hidden - exempt;
    std::vector<std::string> parts;
    const auto add = [&parts](std::size_t count, const char* one, const char* more) {
        if (count > 0) {
            parts.push_back(fmt::format("{} {}", count, count == 1 ? one : more));
        }
    };
    add(hidden, "is hidden", "are hidden");
    add(exempt, "is set to cast none", "are set to cast none");
    add(clear, "is more than half transparent", "are more than half transparent");
    return fmt::format("{}", fmt::join(parts, ", "));
}

/// Why shadows cannot be seen, whatever the light is; empty when they can.
std::string whyNoShadows(const Scene& scene, const Catalog& catalog) {
    if (!hasCaster(scene, catalog)) {
        return scene.objects.empty()
                   ? std::string("No object casts a shadow: there are none.")
                   : fmt::format("No object casts a shadow: {}.", nonCastersText(scene));
    }
    if (!hasReceiver(scene, catalog)) {
        return "No shadow falls on anything: there is no ground, and no object has a known model.";
    }
    if (isLoneFlat(scene, catalog)) {
        return "No shadow falls on anything: the only object is flat, and there is no ground.";
    }
    return {};
}

/// Why a light's shadows are not drawn; empty when they are, or none are asked for.
std::string whyNoShadow(const Light& light, const Block& block, const Catalog& catalog,
                        const std::string& whyNone) {
    if (!light.shadow) {
        return {};
    }
    if (block.shadowProjection == ShadowProjection::None) {
        return "Lights of this kind cast none.";
    }
    if (catalog.find(kinds::shadows, light.shadow->id) == nullptr) {
        return fmt::format("No kind of shadow \"{}\" is known.", light.shadow->id);
    }
    return whyNone;
}

LightGroup groupOf(const Block& block, const Light& light, const Catalog& catalog, bool shadowed) {
    LightGroup group;
    group.block = useOf(block, light.block.parameters, {}, {});
    group.count = 1;
    group.key = EffectKey::ofLight(light, catalog, shadowed);
    const Block* shadow = shadowed ? shadowBlock(light, block, catalog) : nullptr;
    if (shadow != nullptr) {
        group.shadow = useOf(*shadow, light.shadow->parameters, {}, {});
        group.projection = block.shadowProjection;
    }
    return group;
}

std::string casterText(const Scene& scene, const Catalog& catalog) {
    const auto casters = std::ranges::count_if(
        scene.objects, [&catalog](const Object& object) { return isCaster(object, catalog); });
    return casters == 1 ? "One object casts a shadow."
                        : fmt::format("{} objects cast shadows.", casters);
}

} // namespace

std::string lightName(const Scene& scene, std::size_t index) {
    const Light& light = scene.lights[index];
    return light.name.empty() ? fmt::format("light {}", index + 1) : light.name;
}

void addLights(SceneEffects& effects, const Scene& scene, const Catalog& catalog,
               const EffectView& view) {
    const std::string whyNone = whyNoShadows(scene, catalog);
    LightLines lines;
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
        const Light& light = scene.lights[i];
        const Block* block = catalog.find(kinds::lights, light.block.id);
        if (std::string reason = whyNoLight(light, block); !reason.empty()) {
            effects.leftOut.push_back({lightName(scene, i), std::move(reason)});
            continue;
        }
        LightGroup group = groupOf(*block, light, catalog, whyNone.empty());
        group.names.push_back(lightName(scene, i));
        lines.add(group.key, reachOf(light, *block).isEverywhere(), view.reaches(i));
        if (!view.reaches(i)) {
            continue;
        }
        addGroup(effects, std::move(group));
        if (std::string why = whyNoShadow(light, *block, catalog, whyNone); !why.empty()) {
            effects.leftOut.push_back({"shadows of " + lightName(scene, i), std::move(why)});
        }
    }
    std::sort(effects.lights.begin(), effects.lights.end(), groupBefore);
    for (LightGroup& group : effects.lights) {
        group.lines = lines.of(group.key);
        if (group.shadow) {
            group.shadow->reason = casterText(scene, catalog);
        }
    }
}

void addGround(EffectSet& set, const Scene& scene) {
    const Ground& ground = scene.ground;
    const bool shadowed = std::any_of(set.scene.lights.begin(), set.scene.lights.end(),
                                      [](const LightGroup& group) { return bool(group.shadow); });
    if (ground.mode == GroundMode::Off) {
        set.leftOut.push_back({"ground", "The scene has no ground."});
    } else if (!isSeen(ground)) {
        set.leftOut.push_back({"ground", "Its opacity is 0."});
    } else if (ground.mode == GroundMode::Shadows && !shadowed) {
        set.leftOut.push_back({"ground", "It shows shadows only, and no light has any."});
    } else {
        set.ground = ground.mode;
        set.reasons["ground"] =
            fmt::format("{}, opacity {:.3g}.",
                        ground.mode == GroundMode::Plane ? "A matt plane that the lights shine on"
                                                         : "It shows the shadows that fall on it",
                        ground.opacity);
    }
}

} // namespace patina
