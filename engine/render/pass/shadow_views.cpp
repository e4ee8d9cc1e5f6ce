// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/pass/shadow_views.h"

#include <algorithm>

#include <epoxy/gl.h>

#include "shading/effects/lights.h"
#include "shading/effects/shadows.h"

namespace patina {
namespace {

constexpr int minTexels = 256;

std::int64_t bytesOf(int layers, int texels) {
    return std::int64_t(4) * texels * texels * layers;
}

int maxLayers(std::int64_t maxBytes) {
    GLint maxCount = 0;
    glGetIntegerv(GL_MAX_ARRAY_TEXTURE_LAYERS, &maxCount);
    return std::min(maxCount, static_cast<int>(maxBytes / bytesOf(1, minTexels)));
}

const Block* shadowedLight(const Light& light, const Catalog& catalog) {
    const Block* block = catalog.find(kinds::lights, light.block.id);
    const bool shines = block != nullptr && canShine(light, *block);
    return shines && shadowBlock(light, *block, catalog) != nullptr ? block : nullptr;
}

/// Halves the texels per side until all layers fit, but not below minTexels.
int texelsFor(int layers, const ShadowLimits& limits) {
    int texels = limits.texels;
    while (texels > minTexels && bytesOf(layers, texels) > limits.bytes) {
        texels /= 2;
    }
    return texels;
}

} // namespace

void ShadowViews::place(const ShadowedScene& shown, const ShadowLimits& limits) {
    texels_ = limits.texels;
    makeViews(shown);
    placeFaces(limits.bytes);
    const int texels = texelsFor(layers(), limits);
    if (texels != texels_) {
        texels_ = texels;
        makeViews(shown);
        placeFaces(limits.bytes);
    }
}

void ShadowViews::makeViews(const ShadowedScene& shown) {
    views_.assign(shown.scene.lights.size(), ShadowView());
    if (shown.casters.empty() || !hasShadows(shown.effects, shown.catalog)) {
        return;
    }
    for (std::size_t i = 0; i < views_.size(); ++i) {
        if (const Block* light = shadowedLight(shown.effects.lights[i], shown.catalog)) {
            views_[i] = shadowViewOf(*light, shown.scene.lights[i].block.parameters,
                                     shown.cameraToWorld, shown.casters, texels_);
        }
    }
}

int ShadowViews::layers() const {
    int layers = 0;
    for (const ShadowView& view : views_) {
        layers += view.faces;
    }
    return layers;
}

std::int64_t ShadowViews::bytes() const {
    return bytesOf(layers(), texels_);
}

/// Gives the views consecutive layers; a light that does not fit has no map.
void ShadowViews::placeFaces(std::int64_t maxBytes) {
    const int maxCount = maxLayers(maxBytes);
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

} // namespace patina
