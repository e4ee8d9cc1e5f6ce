// SPDX-License-Identifier: GPL-3.0-or-later
#include "shading/effects/block_trial.h"

#include <algorithm>

#include "material/block_values.h"
#include "material/material.h"
#include "shading/effects/effect_set.h"
#include "shading/effects/surface_program.h"

namespace patina {
namespace {

BlockUse usualUse(const Block& block) {
    return BlockUse(block, defaultValues(block));
}

/// The first block that ships and suits; null: there is none.
template <class Suits>
const Block* shippedBlock(const Catalog& catalog, std::string_view kind, const Suits& suits) {
    const auto found =
        std::find_if(catalog.blocks.begin(), catalog.blocks.end(), [&](const Block& block) {
            return block.shipped && block.kind == kind && suits(block);
        });
    return found == catalog.blocks.end() ? nullptr : &*found;
}

/// A model with a slot for a highlight; one without a slot for a Fresnel block, which then blends
/// the sum, where all of it is called.
bool suitsPart(const Block& model, const std::string& kind) {
    return (model.slot(kind) != nullptr) == (kind == kinds::specular);
}

/// Where levels read tables, one of them is tried instead of the exact one.
void chooseTables(Material& material, const Block& block) {
    for (const AccuracyChoice& choice : block.accuracy) {
        const auto level = std::find_if(choice.values.begin(), choice.values.end(),
                                        [](const EnumValue& v) { return !v.table.empty(); });
        if (level != choice.values.end()) {
            material.accuracy[choice.id] = level->id;
        }
    }
}

LightGroup lightFor(const Block& light, const Block& block) {
    LightGroup group{usualUse(light), std::nullopt};
    if (block.kind == kinds::shadows) {
        group.shadow = usualUse(block);
    }
    return group;
}

} // namespace

Material trialMaterial(const Block& block, const Catalog& catalog) {
    const bool isPart = std::ranges::count(partKinds(BlockOwner::Material), block.kind) > 0;
    const Block* model = block.kind == kinds::models
                             ? &block
                             : shippedBlock(catalog, kinds::models, [&](const Block& candidate) {
                                   return !isPart || suitsPart(candidate, block.kind);
                               });
    Material material = model == nullptr ? Material() : defaultMaterial(*model);
    if (isPart) {
        material.parts[block.kind] = defaultBlockValues(block);
    }
    chooseTables(material, block);
    return material;
}

const Block* trialLight(const Block& block, const Catalog& catalog) {
    if (block.kind == kinds::lights) {
        return &block;
    }
    return shippedBlock(catalog, kinds::lights, [](const Block& light) {
        return light.shadowProjection != ShadowProjection::None;
    });
}

Checked<ProgramSource> trialProgram(const Block& block, const Catalog& catalog) {
    const Material material = trialMaterial(block, catalog);
    EffectSet set = effectSet(material, Scene(), catalog);
    set.ambient = true;
    if (const Block* light = trialLight(block, catalog)) {
        set.lights = {lightFor(*light, block)};
    }
    if (block.kind == kinds::fog) {
        set.fog = usualUse(block);
    } else if (block.kind == kinds::environment) {
        set.environment = usualUse(block);
    } else if (block.kind == kinds::transparency) {
        set.transparency = usualUse(block);
        set.opacity = true;
    } else if (block.kind == kinds::refraction) {
        set.refraction = usualUse(block);
        set.opacity = true;
    }
    if (block.kind == kinds::outline) {
        set.outline = usualUse(block);
        return outlineProgram(set, catalog);
    }
    // A picture looks entries up; the inspection computes them, so that their text is tried too.
    return surfaceProgram(
        set, catalog, block.tables.empty() ? SurfaceOutput::Picture : SurfaceOutput::Inspection);
}

} // namespace patina
