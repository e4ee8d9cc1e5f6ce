// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <chrono>
#include <filesystem>
#include <map>
#include <memory>
#include <string>

#include <gtest/gtest.h>

#include "catalog/catalog.h"
#include "gl/debug_output.h"
#include "gl/headless_context.h"
#include "render/frame/frame_job.h"
#include "render/renderer.h"
#include "scene/primitives.h"

namespace patina {

/// Provides a context for the test, the shipped catalogue and a small scene. The driver must not
/// report anything.
class GpuTest : public testing::Test {
  protected:
    void SetUp() override {
        gl::HeadlessContext::Options options;
        options.debug = true;
        auto made = gl::HeadlessContext::create(options);
        ASSERT_TRUE(made) << made.error().text();
        context = std::move(*made);
        debug = std::make_unique<gl::DebugOutput>();
        ASSERT_TRUE(debug->available());
        catalog = shippedCatalog();
        ASSERT_TRUE(catalog->errors.empty()) << text(catalog->errors);
    }

    void TearDown() override {
        renderer.reset();
        if (debug != nullptr) {
            EXPECT_EQ(debug->messages(), std::vector<std::string>());
        }
        debug.reset();
        context.reset();
    }

    static std::shared_ptr<const Catalog> shippedCatalog() {
        static const auto loaded = std::make_shared<const Catalog>(
            loadCatalog(std::array{BlockRoot{PATINA_SOURCE_DIR "/shaders", true}}));
        return loaded;
    }

    void makeRenderer(const std::filesystem::path& programCache = {}) {
        makeRenderer(Renderer::Options{.programCache = programCache});
    }

    void makeRenderer(const Renderer::Options& options) {
        auto made = Renderer::create(options);
        ASSERT_TRUE(made) << made.error().text();
        renderer = std::move(*made);
        renderer->setCatalog(catalog);
    }

    Values defaults(const std::string& kind, const std::string& id) const {
        const Block* block = catalog->find(kind, id);
        EXPECT_NE(block, nullptr) << kind << '/' << id;
        return block == nullptr ? Values() : defaultValues(*block);
    }

    BlockValues block(const std::string& kind, const std::string& id) const {
        BlockValues made;
        made.id = id;
        made.parameters = defaults(kind, id);
        return made;
    }

    Light light(const std::string& kindOfLight) const {
        Light made;
        made.block = block("lights", kindOfLight);
        return made;
    }

    /// Makes a white light that shines along `direction`.
    Light sun(const glm::dvec3& direction) const {
        Light made = light("directional");
        made.block.parameters["direction"] = direction;
        return made;
    }

    Object object(const std::string& model, const std::string& mesh = "sphere") const {
        Object made;
        made.mesh = "builtin:" + mesh;
        made.material.model = block("models", model);
        return made;
    }

    /// Makes a scene of one object in front of a camera that looks along -z, lit from behind the
    /// camera.
    Scene simpleScene(const std::string& model = "lambert") const {
        Scene scene;
        scene.objects.push_back(object(model));
        scene.lights.push_back(sun({0.0, 0.0, -1.0}));
        scene.camera.yaw = 0.0;
        scene.camera.pitch = 0.0;
        scene.background = glm::dvec3(0.25);
        return scene;
    }

    /// Makes the simple scene with a white matte plate that faces the camera and the light.
    Scene plate() const {
        Scene scene = simpleScene("lambert");
        scene.objects[0].mesh = "builtin:plane";
        scene.objects[0].rotation = {90.0, 0.0, 0.0};
        scene.objects[0].material.model.parameters["diffuse.color"] = glm::dvec3(1.0);
        return scene;
    }

    static View viewOf(const Scene& scene, int size = 33) {
        View view;
        view.size = {size, size};
        view.camera = scene.camera;
        return view;
    }

    MeshView mesh(const Object& wanted) {
        const std::string name = wanted.mesh.substr(wanted.mesh.find(':') + 1);
        auto found = meshes.find(name);
        if (found == meshes.end()) {
            auto made = primitive(name);
            if (!made) {
                return {};
            }
            found = meshes.emplace(name, std::move(*made)).first;
        }
        MeshView view = found->second.view();
        view.openness = openness[name];
        return view;
    }

    MeshSource meshSource() {
        return [this](const Object& wanted) { return mesh(wanted); };
    }

    Image capture(const Scene& scene, bool display = false, int size = 33) {
        auto image = renderer->capture(scene, viewOf(scene, size), meshSource(), display);
        EXPECT_TRUE(image) << (image ? "" : image.error().text());
        return image ? *image : Image();
    }

    /// Draws as a window does, and shows the frame when it is done. Returns false where more steps
    /// are needed.
    bool drawInWindow(const Scene& scene, const View& view, const MeshSource& source,
                      unsigned framebuffer) {
        constexpr std::chrono::milliseconds patience{40};
        FrameJob& job = renderer->begin(scene, view, source, FramePurpose::Window);
        const bool isDone = proceed(patience);
        if (isDone) {
            job.show(framebuffer);
        }
        return isDone;
    }

    bool proceed(std::chrono::milliseconds patience) {
        return renderer->job().step(patience) == FrameJob::Progress::Done;
    }

    /// Returns whether a program had to be made.
    bool prewarm(const Scene& scene, const View& view, const MeshSource& source) {
        FrameJob& job = renderer->begin(scene, view, source, FramePurpose::Prewarm);
        const bool isMissing = job.missingPrograms() != 0;
        job.step(FrameJob::never);
        return isMissing;
    }

    static glm::vec3 pixel(const Image& image, int x, int y) {
        const std::size_t at = (std::size_t(y) * std::size_t(image.width) + std::size_t(x)) *
                               std::size_t(image.channels);
        return {image.pixels.at(at), image.pixels.at(at + 1), image.pixels.at(at + 2)};
    }

    static glm::vec3 middle(const Image& image) {
        return pixel(image, image.width / 2, image.height / 2);
    }

    std::unique_ptr<gl::HeadlessContext> context;
    std::unique_ptr<gl::DebugOutput> debug;
    std::shared_ptr<const Catalog> catalog;
    std::unique_ptr<Renderer> renderer;
    std::map<std::string, Mesh> meshes;
    /// Holds what tests set, by the name of the mesh; other meshes hide nothing.
    std::map<std::string, std::vector<VertexOpenness>> openness;
};

} // namespace patina
