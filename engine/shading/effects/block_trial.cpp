// SPDX-License-Identifier: GPL-3.0-or-later
#include "shading/effects/block_trial.h"

#include <algorithm>

#include "material/block_values.h"
#include "material/material.h"
#include "shading/effects/display_set.h"
#include "shading/effects/effect_set.h"
#include "shading/effects/surface_program.h"

namespace patina {
namespace {

/// Returns the first block that ships and suits; null: there is none.
template <class Suits>
const Block* shippedBlock(const Catalog& catalog, std::string_view kind, const Suits& suits) {
    const auto found =
        std::find_if(catalog.blocks.begin(), catalog.blocks.end(), [&](const Block& block) {
            return block.shipped && block.kind == kind && suits(block);
        });
    return found == catalog.blocks.end() ? nullptr : &*found;
}

/// Returns a model with a slot for a block of a kind that needs one; else one without, so that the
/// block is called by the program itself.
bool suitsPart(const Block& model, const std::string& kind) {
    return (model.slot(kind) != nullptr) == findKind(kind)->needsSlot;
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

/// Returns values with which all functions of the block are in its program: the defaults, and
/// strands that light themselves.
BlockValues trialValues(const Block& block) {
    BlockValues values = defaultBlockValues(block);
    if (const Parameter* lighting = block.withRole(roles::lighting)) {
        values.parameters[lighting->id] = std::string("strand");
    }
    return values;
}

/// Returns a material that has the block where its kind is a material's, and is plain otherwise.
/// What puts surfaces together and what refracts needs it to be transparent; it still casts a
/// shadow. Strands grow on a solid one, and marks are set on one.
Material trialMaterial(const Block& block, const Catalog& catalog) {
    const bool isPart = std::ranges::count(partKinds(BlockOwner::Material), block.kind) > 0;
    const Block* model = block.kind == kinds::models
                             ? &block
                             : shippedBlock(catalog, kinds::models, [&](const Block& candidate) {
                                   return !isPart || suitsPart(candidate, block.kind);
                               });
    Material material = model == nullptr ? Material() : defaultMaterial(*model);
    const bool needsSolid = block.kind == kinds::shells || block.kind == kinds::strokes;
    material.opacity = needsSolid ? 1.0 : 0.5;
    if (isPart) {
        material.parts[block.kind] = trialValues(block);
    }
    chooseTables(material, block);
    return material;
}

/// Returns the block where it is a light, else one that casts shadows; null where none ships.
const Block* trialLight(const Block& block, const Catalog& catalog) {
    if (block.kind == kinds::lights) {
        return &block;
    }
    return shippedBlock(catalog, kinds::lights, [](const Block& light) {
        return light.shadowProjection != ShadowProjection::None;
    });
}

/// Puts it in where its kind is a part of such an owner.
template <class Owner>
void addPart(Owner& owner, BlockOwner kindOfOwner, const Block& block) {
    if (std::ranges::count(partKinds(kindOfOwner), block.kind) > 0) {
        owner.setPart(block.kind, defaultBlockValues(block));
    }
}

} // namespace

Scene trialScene(const Block& block, const Catalog& catalog) {
    Scene scene;
    Object object;
    object.material = trialMaterial(block, catalog);
    scene.objects.push_back(object);
    object.translation = {0.7, 0.7, -0.7}; // behind it, and in its shadow
    scene.objects.push_back(object);
    if (const Block* light = trialLight(block, catalog)) {
        scene.lights.push_back({"light", true, defaultBlockValues(*light)});
        addPart(scene.lights.back(), BlockOwner::Light, block);
    }
    addPart(scene, BlockOwner::Scene, block);
    if (block.kind == kinds::pass) {
        scene.passes.push_back(defaultBlockValues(block));
    }
    scene.ambient = glm::dvec3(0.25);
    return scene;
}

Checked<ProgramSource> trialProgram(const Block& block, const Catalog& catalog) {
    const Scene scene = trialScene(block, catalog);
    if (block.kind == kinds::tone) {
        return displayProgram(displaySet(scene, catalog), catalog);
    }
    if (block.kind == kinds::pass) {
        return pictureTrialProgram(BlockUse(block, defaultValues(block)), catalog);
    }
    EffectSet set = effectSet(scene.objects.front().material, scene, catalog);
    set.each([use = BlockUse(block, trialValues(block).parameters)](auto& effect) {
        if constexpr (requires { effect.admit(use); }) {
            effect.admit(use);
        }
    });
    if (set.outline) {
        return outlineProgram(set, catalog);
    }
    if (set.strokes) {
        return marksProgram(set, catalog);
    }
    // A picture looks entries up; the inspection computes them, so that their text is tried too.
    return surfaceProgram(
        set, catalog, block.tables.empty() ? SurfaceOutput::Picture : SurfaceOutput::Inspection);
}

} // namespace patina
