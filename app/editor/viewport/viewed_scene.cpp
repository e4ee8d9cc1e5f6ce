// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/viewed_scene.h"

#include <algorithm>
#include <utility>

#include <QWidget>

#include "scene/environment.h"
#include "shading/effects/environment_effect.h"

namespace patina {

ViewedScene::ViewedScene(Sources sources, const QWidget& widget)
    : sources_(std::move(sources)), widget_(widget) {}

View ViewedScene::view() const {
    View view;
    view.size = pixelsOf(widget_, widget_.size());
    view.camera = camera_;
    view.pixelRatio = widget_.devicePixelRatioF();
    view.effects = sources_.effects ? sources_.effects() : nullptr;
    view.environmentImage = sources_.environment ? sources_.environment() : nullptr;
    view.maxSamples = wantedSamples();
    return view;
}

int ViewedScene::wantedSamples() const {
    const Scene& scene = sources_.scene();
    const BlockValues* environment = scene.part(kinds::environment);
    const Block* block =
        catalog_ == nullptr ? nullptr : blockOf(scene.parts, kinds::environment, *catalog_);
    return block == nullptr ? usualDirections : directionsOf(*environment, *block);
}

bool ViewedScene::fitsWhileMoving() const {
    const Scene* effects = sources_.effects ? sources_.effects() : nullptr;
    return catalog_ != nullptr &&
           patina::fitsWhileMoving(effects != nullptr ? *effects : sources_.scene(), *catalog_);
}

glm::ivec2 pixelsOf(const QWidget& widget, const QSize& size) {
    const QSize pixels = size * widget.devicePixelRatioF();
    return {std::max(pixels.width(), 1), std::max(pixels.height(), 1)};
}

} // namespace patina
