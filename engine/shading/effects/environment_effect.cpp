// SPDX-License-Identifier: GPL-3.0-or-later
#include "shading/effects/environment_effect.h"

#include <algorithm>

#include <fmt/format.h>

#include "scene/environment.h"
#include "shading/effects/data_layout.h"
#include "shading/effects/effect_set.h"
#include "shading/effects/neutral_values.h"
#include "shading/effects/surface_text.h"
#include "shading/program/block_source.h"

namespace patina {
namespace {

/// Returns a sentence such as "It is dark. Its “Intensity” is 0."
std::string whyNoEnvironment(const Scene& scene, const Catalog& catalog, const char* whyNot) {
    const Block* block = catalog.find(kinds::environment, scene.part(kinds::environment)->id);
    const std::string neutral =
        block == nullptr ? std::string()
                         : whyNeutral(*block, scene.part(kinds::environment)->parameters);
    return neutral.empty() ? whyNot : whyNot + (' ' + neutral);
}

std::string environmentText(const EffectSubject& subject) {
    const BlockValues& values = *subject.scene.part(kinds::environment);
    const Block& block = *subject.catalog.find(kinds::environment, values.id);
    return isNeutral(block, values.parameters) ? "It is dark, and what an object refracts shows it."
                                               : "The scene has an environment that sends light.";
}

std::string octahedralSource() {
    using Layout = OctahedralLayout;
    return fmt::format("#define OCTAHEDRAL_TEXELS {}\n#define OCTAHEDRAL_LEVELS {}\n"
                       "#define LOG2_KAPPA {}\n#define MATTE_TEXELS {}\n"
                       "#define MATTE_TEXEL_ORIGIN {}, {}\n",
                       Layout::texels, Layout::levels, Layout::log2Kappa, Layout::matteTexels,
                       Layout::matteOrigin.x, Layout::matteOrigin.y);
}

void addOutput(SourceBuilder& out, const BlockUse& use, EnvironmentOutput output) {
    if (output == EnvironmentOutput::Small) {
        out.add("#define PART_SIDE 4\n"
                "#define DIRECTION_AT(p) environmentDirectionAt((p) / environmentData[1].xy)\n");
        out.addFile("passes/environment_bake.glsl");
        return;
    }
    if (output == EnvironmentOutput::Octahedral) {
        out.add(octahedralSource());
        out.addFile("passes/octahedral_levels.glsl");
        out.add("#define PART_SIDE 2\n#define DIRECTION_AT(p) octahedralDirectionAt(p)\n");
        out.addFile("passes/environment_bake.glsl");
        return;
    }
    if (output == EnvironmentOutput::Matte) {
        addIrradiance(out, use);
        out.add(octahedralSource());
        out.addFile("passes/environment_matte.glsl");
        return;
    }
    out.addFile("passes/environment_points.glsl");
    if (output == EnvironmentOutput::FittedBackground) {
        out.add(octahedralSource());
        out.addFile("passes/environment_out_of_focus.glsl");
        out.addFile("passes/environment_fitted_background.glsl");
    } else {
        out.addFile(output == EnvironmentOutput::SharpBackground
                        ? "passes/environment_sharp.glsl"
                        : "passes/environment_blurred.glsl");
    }
    out.addFile("passes/environment_background.glsl");
}

/// Returns how its light comes to a material.
EnvironmentMethod methodFor(const EffectSet& set) {
    if (takesKeyAlone(set)) {
        return set.keyKind != 0 ? EnvironmentMethod::None : EnvironmentMethod::OneLight;
    }
    if (!set.wantsFitted) {
        return EnvironmentMethod::Sampled;
    }
    if (set.model->block().lighting == LightsWanted::Key) {
        return EnvironmentMethod::OneLight;
    }
    if (set.shells && lightsStrands(*set.shells)) {
        return EnvironmentMethod::OneLight; // no table has their light
    }
    const bool isTextured = std::ranges::any_of(set.textures, [](const BoundTexture& texture) {
        return texture.role == TextureRole::Input;
    });
    return isTextured || laysPattern(set) ? EnvironmentMethod::PerPixel : EnvironmentMethod::Fitted;
}

Checked<ProgramSource> lobeProgram(const LobeTableShape& shape, const Catalog& catalog,
                                   const char* file) {
    return screenProgram(catalog, [&](SourceBuilder& fragment) {
        fragment.add(lobeTableSource(shape));
        fragment.addFile(file);
    });
}

const char* methodText(EnvironmentMethod method) {
    switch (method) {
    case EnvironmentMethod::Fitted:
        return "fitted";
    case EnvironmentMethod::PerPixel:
        return "fitted at each pixel";
    case EnvironmentMethod::OneLight:
        return "as one light";
    default:
        return "";
    }
}

void writeFitted(SurfaceText& text, const EnvironmentEffect& effect) {
    text.addOpenDirections();
    addEnvironment(text.out, *effect.environment, EnvironmentLayout::harmonics);
    if (effect.method == EnvironmentMethod::OneLight) {
        addIrradiance(text.out, *effect.environment);
        text.out.addFile("passes/lit.glsl");
        text.out.addFile("passes/environment_one_light.glsl");
        text.main += "    shaded += oneLight(s, model);\n";
        return;
    }
    text.out.add(octahedralSource());
    text.out.addFile("passes/environment_out_of_focus.glsl");
    if (effect.method == EnvironmentMethod::Fitted) {
        text.out.add(lobeTableSource(lobeTableShape(text.set.model->block())));
        text.out.addFile("passes/environment_fitted.glsl");
        text.main += fmt::format("    shaded += {}fittedLight(s);\n", text.unasked);
    } else {
        text.out.addFile("passes/environment_fitted_here.glsl");
        text.main += "    shaded += fittedLight(s, model);\n";
    }
}

/// Returns the parameter that no direction's light exceeds; null where there is no limit.
const Parameter* limitOf(const BlockUse& use) {
    const Parameter* limit = use.block().withRole(roles::limit);
    const std::vector<CompiledValue> compiled = use.compiled();
    const bool isIn =
        limit != nullptr && std::ranges::none_of(compiled, [limit](const CompiledValue& value) {
            return value.id == limit->id && value.value == "zero";
        });
    return isIn ? limit : nullptr;
}

} // namespace

EnvironmentChoice environmentChoice(const Scene& scene, const Catalog& catalog) {
    if (!scene.part(kinds::environment)) {
        return {};
    }
    const Block* block = catalog.find(kinds::environment, scene.part(kinds::environment)->id);
    if (block == nullptr) {
        return {nullptr, "No environment of this kind is known."};
    }
    if (isNeutral(*block, scene.part(kinds::environment)->parameters) &&
        !hasRefraction(scene, catalog)) {
        return {nullptr, "It is dark."};
    }
    if (pictureParameter(*block) != nullptr &&
        pictureFile(*scene.part(kinds::environment), *block).empty()) {
        return {nullptr, "No picture is chosen for it."};
    }
    return {block, ""};
}

bool fitsWhileMoving(const Scene& scene, const Catalog& catalog) {
    const auto isDrawing = [&catalog](const Object& object) {
        const Block* model = catalog.find(kinds::models, object.material.model.id);
        return object.visible && model != nullptr && model->lighting == LightsWanted::Key;
    };
    return !scene.accuracy.fitsEnvironment() &&
           environmentChoice(scene, catalog).block != nullptr &&
           std::ranges::none_of(scene.objects, isDrawing);
}

void EnvironmentEffect::choose(const SceneSubject& subject, const EffectSet&) {
    const Block* block = environmentChoice(subject.scene, subject.catalog).block;
    environment.reset();
    if (block != nullptr) {
        environment.emplace(*block, subject.scene.part(kinds::environment)->parameters);
    }
    wantsFitted = block != nullptr &&
                  (subject.scene.accuracy.fitsEnvironment() || subject.view.fitsEnvironment);
}

/// Takes the environment as sampled, since a surface calls it then.
void EnvironmentEffect::admit(const BlockUse& use) {
    if (use.block().kind == kinds::environment) {
        *this = {.environment = use};
    }
}

void EnvironmentEffect::adjust(const EffectSet& set) {
    method = set.model ? methodFor(set) : EnvironmentMethod::Sampled;
}

void EnvironmentEffect::list(EffectListing& listing, const EffectSet& set) const {
    if (environment && isLit(set) && method != EnvironmentMethod::None) {
        listing.add(effectName(*environment),
                    detailed(compiledText(*environment), method != EnvironmentMethod::Sampled,
                             methodText(method)),
                    environmentText);
    }
}

void EnvironmentEffect::listMissing(LeftOutListing& listing, const EffectSet&) const {
    if (environment && method == EnvironmentMethod::None) {
        listing.add(effectName(*environment), drawingText(listing.subject()));
    }
    const auto& [material, scene, catalog, view] = listing.subject();
    const EnvironmentChoice choice = environmentChoice(scene, catalog);
    if (scene.part(kinds::environment) && choice.block == nullptr) {
        listing.add(effectName(kinds::environment, scene.part(kinds::environment)->id),
                    whyNoEnvironment(scene, catalog, choice.whyNot));
    }
}

void EnvironmentEffect::place(SceneLayout& layout, const EffectSet&) const {
    layout.environment = environment ? &environment->block() : nullptr;
}

/// The inspection looks at single values, of which the environment's light is a sum of many.
void EnvironmentEffect::writeLight(SurfaceText& text) const {
    if (!environment || !text.set.model || text.isInspected()) {
        return;
    }
    if (method == EnvironmentMethod::None) {
        if (text.set.refraction) { // what is seen through it asks for it
            addEnvironment(text.out, *environment);
        }
        return;
    }
    if (method != EnvironmentMethod::Sampled) {
        writeFitted(text, *this);
        return;
    }
    text.addOpenDirections();
    addEnvironment(text.out, *environment);
    text.out.addFile("passes/environment_points.glsl");
    text.out.addFile("passes/environment_light.glsl");
    text.main += fmt::format("    shaded += environmentLight(s, unpackEnvironment({}), model);\n",
                             EnvironmentLayout::fixed);
}

std::string_view EnvironmentEffect::whyPerPixel(const EffectSet& set) const {
    return isLitByEnvironment(set) ? "an environment's light is summed up there."
                                   : std::string_view();
}

void EnvironmentEffect::remove(Scene& scene, const EffectName& effect, const Catalog&) {
    if (effect.kind == kinds::environment && scene.part(kinds::environment) &&
        scene.part(kinds::environment)->id == effect.id) {
        scene.setPart(kinds::environment, std::nullopt);
    }
}

bool isLitByEnvironment(const EffectSet& set) {
    return set.environment && set.method != EnvironmentMethod::None;
}

void addIrradiance(SourceBuilder& out, const BlockUse& use) {
    out.add(fmt::format("#define ENVIRONMENT_HARMONICS {}\n",
                        EnvironmentLayout::fixed + vec4Count(use.block())));
    out.addFile("passes/environment_irradiance.glsl");
}

void addEnvironment(SourceBuilder& out, const BlockUse& use, int more) {
    const Block& block = use.block();
    out.add(fmt::format("#define ENVIRONMENT_VEC4S {}\n",
                        EnvironmentLayout::fixed + vec4Count(block) + more));
    out.addFile("passes/environment.glsl");
    const bool hasPicture = pictureParameter(block) != nullptr;
    if (hasPicture) {
        out.addFile("passes/environment_picture.glsl");
    }
    out.add("#undef PARAMETER_DATA\n#define PARAMETER_DATA(i) environmentData[base + (i)]\n");
    out.add(constantsSource(block) + structSource(block));
    out.addBlock(block);
    out.add(unpackSource(block, {"unpackEnvironment", use.compiled()}));
    out.add(fmt::format("#define Environment {}\n#define environmentValue {}\n"
                        "#define ENVIRONMENT_PICTURE(d) {}\n",
                        structName(block), functionName(block),
                        hasPicture ? "environmentPicture(d)" : "vec3(1.0)"));
    if (const Parameter* limit = limitOf(use)) {
        out.addFile("passes/environment_limit.glsl");
        out.add(fmt::format("#define ENVIRONMENT_CUT(x, p) environmentCut(x, (p).{})\n",
                            fieldName(limit->id)));
    } else {
        out.add("#define ENVIRONMENT_CUT(x, p) (x)\n");
    }
    out.addFile("passes/environment_radiance.glsl");
}

Checked<ProgramSource> environmentProgram(const BlockUse& use, const Catalog& catalog,
                                          EnvironmentOutput output) {
    return screenProgram(catalog, [&](SourceBuilder& fragment) {
        const bool isMatte = output == EnvironmentOutput::Matte;
        addEnvironment(fragment, use, isMatte ? EnvironmentLayout::harmonics : 0);
        addOutput(fragment, use, output);
    });
}

Checked<ProgramSource> environmentBlurProgram(const Catalog& catalog) {
    return screenProgram(catalog, [](SourceBuilder& fragment) {
        fragment.add(octahedralSource());
        fragment.addFile("passes/environment_blur.glsl");
    });
}

Checked<ProgramSource> lobeFitProgram(const LobeTableShape& shape, const Catalog& catalog) {
    return lobeProgram(shape, catalog, "passes/lobe_fit.glsl");
}

Checked<ProgramSource> lobeTableProgram(const LobeTableShape& shape, const Catalog& catalog) {
    return lobeProgram(shape, catalog, "passes/lobe_table.glsl");
}

std::string lobeTableSource(const LobeTableShape& shape) {
    return fmt::format("#define VIEWERS {}\n#define AZIMUTHS {}\n#define SECTORS {}\n"
                       "#define FITTED_WIDTH {}\n#define TABLE_STEPS {}\n",
                       shape.viewers, shape.azimuths, shape.sectors, LobeTableShape::fittedWidth,
                       LobeTableShape::steps);
}

} // namespace patina
