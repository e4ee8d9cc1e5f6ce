// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>

#include <glm/vec2.hpp>

#include "catalog/catalog.h"
#include "shading/effects/effect_parts.h"
#include "shading/program/source_builder.h"
#include "shading/program/program_source.h"
#include "shading/program/surface_output.h"

namespace patina {

/// Holds what an environment is made of, when it sends light or an object refracts what is behind
/// it, which shows a dark one as well; else a null block and a sentence why not.
struct EnvironmentChoice {
    const Block* block = nullptr;
    const char* whyNot = ""; ///< empty where there is no environment at all
};
EnvironmentChoice environmentChoice(const Scene& scene, const Catalog& catalog);

/// Tells whether a view may fit the scene's light while it changes and sample it at rest: the scene
/// has an environment whose light is sampled, and shows no drawing, which would take a fitted one
/// for one light.
bool fitsWhileMoving(const Scene& scene, const Catalog& catalog);

/// Tells how the light of an environment comes to a surface.
enum class EnvironmentMethod : std::uint8_t {
    Sampled,  ///< a mean over directions
    Fitted,   ///< by a table of lobes that the material's reflectance was taken apart into
    PerPixel, ///< the same, taken apart at each pixel, since images or a pattern change what is
              ///< reflected
    OneLight, ///< one light from where most of it comes, for models that want one
    None      ///< not at all: a drawing takes another light
};

/// Holds the scene's environment. It is left out where it is dark, unless an object refracts what
/// is behind it, and where it lacks its picture.
struct EnvironmentEffect {
    static constexpr bool isKnownToReference = true;

    std::optional<BlockUse> environment;
    bool wantsFitted = false; ///< as the scene or the view says
    EnvironmentMethod method = EnvironmentMethod::Sampled;

    void choose(const SceneSubject& subject, const EffectSet& set);
    void admit(const BlockUse& use);
    void adjust(const EffectSet& set);
    void addTo(ChoiceHash& hash) const {
        hash.add(environment);
        hash.add(wantsFitted);
    }
    void list(EffectListing& listing, const EffectSet& set) const;
    void listMissing(LeftOutListing& listing, const EffectSet& set) const;
    EffectLine absent(const EffectSet&) const {
        return {std::string(kinds::environment), {}, "The scene has no environment."};
    }
    void place(SceneLayout& layout, const EffectSet& set) const;
    void writeLight(SurfaceText& text) const;
    std::string_view whyPerPixel(const EffectSet& set) const;
    static void remove(Scene& scene, const EffectName& effect, const Catalog& catalog);

    friend bool operator==(const EnvironmentEffect&, const EnvironmentEffect&) = default;
};

/// Tells whether the program takes directions of the environment, or its light as a whole.
bool isLitByEnvironment(const EffectSet& set);

/// Declares the environment: its data, its block, `unpackEnvironment(int base)` and
/// `environmentRadiance(vec3 d, Environment p)`. Its array has so many vec4 `more` behind the
/// block's.
void addEnvironment(SourceBuilder& out, const BlockUse& use, int more = 0);

/// Declares what a white matte surface shows by the direction of its normal, behind the
/// environment with its harmonics.
void addIrradiance(SourceBuilder& out, const BlockUse& use);

/// Tells what an environment's own programs draw.
enum class EnvironmentOutput {
    Small,             ///< the small picture that its table is made from
    Octahedral,        ///< level 0 of its octahedral picture
    Matte,             ///< what a white matte surface shows, beside that
    SharpBackground,   ///< what is seen behind the objects
    BlurredBackground, ///< the same out of focus
    FittedBackground   ///< the same from the octahedral picture, without grain
};

/// Returns a program that covers the target. The uniform block is called EnvironmentBlock.
Checked<ProgramSource> environmentProgram(const BlockUse& use, const Catalog& catalog,
                                          EnvironmentOutput output);

/// Says how an environment's octahedral picture lies, whose levels are more and more out of focus;
/// beside level 2 stands what matte surfaces show (shaders/passes/octahedral_levels.glsl).
struct OctahedralLayout {
    static constexpr int texels = 512;   ///< the width of level 0, with the texels around it
    static constexpr int levels = 7;     ///< each half as wide as the one before
    static constexpr int log2Kappa = 12; ///< that level 0 is looked up for, by 2 less at each level
    static constexpr int matteTexels = texels / 16;
    static constexpr glm::ivec2 matteOrigin{texels * 5 / 4, texels / 2};
};

/// Returns a program that makes a level of any environment's octahedral picture from the level
/// before.
Checked<ProgramSource> environmentBlurProgram(const Catalog& catalog);

/// Returns a program that takes the samples of SurfaceOutput::LobeSamples apart into lobes.
Checked<ProgramSource> lobeFitProgram(const LobeTableShape& shape, const Catalog& catalog);

/// Returns a program that makes the table which surfaces read from the lobes that were fitted.
Checked<ProgramSource> lobeTableProgram(const LobeTableShape& shape, const Catalog& catalog);

/// Defines the shape of a table of lobes, which its programs and its readers know it by.
std::string lobeTableSource(const LobeTableShape& shape);

} // namespace patina
