// SPDX-License-Identifier: GPL-3.0-or-later
#include "shading/effects/shadows.h"

#include <algorithm>
#include <map>

#include <fmt/format.h>

#include "shading/effects/data_layout.h"
#include "shading/effects/effect_set.h"
#include "shading/effects/surface_text.h"

namespace patina {
namespace {

/// Names the mesh whose parts all lie in one plane.
constexpr std::string_view flatMesh = "builtin:plane";

/// What hides at least so much casts shadows.
constexpr double minShadowing = 0.5;

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

/// Returns why shadows cannot be seen, whatever the light is; empty when they can.
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

/// Returns why a light's shadows are not drawn; empty when they are, or none are asked for.
std::string whyNoShadow(const Light& light, const Block& block, const Catalog& catalog,
                        const std::string& whyNone) {
    const BlockValues* shadow = light.part(kinds::shadows);
    if (shadow == nullptr) {
        return {};
    }
    if (block.shadowProjection == ShadowProjection::None) {
        return "Lights of this kind cast none.";
    }
    if (catalog.find(kinds::shadows, shadow->id) == nullptr) {
        return fmt::format("No kind of shadow \"{}\" is known.", shadow->id);
    }
    return whyNone;
}

std::string casterText(const EffectSubject& subject) {
    const auto casters =
        std::ranges::count_if(subject.scene.objects, [&subject](const Object& object) {
            return isCaster(object, subject.catalog);
        });
    return casters == 1 ? "One object casts a shadow."
                        : fmt::format("{} objects cast shadows.", casters);
}

/// Returns "parallel" or "local": the file, and the functions in it.
const char* mapOf(const LightGroup& group) {
    return group.projection() == ShadowProjection::Parallel ? "parallel" : "local";
}

/// Returns how a point of a light with a map of one kind or the other calls it.
std::string dispatch(bool parallel, bool local, const std::string& name,
                     const std::string& arguments) {
    const std::string call = parallel ? "parallel" + name + arguments : "local" + name + arguments;
    return parallel && local ? fmt::format("s.isParallel ? {} : local{}{}", call, name, arguments)
                             : call;
}

/// Gives a reason for nothing to arrive.
std::string arrivalGate(const char* condition) {
    return fmt::format("    if ({}) {{\n        return 0.0;\n    }}\n", condition);
}

} // namespace

bool canShadow(const Material& material, const Catalog& catalog) {
    return material.opacity >= minShadowing && opacityOf(material, catalog) >= minShadowing;
}

bool isCaster(const Object& object, const Catalog& catalog) {
    return object.visible && object.castsShadow && canShadow(object.material, catalog);
}

bool hasCaster(const Scene& scene, const Catalog& catalog) {
    return std::ranges::any_of(
        scene.objects, [&catalog](const Object& object) { return isCaster(object, catalog); });
}

bool hasReceiver(const Scene& scene, const Catalog& catalog) {
    return isSeen(scene.ground) || std::ranges::any_of(scene.objects, [&](const Object& object) {
               return object.visible && canBeSeen(object.material) &&
                      catalog.find(kinds::models, object.material.model.id) != nullptr;
           });
}

bool isLoneFlat(const Scene& scene, const Catalog& catalog) {
    const Object* lone = nullptr;
    for (const Object& object : scene.objects) {
        if (!object.visible || !(canBeSeen(object.material) || isCaster(object, catalog))) {
            continue;
        }
        if (lone != nullptr) {
            return false;
        }
        lone = &object;
    }
    return lone != nullptr && lone->mesh == flatMesh && !isSeen(scene.ground);
}

bool hasShadows(const Scene& scene, const Catalog& catalog) {
    return hasCaster(scene, catalog) && hasReceiver(scene, catalog) && !isLoneFlat(scene, catalog);
}

bool hasShadows(const EffectSet& set) {
    return !takesKeyAlone(set) && std::ranges::any_of(set.lights, [](const LightGroup& group) {
        return group.shadow.has_value();
    });
}

const Block* shadowBlock(const Light& light, const Block& block, const Catalog& catalog) {
    return block.shadowProjection == ShadowProjection::None
               ? nullptr
               : blockOf(light.parts, kinds::shadows, catalog);
}

/// Lists one line for each kind of shadow, with the lights that have such.
void ShadowsEffect::list(EffectListing& listing, const EffectSet& set) const {
    std::map<std::string_view, std::vector<const LightGroup*>> kinds;
    for (const LightGroup& group : set.lights) {
        if (group.shadow && isLit(set) && hasShadows(set)) {
            kinds[group.shadow->block().id].push_back(&group);
        }
    }
    for (const auto& [id, groups] : kinds) {
        std::vector<const BlockUse*> uses;
        for (const LightGroup* group : groups) {
            uses.push_back(&*group->shadow);
        }
        listing.add(effectName(*uses.front()), compiledText(uses),
                    [&groups = groups](const EffectSubject& subject) {
                        const std::vector<std::string> names = lightNames(groups, subject);
                        return fmt::format("{} {} {} them.", casterText(subject), namesText(names),
                                           names.size() == 1 ? "has" : "have");
                    });
    }
}

void ShadowsEffect::listMissing(LeftOutListing& listing, const EffectSet& set) const {
    const auto& [material, scene, catalog, view] = listing.subject();
    const std::string whyNone = takesKeyAlone(set)
                                    ? "The material is a drawing, whose own tones are its shadows."
                                    : whyNoShadows(scene, catalog);
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
        const Light& light = scene.lights[i];
        const Block* block = catalog.find(kinds::lights, light.block.id);
        if (block == nullptr || !canShine(light, *block) || !view.reaches(i)) {
            continue;
        }
        if (std::string why = whyNoShadow(light, *block, catalog, whyNone); !why.empty()) {
            listing.add("shadows of " + lightName(scene, i), std::move(why));
        }
    }
}

/// Writes the kinds of map that lights have; the others are not in the text.
void writeShadowCode(SurfaceText& text) {
    bool parallel = false;
    bool local = false;
    text.out.add("#define SHADOW_DATA(i) sceneData[base + (i)]\n");
    text.out.addFile("passes/shadows.glsl");
    for (const LightGroup& group : text.set.lights) {
        if (group.shadow) {
            const bool isParallel = group.projection() == ShadowProjection::Parallel;
            (isParallel ? parallel : local) = true;
            text.out.addFile(fmt::format("passes/shadows_{}.glsl", mapOf(group)));
        }
    }
    text.out.add(
        fmt::format("ShadowRay shadowRay(ShadowPoint s, vec2 offset) {{\n    return {};\n}}\n"
                    "vec4 shadowDepths(ShadowPoint s, vec4 stored) {{\n    return {};\n}}\n",
                    dispatch(parallel, local, "ShadowRay", "(s, offset)"),
                    dispatch(parallel, local, "ShadowDepths", "(s, stored)")));
    text.out.addFile("passes/shadows_taps.glsl");
    text.main += "    shadowFace = faceNormal(s.v);\n    shadowLift = shadingNormal(s.v);\n"
                 "    shadowAside = shadowInset(s.v);\n";
}

void writeShadow(SurfaceText& text, std::size_t index) {
    const LightPlace& place = text.scene.groups[index];
    const LightGroup& group = text.set.lights[index];
    const Block& block = group.shadow->block();
    const std::string unpack = fmt::format("unpack{}{}", structName(block), index);
    text.addBlock(block);
    text.addUnpack(*group.shadow, unpack);
    std::string gates;
    if (group.block.block().reach && group.lines == 0) {
        gates += arrivalGate("!(max(max(light.radiance.r, light.radiance.g), "
                             "light.radiance.b) > 0.0)");
    }
    if (!isLitFromBehind(text)) {
        gates += arrivalGate("dot(s.n, light.l) <= 0.0");
    }
    text.out.add(fmt::format("float arriving{0}(Surface s, Illumination light, int base) {{\n"
                             "{1}"
                             "    ShadowView view = shadowViewAt(base + {2});\n"
                             "    ShadowPoint point = shadowPoint(s, light.l, view, {3});\n"
                             "    return clamp({4}(point, {5}(base + {6})), 0.0, 1.0);\n"
                             "}}\n",
                             index, gates, place.shadow->first + place.shadow->vec4s(),
                             group.projection() == ShadowProjection::Parallel, functionName(block),
                             unpack, place.shadow->first));
}

std::string_view ShadowsEffect::whyPerPixel(const EffectSet& set) const {
    return hasShadows(set) ? "shadows have edges between the corners." : std::string_view();
}

void ShadowsEffect::remove(Scene& scene, const EffectName& effect, const Catalog&) {
    for (Light& light : scene.lights) {
        const BlockValues* shadow = light.part(kinds::shadows);
        if (effect.kind == kinds::shadows && shadow != nullptr && shadow->id == effect.id) {
            light.setPart(kinds::shadows, std::nullopt);
        }
    }
}

} // namespace patina
