// SPDX-License-Identifier: GPL-3.0-or-later
// How each kind of effect is taken out of a scene.
#include <algorithm>
#include <array>
#include <string_view>

#include "shading/effects/effect_choice.h"
#include "shading/effects/effect_rows.h"

namespace patina {
namespace {

/// What is taken out: "lights/<id>" has a kind and an id, "ambient" only the first.
struct Effect {
    std::string_view kind;
    std::string_view id;
};

using Remove = void (*)(Scene&, const Effect&, const Catalog&);

/// What fills its slots goes along: without a model nobody calls it.
void removeModel(Scene& scene, const Effect& effect, const Catalog& catalog) {
    const Block* model = catalog.find(kinds::models, effect.id);
    for (Object& object : scene.objects) {
        if (object.material.model.id != effect.id) {
            continue;
        }
        object.material.model = BlockValues();
        for (const Slot& slot : model != nullptr ? model->slots : std::vector<Slot>()) {
            object.material.parts.erase(slot.kind);
        }
    }
}

void removePart(Scene& scene, const Effect& effect, const Catalog&) {
    for (Object& object : scene.objects) {
        const BlockValues* part = object.material.part(effect.kind);
        if (part != nullptr && part->id == effect.id) {
            object.material.parts.erase(object.material.parts.find(effect.kind));
        }
    }
}

void removeLights(Scene& scene, const Effect& effect, const Catalog&) {
    for (Light& light : scene.lights) {
        light.enabled = light.enabled && light.block.id != effect.id;
    }
}

void removeShadows(Scene& scene, const Effect& effect, const Catalog&) {
    for (Light& light : scene.lights) {
        if (light.shadow && light.shadow->id == effect.id) {
            light.shadow.reset();
        }
    }
}

void removeGround(Scene& scene, const Effect&, const Catalog&) {
    scene.ground.mode = GroundMode::Off;
}

void removeFog(Scene& scene, const Effect&, const Catalog&) {
    scene.setPart(kinds::fog, std::nullopt);
}

void removeAmbient(Scene& scene, const Effect&, const Catalog&) {
    scene.ambient = glm::dvec3(0.0);
}

void removeHemisphere(Scene& scene, const Effect&, const Catalog&) {
    scene.hemisphere = Hemisphere();
}

void removeEnvironment(Scene& scene, const Effect& effect, const Catalog&) {
    if (scene.part(kinds::environment) && scene.part(kinds::environment)->id == effect.id) {
        scene.setPart(kinds::environment, std::nullopt);
    }
}

void removeEmission(Scene& scene, const Effect&, const Catalog& catalog) {
    for (Object& object : scene.objects) {
        const Block* model = catalog.find(kinds::models, object.material.model.id);
        for (const Parameter& parameter : model ? model->parameters : std::vector<Parameter>()) {
            if (isEmitted(parameter, object.material.model.parameters)) {
                object.material.model.parameters[parameter.id] = glm::dvec3(0.0);
            }
            if (parameter.emission) {
                object.material.textures.erase(parameter.id);
            }
        }
    }
}

void removeTexture(Scene& scene, const Effect& effect, const Catalog&) {
    for (Object& object : scene.objects) {
        object.material.textures.erase(std::string(effect.id));
    }
}

void removeOpacity(Scene& scene, const Effect&, const Catalog& catalog) {
    for (Object& object : scene.objects) {
        object.material.opacity = 1.0;
        const Block* model = catalog.find(kinds::models, object.material.model.id);
        for (const Parameter& parameter : model ? model->parameters : std::vector<Parameter>()) {
            if (parameter.transparency) {
                object.material.model.parameters[parameter.id] = 0.0;
            }
        }
    }
}

void removeTransparency(Scene& scene, const Effect& effect, const Catalog&) {
    if (scene.part(kinds::transparency) && scene.part(kinds::transparency)->id == effect.id) {
        scene.setPart(kinds::transparency, std::nullopt);
    }
}

void removeExposure(Scene& scene, const Effect&, const Catalog&) {
    scene.exposure = 0.0;
}

void removeToneMapping(Scene& scene, const Effect&, const Catalog&) {
    scene.toneMapping = ToneMapping::None;
}

/// Every effect that has a row: by the part of its name before the slash.
constexpr std::array<std::pair<std::string_view, Remove>, 18> removals{{
    {"models", removeModel},
    {"fresnel", removePart},
    {"specular", removePart},
    {"lights", removeLights},
    {"shadows", removeShadows},
    {"ground", removeGround},
    {"ambient", removeAmbient},
    {"hemisphere", removeHemisphere},
    {"environment", removeEnvironment},
    {"emission", removeEmission},
    {"texture", removeTexture},
    {"fog", removeFog},
    {"opacity", removeOpacity},
    {"refraction", removePart},
    {"transparency", removeTransparency},
    {"outline", removePart},
    {"exposure", removeExposure},
    {"tone mapping", removeToneMapping},
}};

} // namespace

Scene withoutEffects(Scene scene, std::span<const std::string> effects, const Catalog& catalog) {
    for (const std::string_view name : effects) {
        const std::size_t slash = name.find('/');
        const Effect effect{name.substr(0, slash), slash == std::string_view::npos
                                                       ? std::string_view()
                                                       : name.substr(slash + 1)};
        const auto found =
            std::find_if(removals.begin(), removals.end(),
                         [&effect](const auto& known) { return known.first == effect.kind; });
        if (found != removals.end()) {
            found->second(scene, effect, catalog);
        }
    }
    return scene;
}

} // namespace patina
