// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/pass/shadow_layers.h"

#include <algorithm>

namespace patina {
namespace {

std::size_t countFaces(std::span<const ShadowView> views) {
    std::size_t faces = 0;
    for (const ShadowView& view : views) {
        faces += static_cast<std::size_t>(view.faces);
    }
    return faces;
}

} // namespace

bool ShadowLayers::plan(std::span<const ShadowView> views, bool allAnew) {
    const std::size_t needed = countFaces(views);
    bool isAnother = allAnew || layers_.size() != needed;
    layers_.resize(needed);
    for (const ShadowView& view : views) {
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

bool ShadowLayers::areOf(std::span<const ShadowView> views) const {
    std::size_t same = 0;
    for (const ShadowView& view : views) {
        for (int face = 0; face < view.faces; ++face) {
            const auto layer = static_cast<std::size_t>(view.layer + face);
            if (layer >= layers_.size() || layers_[layer].view != view ||
                layers_[layer].face != face) {
                return false;
            }
            ++same;
        }
    }
    return same == layers_.size();
}

int ShadowLayers::pending() const {
    return static_cast<int>(std::ranges::count(layers_, false, &Layer::isDrawn));
}

} // namespace patina
