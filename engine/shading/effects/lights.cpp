// SPDX-License-Identifier: GPL-3.0-or-later
#include "shading/effects/lights.h"

#include <algorithm>
#include <iterator>
#include <tuple>

#include <fmt/format.h>

#include "catalog/settings.h"
#include "shading/effects/data_layout.h"
#include "shading/effects/effect_set.h"
#include "shading/effects/key_light.h"
#include "shading/effects/light_colors.h"
#include "shading/effects/light_reach.h"
#include "shading/effects/neutral_values.h"
#include "shading/effects/surface_text.h"

namespace patina {
namespace {

/// Is what a light adds: {0} is its Illumination, {1} what shadows leave of it (or the number of
/// the function that says so), {2} the function that asks the model.
constexpr const char* litSource = "    sum += {2}(s, {0}, p);\n";
constexpr const char* sharedLitSource = "    Illumination light = {0};\n"
                                        "    float share = arriving{1}(s, light, base);\n"
                                        "    if (share > 0.0) {{\n"
                                        "        sum = share * litAnyway(s, light, p);\n"
                                        "    }}\n";
constexpr const char* shadowedLitSource = "    Illumination light = {0};\n"
                                          "{1}"
                                          "    sum += {2}(s, light, p);\n";
constexpr const char* inspectedLitSource = "    Illumination light = inspectedLight({0});\n"
                                           "{1}"
                                           "    sum += {2}(s, light, p);\n"
                                           "    noteLight(s, light);\n";

bool isBefore(const LightGroup& a, const LightGroup& b) {
    if (BlockUse::isBefore(a.block, b.block) || BlockUse::isBefore(b.block, a.block)) {
        return BlockUse::isBefore(a.block, b.block);
    }
    const auto extras = [](const LightGroup& group) {
        return std::tuple(group.isInColors, group.hasAmbient, group.isPolarised);
    };
    if (extras(a) != extras(b)) {
        return extras(a) < extras(b);
    }
    return b.shadow && (!a.shadow || BlockUse::isBefore(*a.shadow, *b.shadow));
}

/// Returns why a light is not in the program; empty when it is.
std::string whyNoLight(const Light& light, const Block* block) {
    if (!light.enabled) {
        return "It is switched off.";
    }
    if (block == nullptr) {
        return fmt::format("No light \"{}\" is known.", light.block.id);
    }
    return whyNeutral(*block, light.block.parameters);
}

/// Returns the names of the lights of one block, each group after the other.
std::string shiningText(const std::vector<const LightGroup*>& groups,
                        const EffectSubject& subject) {
    const std::vector<std::string> names = lightNames(groups, subject);
    return fmt::format("{} {}.", namesText(names), names.size() == 1 ? "shines" : "shine");
}

/// Returns "Key shines: it is marked as key."
std::string keyText(const EffectSubject& subject) {
    const Scene& scene = subject.scene;
    const std::optional<std::size_t> key = keyLight(scene, subject.catalog);
    if (!key) {
        return {};
    }
    return fmt::format("{} shines: it is {}.", lightName(scene, *key),
                       scene.lights[*key].isKey ? "marked as the key light"
                                                : "the brightest in the middle of the objects");
}

/// The key light stands where its group's header says, if it reaches the object. `call` has {} for
/// the place of a light's data.
void callKeyLight(SurfaceText& text, std::size_t index, const std::string& call) {
    const std::string header = fmt::format("sceneData[{}].z", text.scene.groups[index].light.first);
    text.main += fmt::format("    if ({} > 0.0) {{\n        shaded += {};\n    }}\n", header,
                             fmt::format(fmt::runtime(call), fmt::format("int({})", header)));
}

/// Writes a line for each light of a group, or the loop over them. Lines come first in `sceneData`.
void callLights(SurfaceText& text, std::size_t index, const std::string& call, int nextLine) {
    const LightPlace& group = text.scene.groups[index];
    const int lines = text.set.lights[index].lines;
    for (int i = 0; i < lines; ++i) {
        text.main += fmt::format("    shaded += {};\n", fmt::format(fmt::runtime(call), nextLine));
        nextLine += group.vec4s();
    }
    if (lines == 0) {
        const std::string place =
            fmt::format("int(sceneData[{}].y) + i * {}", group.light.first, group.vec4s());
        text.main += fmt::format("    for (int i = 0; i < int(sceneData[{}].x); ++i) {{\n"
                                 "        shaded += {};\n"
                                 "    }}\n",
                                 group.light.first, fmt::format(fmt::runtime(call), place));
    }
}

/// Returns what the function of a group does with one light.
std::string litBody(SurfaceText& text, std::size_t index) {
    const LightGroup& group = text.set.lights[index];
    const Block& block = group.block.block();
    const bool showsShadows = text.set.ground == GroundMode::Shadows;
    const bool hasEnd = block.reach && group.lines == 0;
    const bool hasShadow = group.shadow && hasShadows(text.set);
    const char* lit = hasShadow || hasEnd ? "litWhereItArrives" : "lit";
    const char* body = text.isInspected() ? inspectedLitSource : litSource;
    std::string shadowed;
    if (hasShadow) {
        writeShadow(text, index);
        body = text.isInspected() ? body : sharedLitSource;
        shadowed = text.isInspected() || showsShadows
                       ? fmt::format("    light.radiance *= arriving{}(s, light, base);\n", index)
                       : fmt::format("{}", index);
    }
    if (showsShadows) {
        body = shadowedLitSource;
        shadowed = fmt::format("    sent += {}(s, light, p);\n", lit) + shadowed;
    }
    const std::string arrives = fmt::format("{}(s.x, source)", functionName(block));
    return fmt::format(fmt::runtime(body), arrives, shadowed, lit);
}

void writeGroup(SurfaceText& text, std::size_t index, int& nextLine) {
    const BlockUse& use = text.set.lights[index].block;
    const std::string type = structName(use.block());
    text.addBlock(use.block());
    text.addUnpack(use, fmt::format("unpack{}{}", type, index));
    const LightGroup& group = text.set.lights[index];
    std::string body = litBody(text, index);
    if (group.isPolarised && answersPolarisedLight(text.set)) {
        body = fmt::format("    fieldAcross =\n"
                           "        acrossOf({}(s.x, source).l, s.v, sceneData[base + {}]);\n"
                           "{}    fieldAcross = 0.5;\n",
                           functionName(use.block()), text.scene.groups[index].colors + 3, body);
    }
    text.out.add(fmt::format("vec3 from{0}{1}(Surface s, Model p, int base) {{\n"
                             "    vec3 sum = vec3(0.0);\n"
                             "    {0} source = unpack{0}{1}(base);\n"
                             "{2}"
                             "    return sum;\n"
                             "}}\n",
                             type, index, body));
    std::string function = fmt::format("from{}{}", type, index);
    if (group.isInColors && text.set.ground != GroundMode::Shadows) {
        function = writeSeparateColors(text, function, text.scene.groups[index].colors);
    }
    const std::string call = function + "(s, model, {})";
    if (takesKeyAlone(text.set)) {
        callKeyLight(text, index, call);
        return;
    }
    callLights(text, index, call, nextLine);
    if (group.hasAmbient && text.set.ground != GroundMode::Shadows) {
        const std::string ambient =
            writeLightAmbient(text, group, index, text.scene.groups[index].colors);
        const std::string share = text.set.model ? ambientShare(text) : "1.0"; // white ground
        callLights(text, index,
                   fmt::format("{}(s, {{}}){} * {}", ambient, text.around.factor, share), nextLine);
    }
    nextLine += group.lines * text.scene.groups[index].vec4s();
}

} // namespace

std::uint64_t LightGroup::key() const {
    ChoiceHash hash;
    hash.add(block);
    hash.add(shadow);
    hash.add(isInColors);
    hash.add(hasAmbient);
    hash.add(isPolarised);
    return hash.value();
}

std::optional<LightGroup> lightGroup(const Light& light, const Catalog& catalog, bool hasShadows) {
    const Block* block = catalog.find(kinds::lights, light.block.id);
    if (block == nullptr || !canShine(light, *block)) {
        return std::nullopt;
    }
    LightGroup group{BlockUse(*block, light.block.parameters), std::nullopt};
    const LightColors colors = lightColors(*block, light.block.parameters);
    group.isInColors = colors.areSeparate();
    group.hasAmbient = colors.hasAmbient();
    group.isPolarised = lightPolarisation(*block, light.block.parameters).degree > 0.0;
    const Block* shadow = hasShadows ? shadowBlock(light, *block, catalog) : nullptr;
    if (shadow != nullptr) {
        group.shadow.emplace(*shadow, light.part(kinds::shadows)->parameters);
    }
    return group;
}

std::uint64_t lightKey(const Light& light, const Catalog& catalog, bool hasShadows) {
    const std::optional<LightGroup> group = lightGroup(light, catalog, hasShadows);
    return group ? group->key() : 0;
}

bool canShine(const Light& light, const Block& block) {
    return light.enabled && !isNeutral(block, light.block.parameters);
}

std::string lightName(const Scene& scene, std::size_t index) {
    const Light& light = scene.lights[index];
    return light.name.empty() ? fmt::format("light {}", index + 1) : light.name;
}

namespace {

/// Tells whether it is a drawing, as takesKeyAlone().
bool isDrawing(const EffectSubject& subject) {
    const Block* model = subject.material == nullptr
                             ? nullptr
                             : subject.catalog.find(kinds::models, subject.material->model.id);
    return model != nullptr && model->lighting == LightsWanted::Key &&
           subject.scene.drawings == DrawingLights::Key;
}

} // namespace

std::vector<std::string> lightNames(const std::vector<const LightGroup*>& groups,
                                    const EffectSubject& subject) {
    const auto& [material, scene, catalog, view] = subject;
    const bool shadows = hasShadows(scene, catalog);
    const bool takesOne = isDrawing(subject);
    const std::optional<std::size_t> key = keyLight(scene, catalog);
    std::vector<std::string> names;
    for (const LightGroup* group : groups) {
        for (std::size_t i = 0; i < scene.lights.size(); ++i) {
            if (view.reaches(i) && (!takesOne || i == key) &&
                lightKey(scene.lights[i], catalog, shadows) == group->key()) {
                names.push_back(lightName(scene, i));
            }
        }
    }
    return names;
}

std::string namesText(const std::vector<std::string>& names) {
    constexpr std::size_t maxNamed = 4;
    if (names.size() > maxNamed) {
        return fmt::format("{} lights", names.size());
    }
    if (names.size() <= 1) {
        return names.empty() ? std::string() : names.front();
    }
    return fmt::format("{} and {}", fmt::join(names.begin(), std::prev(names.end()), ", "),
                       names.back());
}

std::string compiledText(const std::vector<const BlockUse*>& uses) {
    std::vector<std::string> texts;
    for (const BlockUse* use : uses) {
        std::string text = compiledText(*use);
        if (!text.empty() && std::ranges::find(texts, text) == texts.end()) {
            texts.push_back(std::move(text));
        }
    }
    return fmt::format("{}", fmt::join(texts, "; "));
}

void LightsEffect::choose(const SceneSubject& subject, const EffectSet&) {
    const auto& [scene, catalog, view, isGround] = subject;
    const bool shadows = hasShadows(scene, catalog);
    lights.clear();
    lines_.clear();
    const std::optional<std::size_t> key = keyLight(scene, catalog);
    keyKind = key ? lightKey(scene.lights[*key], catalog, shadows) : 0;
    drawingsTakeKey = scene.drawings == DrawingLights::Key;
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
        const std::optional<LightGroup> group = lightGroup(scene.lights[i], catalog, shadows);
        if (!group) {
            continue;
        }
        lines_.add(group->key(), reachOf(scene.lights[i], group->block.block()).isEverywhere(),
                   view.reaches(i));
        if (view.reaches(i) && std::ranges::find(lights, *group) == lights.end()) {
            lights.push_back(*group);
        }
    }
    std::sort(lights.begin(), lights.end(), isBefore);
    for (LightGroup& group : lights) {
        group.lines = lines_.of(group.key());
    }
}

/// A light is in alone; shadows are those of all lights.
void LightsEffect::admit(const BlockUse& use) {
    if (use.block().kind == kinds::lights) {
        lights = {LightGroup{use, std::nullopt}};
        keyKind = lights.front().key();
    } else if (use.block().kind == kinds::shadows) {
        for (LightGroup& group : lights) {
            group.shadow = use;
            keyKind = group.key();
        }
    }
}

void LightsEffect::addTo(ChoiceHash& hash) const {
    hash.add(std::uint64_t(lights.size()));
    for (const LightGroup& group : lights) {
        hash.add(group.key());
        hash.add(static_cast<std::uint64_t>(group.lines));
    }
    hash.add(keyKind);
    hash.add(drawingsTakeKey);
}

void LightsEffect::list(EffectListing& listing, const EffectSet& set) const {
    if (takesKeyAlone(set)) {
        const auto taken = std::ranges::find(lights, keyKind, &LightGroup::key);
        if (taken != lights.end()) {
            listing.add(
                effectName(taken->block),
                detailed(compiledText(taken->block), true, "key light only: it is a drawing"),
                keyText);
        }
        return;
    }
    for (std::size_t i = 0; i < lights.size() && isLit(set);) {
        std::vector<const LightGroup*> groups;
        std::vector<const BlockUse*> uses;
        const Block& block = lights[i].block.block();
        for (; i < lights.size() && &lights[i].block.block() == &block; ++i) {
            groups.push_back(&lights[i]);
            uses.push_back(&lights[i].block);
        }
        const bool isInColors = std::ranges::any_of(groups, &LightGroup::isInColors);
        const bool hasAmbient = std::ranges::any_of(groups, &LightGroup::hasAmbient);
        const bool isPolarised =
            answersPolarisedLight(set) && std::ranges::any_of(groups, &LightGroup::isPolarised);
        listing.add(
            effectName(*uses.front()),
            detailed(detailed(detailed(compiledText(uses), isInColors, "separate colours"),
                              hasAmbient, "ambient light of their own"),
                     isPolarised, "polarised"),
            [&groups](const EffectSubject& subject) { return shiningText(groups, subject); });
    }
}

void LightsEffect::listMissing(LeftOutListing& listing, const EffectSet& set) const {
    const Scene& scene = listing.subject().scene;
    const bool takesOne = takesKeyAlone(set);
    const std::optional<std::size_t> key = keyLight(scene, listing.subject().catalog);
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
        const Light& light = scene.lights[i];
        const Block* block = listing.subject().catalog.find(kinds::lights, light.block.id);
        if (std::string why = whyNoLight(light, block); !why.empty()) {
            listing.add(lightName(scene, i), std::move(why));
        } else if (takesOne && i != key) {
            listing.add(lightName(scene, i), drawingText(listing.subject()));
        }
    }
    const bool isPolarised = std::ranges::any_of(lights, &LightGroup::isPolarised);
    if (set.model && isPolarised && !answersPolarisedLight(set)) {
        listing.add("polarised light",
                    "The model has no Fresnel term in its slot, which alone would answer to it: it "
                    "counts as ordinary light.");
    }
}

void LightsEffect::place(SceneLayout& layout, const EffectSet&) const {
    for (const LightGroup& group : lights) {
        const Block& block = group.block.block();
        LightPlace place{{&block, layoutOf(block), layout.firstLight++}, std::nullopt};
        if (group.shadow) {
            int behind = place.light.vec4s();
            place.shadow = placed(*group.shadow, behind);
        }
        if (group.hasColors()) {
            place.colors = place.vec4s();
        }
        layout.groups.push_back(std::move(place));
    }
}

bool takesKeyAlone(const EffectSet& set) {
    return set.drawingsTakeKey && set.model && set.model->block().lighting == LightsWanted::Key;
}

bool isTaken(const EffectSet& set, const LightGroup& group) {
    return !takesKeyAlone(set) || group.key() == set.keyKind;
}

bool takesAmbient(const EffectSet& set) {
    return !takesKeyAlone(set) || (set.keyKind == 0 && !set.environment);
}

std::string drawingText(const EffectSubject& subject) {
    const std::optional<std::size_t> key = keyLight(subject.scene, subject.catalog);
    return key ? fmt::format("The material is a drawing and takes the key light, {}, alone.",
                             lightName(subject.scene, *key))
               : std::string("The material is a drawing and takes the environment as one light.");
}

void writeLights(SurfaceText& text) {
    const auto taken = [&text](const LightGroup& group) { return isTaken(text.set, group); };
    if (std::ranges::none_of(text.set.lights, taken)) {
        return;
    }
    text.out.addFile("passes/lit.glsl");
    text.readFrom("sceneData");
    if (hasShadows(text.set)) {
        writeShadowCode(text);
    }
    int nextLine = text.scene.firstLight;
    for (std::size_t i = 0; i < text.set.lights.size(); ++i) {
        if (isTaken(text.set, text.set.lights[i])) {
            writeGroup(text, i, nextLine);
        }
    }
}

void LightsEffect::writeLight(SurfaceText& text) const {
    if (text.set.model) {
        writeLights(text);
    }
}

/// Which objects a light with an end reaches decides whether it is in their programs.
bool LightsEffect::dependsOnPlaces(const Scene& scene, const Catalog& catalog,
                                   std::string_view kind) {
    const bool moves = kind == kinds::lights || kind == settings::object;
    return moves && std::ranges::any_of(scene.lights, [&catalog](const Light& light) {
               const Block* block = catalog.find(kinds::lights, light.block.id);
               return block != nullptr && !reachOf(light, *block).isEverywhere();
           });
}

void LightsEffect::remove(Scene& scene, const EffectName& effect, const Catalog&) {
    for (Light& light : scene.lights) {
        light.enabled =
            light.enabled && !(effect.kind == kinds::lights && light.block.id == effect.id);
    }
}

} // namespace patina
