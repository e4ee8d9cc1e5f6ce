// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <map>
#include <memory>
#include <string>

#include <epoxy/gl.h>

#include "catalog/catalog.h"
#include "gl/framebuffer.h"
#include "gl/headless_context.h"
#include "render/renderer.h"
#include "scene/primitives.h"
#include "scene/scene_file.h"
#include "support/program.h"

namespace patina::benchmarks {

inline double wallSeconds() {
    using Clock = std::chrono::steady_clock;
    return std::chrono::duration<double>(Clock::now().time_since_epoch()).count();
}

/// Holds the scene of three lights with one sphere, a renderer without programs on disk, and a
/// target.
class Stage {
  public:
    explicit Stage(glm::ivec2 size)
        : context_(gl::HeadlessContext::create().value()),
          catalog_(std::make_shared<const Catalog>(loadCatalog(standardBlockRoots()))),
          renderer_(Renderer::create({.programCache = folder_.path()}).value()) {
        const auto file = dataFolder() / "presets" / "three-lights.patina-scene.json";
        scene = readScene(file, *catalog_).value().scene;
        scene.objects.resize(1);
        scene.objects.front().mesh = "sphere";
        view.size = size;
        view.camera = scene.camera;
        meshes["sphere"] = primitive("sphere").value();
        renderer_->setCatalog(catalog_);
        color_ = gl::Renderbuffer::create(size, GL_RGBA8, 0);
        target_ = gl::Framebuffer::create();
        target_.attachColor(color_);
    }

    const Catalog& catalog() const { return *catalog_; }
    const std::shared_ptr<const Catalog>& sharedCatalog() const { return catalog_; }

    void use(const char* model) {
        Material& material = scene.objects.front().material;
        material = withModel(material, nullptr, *catalog_->find("models", model));
    }

    void set(const char* parameter, double value) {
        std::get<double>(scene.objects.front().material.model.parameters[parameter]) = value;
    }

    const FrameReport& draw() { return draw(scene); }

    const FrameReport& draw(const Scene& another) {
        return renderer_->draw(
            another, view, [this](const Object& object) { return meshes.at(object.mesh).view(); },
            target_.name());
    }

    /// Returns the wall time of a frame until the GPU has finished it, in seconds.
    double frameSeconds() { return frameSeconds(scene); }

    double frameSeconds(const Scene& another) {
        const double began = wallSeconds();
        draw(another);
        glFinish();
        return wallSeconds() - began;
    }

    /// Makes another renderer in the same context.
    static std::unique_ptr<Renderer> rendererOf(std::shared_ptr<const Catalog> catalog) {
        std::unique_ptr<Renderer> made = Renderer::create({}).value();
        made->setCatalog(std::move(catalog));
        return made;
    }

    const FrameReport& drawWith(Renderer& renderer) {
        return renderer.draw(
            scene, view, [this](const Object& object) { return meshes.at(object.mesh).view(); },
            target_.name());
    }

    Scene scene;
    View view;
    std::map<std::string, Mesh> meshes; ///< holds meshes by the names that objects use

  private:
    tests::TemporaryFolder folder_;
    std::unique_ptr<gl::HeadlessContext> context_;
    std::shared_ptr<const Catalog> catalog_;
    std::unique_ptr<Renderer> renderer_;
    gl::Renderbuffer color_;
    gl::Framebuffer target_;
};

} // namespace patina::benchmarks
