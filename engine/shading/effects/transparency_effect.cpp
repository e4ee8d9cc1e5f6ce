// SPDX-License-Identifier: GPL-3.0-or-later
#include "shading/effects/transparency_effect.h"

#include <algorithm>

#include <fmt/format.h>

#include "scene/transparency.h"
#include "shading/effects/data_layout.h"
#include "shading/effects/effect_set.h"
#include "shading/effects/surface_text.h"

namespace patina {
namespace {

std::string countText(int count) {
    return count == 1 ? std::string("One object is transparent")
                      : fmt::format("{} objects are transparent", count);
}

/// Says how the layers of transparent surfaces are put together.
const char* methodOf(const Scene& scene, const Block* block) {
    if (block == nullptr) {
        return "each is blended over what is behind it, far ones first";
    }
    return layersOf(*scene.part(kinds::transparency), *block) > 0
               ? "the layers of each pixel are put in their order"
               : "all layers of a pixel are mixed at once";
}

std::string transparencyText(const EffectSubject& subject) {
    const auto& [material, scene, catalog, view] = subject;
    return fmt::format("{}: {}.", countText(countTransparent(scene, catalog)),
                       methodOf(scene, transparencyBlock(scene, catalog)));
}

} // namespace

bool isVisiblyTransparent(const Object& object, const Catalog& catalog) {
    return object.visible && canBeSeen(object.material) && isTransparent(object.material, catalog);
}

int countTransparent(const Scene& scene, const Catalog& catalog) {
    return static_cast<int>(std::ranges::count_if(scene.objects, [&catalog](const Object& object) {
        return isVisiblyTransparent(object, catalog);
    }));
}

bool isVisiblyTransparent(const EffectSet& set) {
    return set.opacity || std::ranges::any_of(set.textures, [](const BoundTexture& texture) {
               return texture.role == TextureRole::Opacity && !texture.cutOut;
           });
}

const Block* transparencyBlock(const Scene& scene, const Catalog& catalog) {
    const bool isNeeded = scene.part(kinds::transparency) &&
                          std::ranges::any_of(scene.objects, [&catalog](const Object& object) {
                              return isVisiblyTransparent(object, catalog);
                          });
    return isNeeded ? catalog.find(kinds::transparency, scene.part(kinds::transparency)->id)
                    : nullptr;
}

void TransparencyEffect::choose(const SceneSubject& subject, const EffectSet&) {
    const Block* block = transparencyBlock(subject.scene, subject.catalog);
    transparency.reset();
    if (block != nullptr) {
        transparency.emplace(*block, subject.scene.part(kinds::transparency)->parameters);
    }
}

void TransparencyEffect::list(EffectListing& listing, const EffectSet& set) const {
    const EffectSubject* subject = listing.subject();
    if (!isVisiblyTransparent(set) || set.refraction) {
        return;
    }
    if (transparency) {
        listing.add(*transparency, transparencyText);
    } else if (subject == nullptr || countTransparent(subject->scene, subject->catalog) > 0) {
        listing.add(std::string(kinds::transparency), "sorted", transparencyText);
    }
}

void TransparencyEffect::listMissing(LeftOutListing& listing, const EffectSet&) const {
    const auto& [material, scene, catalog, view] = listing.subject();
    if (scene.part(kinds::transparency) && !transparency) {
        listing.add(effectName(kinds::transparency, scene.part(kinds::transparency)->id),
                    countTransparent(scene, catalog) == 0
                        ? "No object is transparent."
                        : "No transparency of this kind is known.");
    }
}

EffectLine TransparencyEffect::absent(const EffectSet& set) const {
    return {std::string(kinds::transparency),
            {},
            set.refraction ? "What is behind the object is seen refracted, in its colour."
                           : "The object is opaque."};
}

void TransparencyEffect::place(ObjectLayout& layout, const EffectSet& set) const {
    if (transparency && isVisiblyTransparent(set) && !set.refraction) {
        layout.transparency = placed(*transparency, layout.vec4s);
        layout.vec4s += 1;
    }
}

/// Writes what a surface adds to a sum of layers. The inspection looks at each surface by itself.
void TransparencyEffect::write(SurfaceText& text) const {
    if (!text.object.transparency || text.isInspected()) {
        return;
    }
    const Block& block = transparency->block();
    text.readFrom("objectData");
    text.addBlock(block);
    text.addUnpack(*transparency, "unpackTransparency");
    text.out.add(fmt::format("#define Transparency {}\n#define layerWeight {}\n"
                             "#define LAYER_RANGE objectData[{}]\n",
                             structName(block), functionName(block), text.object.layers()));
    text.out.addFile("passes/transparency_layer.glsl");
    text.store = fmt::format("storeLayer({{}}, {{}}, unpackTransparency({}))",
                             text.object.transparency->first);
    if (!text.object.isPeeled()) {
        text.out.addFile("passes/transparency_share.glsl");
        text.last += fmt::format("    storedShare = {};\n", text.alpha);
    }
}

void TransparencyEffect::remove(Scene& scene, const EffectName& effect, const Catalog&) {
    if (effect.kind == kinds::transparency && scene.part(kinds::transparency) &&
        scene.part(kinds::transparency)->id == effect.id) {
        scene.setPart(kinds::transparency, std::nullopt);
    }
}

} // namespace patina
