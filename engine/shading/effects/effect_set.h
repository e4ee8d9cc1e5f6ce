// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "catalog/catalog.h"
#include "material/material.h"
#include "scene/scene.h"
#include "shading/effects/effect_view.h"

namespace patina {

/// A choice that is part of the program instead of its data.
struct CompiledValue {
    std::string id;    ///< of the parameter or the accuracy choice
    std::string value; ///< id of the enum value or level; "true", "false"; "zero", "nonzero"

    friend bool operator==(const CompiledValue&, const CompiledValue&) = default;
};

/// A block that a program is made of.
struct BlockUse {
    std::string kind;
    std::string id;
    std::vector<CompiledValue> compiled; ///< in the descriptor's order
    std::string reason;                  ///< one sentence: why it is in

    friend bool operator==(const BlockUse&, const BlockUse&) = default;
};

/// All lights of one kind with the same compiled values: one loop in the program, or a line for
/// each.
struct LightGroup {
    BlockUse block;
    std::optional<BlockUse> shadow; ///< how their shadows are drawn; nothing: there are none
    ShadowProjection projection = ShadowProjection::None; ///< of the shadows
    int count = 0; ///< lights in it now
    int lines = 0; ///< lights that stand in the program's text; 0: a loop, whose length is data
    std::uint64_t key = 0; ///< EffectKey::ofLight of each of its lights
    std::vector<std::string> names{}; ///< of its lights, in the scene's order

    friend bool operator==(const LightGroup&, const LightGroup&) = default;
};

/// Something that is in the document and not in the program.
struct LeftOut {
    std::string what;
    std::string reason;

    friend bool operator==(const LeftOut&, const LeftOut&) = default;
};

/// By effect: one sentence each, for what is no block and in the program.
using Reasons = std::map<std::string, std::string, std::less<>>;

/// What the scene brings into every program that is used in it.
struct SceneEffects {
    std::vector<LightGroup> lights; ///< sorted by kind of light, then by compiled values
    std::optional<BlockUse> fog;
    std::optional<BlockUse> environment;
    std::optional<BlockUse> transparency; ///< in programs of what lets something through
    bool ambient = false;
    bool hemisphere = false;
    bool isShownRefracted = false;    ///< by what bends light, see showsSceneRefracted()
    bool wantsVertexLight = false;    ///< see EffectSet::lightsAtVertices
    bool wantsBlendedNormals = false; ///< see EffectSet::leavesNormals
    bool wantsWideHighlights = false; ///< see EffectSet::widensHighlights
    bool fogsAtVertices = false;      ///< but on the ground
    Reasons reasons;
    std::vector<LeftOut> leftOut;

    friend bool operator==(const SceneEffects&, const SceneEffects&) = default;
};

/// An image that is in a program. Which image, and where it lies on the surface, is data.
struct TextureEffect {
    std::string id; ///< its key in Material::textures
    TextureRole role = TextureRole::Input;
    std::string kind;  ///< role Input: "models" or a part's
    std::string field; ///< then the field that it changes, and what that is
    bool isColor = false;
    glm::dvec2 range{0.0, 1.0};
    TextureChannel channel = TextureChannel::Color;
    bool isUsualChannel = false; ///< not chosen: for alpha the grey of an image that has none
    TextureMode mode = TextureMode::Replace;
    bool cutOut = false;

    friend bool operator==(const TextureEffect&, const TextureEffect&) = default;
};

/// Where the material's Fresnel block works.
enum class FresnelMode {
    None,  ///< there is none
    Slot,  ///< the model calls it
    Blend, ///< the summed light is blended towards its tint
};

/// Exactly what one program computes. A value: equal sets give equal program text.
struct EffectSet {
    std::optional<BlockUse> model; ///< nothing: the catalogue lacks it; a plain fallback is drawn
    FresnelMode fresnelMode = FresnelMode::None;
    std::vector<BlockUse> slots;   ///< what fills the model's slots, in the descriptor's order
    std::optional<BlockUse> blend; ///< the Fresnel block of FresnelMode::Blend
    std::vector<std::string> emission; ///< the model's colours that are emitted and not black
    std::vector<TextureEffect> textures; ///< sorted by id
    bool opacity = false;
    std::optional<BlockUse> refraction; ///< what bends the light that passes
    std::optional<BlockUse> outline; ///< drawn by a program of its own (see outline_source.h)
    bool lightsAtVertices = false; ///< the model is asked there and its light blended
    bool leavesNormals = false;    ///< as short as blending those of the vertices makes them
    bool widensHighlights = false; ///< by what the surface turns within a pixel
    GroundMode ground = GroundMode::Off; ///< the ground is drawn so, in place of a model
    SceneEffects scene;
    Reasons reasons;
    std::vector<LeftOut> leftOut;

    friend bool operator==(const EffectSet&, const EffectSet&) = default;
};

/// Whether something may shine through what is drawn with the set.
bool isVisiblyTransparent(const EffectSet& set);

/// What the scene's lights, fog and ambient colour call for. A light is left out when it is
/// disabled or cannot send anything (its `color` is black or its `intensity` is 0), fog when its
/// `density` is 0 or what is drawn is too near for anybody to see it, shadows when no object casts
/// any or none is seen, an environment that is dark (unless an object bends what is behind it) or
/// lacks its picture, and blocks that the catalogue does not know.
SceneEffects sceneEffects(const Scene& scene, const Catalog& catalog, const EffectView& view = {});

/// What shading `material` in the scene calls for. A pure function of its arguments.
EffectSet effectSet(const Material& material, const Scene& scene, const Catalog& catalog,
                    const EffectView& view = {});

/// What drawing the scene's ground calls for; its `ground` is Off when there is nothing to draw.
EffectSet groundEffects(const Scene& scene, const Catalog& catalog, const EffectView& view = {});

/// One line of a listing of effects.
struct EffectLine {
    std::string effect; ///< "models/<id>", "lights/<id>", "ambient", "opacity": each once
    std::string detail; ///< compiled values and counts; may be empty
    std::string reason;

    friend bool operator==(const EffectLine&, const EffectLine&) = default;
};

/// The set as a list, in the order in which the program's text is assembled.
std::vector<EffectLine> effectLines(const EffectSet& set);

/// What is not in the program and why, also what the document does not have at all.
std::vector<EffectLine> leftOutLines(const EffectSet& set);

} // namespace patina
