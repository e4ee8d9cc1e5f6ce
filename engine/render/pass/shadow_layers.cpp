// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/pass/shadow_layers.h"

#include <algorithm>
#include <cstdint>

#include <epoxy/gl.h>

#include "shading/effects/lights.h"
#include "shading/effects/shadows.h"

namespace patina {
namespace {

constexpr int minTexels = 256;
constexpr std::int64_t maxBytes = std::int64_t(256) << 20;

int maxLayers() {
    GLint maxCount = 0;
    glGetIntegerv(GL_MAX_ARRAY_TEXTURE_LAYERS, &maxCount);
    return std::min(maxCount,
                    static_cast<int>(maxBytes / (std::int64_t(4) * minTexels * minTexels)));
}

const Block* shadowedLight(const Light& light, const Catalog& catalog) {
    const Block* block = catalog.find(kinds::lights, light.block.id);
    const bool shines = block != nullptr && canShine(light, *block);
    return shines && shadowBlock(light, *block, catalog) != nullptr ? block : nullptr;
}

/// Halves the texels per side until all layers fit into maxBytes, but not below minTexels.
int texelsFor(int layers, int maxTexels) {
    int texels = maxTexels;
    while (texels > minTexels && std::int64_t(4) * texels * texels * layers > maxBytes) {
        texels /= 2;
    }
    return texels;
}

} // namespace

int ShadowLayers::place(const ShadowedScene& shown, int maxTexels) {
    makeViews(shown, maxTexels);
    placeFaces();
    const int texels = texelsFor(needed(), maxTexels);
    if (texels != maxTexels) {
        makeViews(shown, texels);
        placeFaces();
    }
    return texels;
}

void ShadowLayers::makeViews(const ShadowedScene& shown, int texels) {
    views_.assign(shown.scene.lights.size(), ShadowView());
    if (shown.casters.empty() || !hasShadows(shown.effects, shown.catalog)) {
        return;
    }
    for (std::size_t i = 0; i < views_.size(); ++i) {
        if (const Block* light = shadowedLight(shown.effects.lights[i], shown.catalog)) {
            views_[i] = shadowViewOf(*light, shown.scene.lights[i].block.parameters,
                                     shown.cameraToWorld, shown.casters, texels);
        }
    }
}

int ShadowLayers::needed() const {
    int layers = 0;
    for (const ShadowView& view : views_) {
        layers += view.faces;
    }
    return layers;
}

/// Gives the views consecutive layers; a light that does not fit has no map.
void ShadowLayers::placeFaces() {
    const int maxCount = maxLayers();
    int next = 0;
    lost_ = 0;
    for (ShadowView& view : views_) {
        if (next + view.faces > maxCount) {
            view = ShadowView();
            ++lost_;
            continue;
        }
        view.layer = next;
        next += view.faces;
    }
}

bool ShadowLayers::plan(bool allAnew) {
    bool isAnother = allAnew || std::ssize(layers_) != needed();
    layers_.resize(static_cast<std::size_t>(needed()));
    for (const ShadowView& view : views_) {
        for (int face = 0; face < view.faces; ++face) {
            Layer& layer = layers_[static_cast<std::size_t>(view.layer + face)];
            const bool isSame = layer.view == view && layer.face == face;
            isAnother = isAnother || !isSame;
            layer.isDrawn = layer.isDrawn && !allAnew && isSame;
            layer.view = view;
            layer.face = face;
        }
    }
    return isAnother;
}

int ShadowLayers::pending() const {
    return static_cast<int>(std::ranges::count(layers_, false, &Layer::isDrawn));
}

} // namespace patina
