// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/viewed_scene.h"

#include <algorithm>
#include <utility>

#include <QWidget>

#include "scene/environment.h"
#include "viewport/program_worker.h"

namespace patina {

ViewedScene::ViewedScene(Sources sources, const QWidget& widget)
    : sources_(std::move(sources)), widget_(widget) {}

View ViewedScene::view() const {
    View view;
    view.size = pixelsOf(widget_, widget_.size());
    view.camera = camera_;
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

quint64 ViewedScene::askForPrograms(const Scene& scene, const View& view) const {
    ProgramWorker::Frame frame{scene, {}, view, {}, 0, catalog_};
    if (view.effects) {
        frame.effects = *view.effects;
    }
    frame.view.effects = nullptr;
    frame.view.environmentImage = nullptr;
    for (const Object& object : scene.objects) {
        const MeshView mesh = object.visible ? sources_.meshes(object) : MeshView();
        frame.meshes.push_back(mesh.indices.empty() ? Bounds() : mesh.bounds);
        frame.triangles += std::ssize(mesh.indices) / 3;
    }
    return sources_.programs->ask(std::move(frame));
}

glm::ivec2 pixelsOf(const QWidget& widget, const QSize& size) {
    const QSize pixels = size * widget.devicePixelRatioF();
    return {std::max(pixels.width(), 1), std::max(pixels.height(), 1)};
}

} // namespace patina
