// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "catalog/catalog.h"
#include "shading/effects/effect_parts.h"
#include "shading/glsl/source_builder.h"
#include "shading/program/program_source.h"

namespace patina {

/// What an environment is made of, when it sends light or an object refracts what is behind it,
/// which shows a dark one as well; else a null block and a sentence why not.
struct EnvironmentChoice {
    const Block* block = nullptr;
    const char* whyNot = ""; ///< empty where there is no environment at all
};
EnvironmentChoice environmentChoice(const Scene& scene, const Catalog& catalog);

/// The scene's environment. It is left out where it is dark, unless an object refracts what is
/// behind it, and where it lacks its picture.
struct EnvironmentEffect {
    std::optional<BlockUse> environment;

    void choose(const SceneSubject& subject, const EffectSet& set);
    void addTo(ChoiceHash& hash) const { hash.add(environment); }
    void list(EffectListing& listing, const EffectSet& set) const;
    void listMissing(LeftOutListing& listing, const EffectSet& set) const;
    EffectLine absent(const EffectSet&) const {
        return {std::string(kinds::environment), {}, "The scene has no environment."};
    }
    void place(SceneLayout& layout, const EffectSet& set) const;
    void writeLight(SurfaceText& text) const;
    static void remove(Scene& scene, const EffectName& effect, const Catalog& catalog);

    friend bool operator==(const EnvironmentEffect&, const EnvironmentEffect&) = default;
};

/// Declares the environment: its data, its block, `unpackEnvironment(int base)` and
/// `environmentRadiance(vec3 d, Environment p)`.
void addEnvironment(SourceBuilder& out, const BlockUse& use);

/// What an environment's own programs draw.
enum class EnvironmentOutput {
    Small,            ///< the small picture that its table is made from
    SharpBackground,  ///< what is seen behind the objects
    BlurredBackground ///< the same out of focus
};

/// A program that covers the target. The uniform block is called EnvironmentBlock.
Checked<ProgramSource> environmentProgram(const BlockUse& use, const Catalog& catalog,
                                          EnvironmentOutput output);

} // namespace patina
