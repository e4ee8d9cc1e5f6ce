// SPDX-License-Identifier: GPL-3.0-or-later
// The listing of a set of effects.
#include "shading/effects/effect_set.h"

#include <algorithm>
#include <iterator>
#include <map>
#include <utility>

#include <fmt/format.h>

#include "shading/effects/texture_effects.h"

namespace patina {
namespace {

std::string detailOf(const BlockUse& use) {
    std::string out;
    for (const CompiledValue& value : use.compiled) {
        out += fmt::format("{}{}={}", out.empty() ? "" : ", ", value.id, value.value);
    }
    return out;
}

EffectLine lineOf(const BlockUse& use) {
    return {use.kind + '/' + use.id, detailOf(use), use.reason};
}

/// With more to say where `counts`.
EffectLine detailed(EffectLine line, bool counts, std::string_view detail) {
    if (counts) {
        line.detail += line.detail.empty() ? "" : ", ";
        line.detail += detail;
    }
    return line;
}

EffectLine modelLine(const EffectSet& set) {
    EffectLine line = detailed(lineOf(*set.model), set.lightsAtVertices, "lit per vertex");
    line = detailed(std::move(line), set.leavesNormals, "normals as blended");
    return detailed(std::move(line), set.widensHighlights, "highlights widened");
}

const std::string& reasonFor(const Reasons& reasons, std::string_view effect) {
    static const std::string none;
    const auto found = reasons.find(effect);
    return found == reasons.end() ? none : found->second;
}

/// "Key, Fill and Rim", or how many where they are many.
std::string lightNames(const std::vector<std::string>& names) {
    constexpr std::size_t maxNamed = 4;
    if (names.size() > maxNamed) {
        return fmt::format("{} lights", names.size());
    }
    if (names.size() == 1) {
        return names.front();
    }
    return fmt::format("{} and {}", fmt::join(names.begin(), std::prev(names.end()), ", "),
                       names.back());
}

void addOnce(std::vector<std::string>& details, std::string detail) {
    if (!detail.empty() && std::find(details.begin(), details.end(), detail) == details.end()) {
        details.push_back(std::move(detail));
    }
}

/// Blocks of one kind, which differ in compiled values only: one line.
struct KindOfBlock {
    const BlockUse* block = nullptr;
    std::vector<std::string> details{};
    std::vector<std::string> names{}; ///< of the lights

    void add(const BlockUse& use, const LightGroup& group) {
        block = &use;
        addOnce(details, detailOf(use));
        names.insert(names.end(), group.names.begin(), group.names.end());
    }
    EffectLine line(std::string reason) const {
        return {block->kind + '/' + block->id, fmt::format("{}", fmt::join(details, "; ")),
                std::move(reason)};
    }
};

void addLights(std::vector<EffectLine>& lines, const std::vector<LightGroup>& groups) {
    for (std::size_t i = 0; i < groups.size();) {
        KindOfBlock kind;
        const std::string& id = groups[i].block.id;
        for (; i < groups.size() && groups[i].block.id == id; ++i) {
            kind.add(groups[i].block, groups[i]);
        }
        lines.push_back(kind.line(fmt::format("{} {}.", lightNames(kind.names),
                                              kind.names.size() == 1 ? "shines" : "shine")));
    }
}

/// One line for each kind of shadow, with the lights that have such.
void addShadows(std::vector<EffectLine>& lines, const std::vector<LightGroup>& groups) {
    std::map<std::string, KindOfBlock> kinds;
    for (const LightGroup& group : groups) {
        if (group.shadow) {
            kinds[group.shadow->id].add(*group.shadow, group);
        }
    }
    for (const auto& [id, kind] : kinds) {
        lines.push_back(
            kind.line(fmt::format("{} {} {} them.", kind.block->reason, lightNames(kind.names),
                                  kind.names.size() == 1 ? "has" : "have")));
    }
}

/// What lights a surface.
void addLightLines(std::vector<EffectLine>& lines, const EffectSet& set) {
    addLights(lines, set.scene.lights);
    addShadows(lines, set.scene.lights);
    if (set.scene.ambient) {
        lines.push_back({"ambient", {}, reasonFor(set.scene.reasons, "ambient")});
    }
    if (set.scene.hemisphere) {
        lines.push_back({"hemisphere", {}, reasonFor(set.scene.reasons, "hemisphere")});
    }
    if (set.scene.environment) {
        lines.push_back(lineOf(*set.scene.environment));
    }
}

/// What the program asks the model for; without one a fallback is drawn that knows no light.
void addLitLines(std::vector<EffectLine>& lines, const EffectSet& set) {
    lines.push_back(modelLine(set));
    for (const BlockUse& slot : set.slots) {
        lines.push_back(lineOf(slot));
    }
    addLightLines(lines, set);
    for (const std::string& color : set.emission) {
        lines.push_back(
            {"emission", color, "The surface glows by itself: the colour is not black."});
    }
    for (const TextureEffect& texture : set.textures) {
        lines.push_back(lineOf(texture));
    }
}

void addTransparencyLine(std::vector<EffectLine>& lines, const SceneEffects& scene) {
    const std::string& sorted = reasonFor(scene.reasons, "transparency");
    if (scene.transparency) {
        lines.push_back(lineOf(*scene.transparency));
    } else if (!sorted.empty()) {
        lines.push_back({"transparency", "sorted", sorted});
    }
}

bool isListed(const std::vector<EffectLine>& lines, const std::string& effect) {
    return std::any_of(lines.begin(), lines.end(), [&effect](const EffectLine& line) {
        return line.effect == effect || line.effect.starts_with(effect + '/') ||
               line.effect.starts_with(effect + ' ');
    });
}

/// What a document can have and this one does not, by its name or its kind.
void addAbsent(std::vector<EffectLine>& out, const std::vector<EffectLine>& in,
               const EffectLine& absent) {
    if (!isListed(in, absent.effect) && !isListed(out, absent.effect)) {
        out.push_back(absent);
    }
}

} // namespace

std::vector<EffectLine> effectLines(const EffectSet& set) {
    std::vector<EffectLine> lines;
    if (set.model) {
        addLitLines(lines, set);
    }
    if (set.ground != GroundMode::Off) {
        lines.push_back({"ground", {}, reasonFor(set.reasons, "ground")});
        addLightLines(lines, set);
    }
    if (set.blend) {
        lines.push_back(lineOf(*set.blend));
    }
    if (set.scene.fog) {
        const bool atVertices = set.scene.fogsAtVertices && set.ground == GroundMode::Off;
        lines.push_back(detailed(lineOf(*set.scene.fog), atVertices, "per vertex"));
    }
    if (set.opacity) {
        lines.push_back({"opacity", {}, reasonFor(set.reasons, "opacity")});
    }
    if (set.refraction) {
        lines.push_back(lineOf(*set.refraction));
    } else if (isVisiblyTransparent(set)) {
        addTransparencyLine(lines, set.scene);
    }
    if (set.outline) {
        lines.push_back(lineOf(*set.outline));
    }
    return lines;
}

std::vector<EffectLine> leftOutLines(const EffectSet& set) {
    const std::vector<EffectLine> in = effectLines(set);
    std::vector<EffectLine> out;
    for (const auto* list : {&set.leftOut, &set.scene.leftOut}) {
        for (const LeftOut& left : *list) {
            out.push_back({left.what, {}, left.reason});
        }
    }
    addAbsent(out, in, {"ambient", {}, "The scene's ambient colour is black."});
    addAbsent(out, in, {"hemisphere", {}, "The light of its sky and its ground is black."});
    addAbsent(out, in, {"environment", {}, "The scene has no environment."});
    addAbsent(out, in, {"fresnel", {}, "The material has no Fresnel term."});
    addAbsent(out, in, {"shadows", {}, "No light has shadows."});
    addAbsent(out, in, {"texture", {}, "No image is bound to the material."});
    addAbsent(out, in, {"fog", {}, "The scene has no fog."});
    addAbsent(out, in, {"opacity", {}, "The material's opacity is 1."});
    addAbsent(out, in, {"refraction", {}, "The material bends no light."});
    addAbsent(out, in,
              {"transparency",
               {},
               set.refraction ? "What is behind the object is seen bent, in its colour."
                              : "Nothing shines through the object."});
    addAbsent(out, in, {"outline", {}, "The material has no outline."});
    return out;
}

} // namespace patina
