// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "gpu_fixture.h"
#include "render/lights/environment_image.h"

namespace patina {

/// Makes a panorama of one colour.
inline Image plain(float value, glm::ivec2 size = {16, 8}) {
    const std::size_t count = std::size_t(size.x) * std::size_t(size.y);
    return {size.x, size.y, 1, std::vector<float>(count, value)};
}

/// Tells whether a parameter is one to three numbers between two limits.
inline bool hasLimits(const Parameter& parameter) {
    const ParameterTypeInfo& info = infoOf(parameter.type);
    return parameter.type != ParameterType::Enum && info.hasRange && info.components <= 3;
}

/// Returns a value of a parameter with all of its numbers equal to `number`.
inline Value allOf(const Parameter& parameter, double number) {
    if (infoOf(parameter.type).components == 3) {
        return glm::dvec3(number);
    }
    return parameter.type == ParameterType::Int ? Value(static_cast<int>(number)) : Value(number);
}

class EnvironmentTest : public GpuTest {
  protected:
    void SetUp() override {
        GpuTest::SetUp();
        makeRenderer();
    }

    /// Returns a square that faces the camera. It has two triangles: a finer mesh takes far longer
    /// where there are hardly more pixels than triangles.
    static const Mesh& squareMesh() {
        static const Mesh made = [] {
            Mesh mesh;
            for (const glm::vec2 corner : {glm::vec2(-1, -1), {1, -1}, {1, 1}, {-1, 1}}) {
                Vertex vertex{};
                vertex.position = {corner, 0.0f};
                vertex.normal = {0.0f, 0.0f, 1.0f};
                vertex.tangent = {1.0f, 0.0f, 0.0f, 1.0f};
                mesh.vertices.push_back(vertex);
            }
            mesh.indices = {0, 1, 2, 0, 2, 3};
            mesh.bounds = boundsOf(mesh.vertices);
            return mesh;
        }();
        return made;
    }

    MeshSource squares() {
        return [this](const Object& wanted) {
            return wanted.mesh == "square" ? squareMesh().view() : mesh(wanted);
        };
    }

    Scene square(const std::string& model) const {
        Scene scene = simpleScene(model);
        scene.objects[0].mesh = "square";
        scene.lights.clear();
        return scene;
    }

    /// Makes a scene with the square in a panorama that is not seen behind it.
    Scene surrounded(const std::string& model, const Image& panorama) {
        image_ = EnvironmentImage::from(panorama);
        Scene scene = square(model);
        scene.setPart(kinds::environment, block("environment", "image"));
        scene.part(kinds::environment)->parameters["image"] = std::string("panorama.hdr");
        scene.part(kinds::environment)->parameters["background"] = std::string("hidden");
        return scene;
    }

    Scene inTheStudio(const std::string& model) {
        Scene scene = square(model);
        scene.setPart(kinds::environment, block("environment", "studio"));
        return scene;
    }

    View viewWith(const Scene& scene, int samples) const {
        View view = viewOf(scene, size_);
        view.environmentImage = image_;
        view.environmentSamples = samples;
        return view;
    }

    Image settled(const Scene& scene, int samples) {
        auto image = renderer->capture(scene, viewWith(scene, samples), squares(), false);
        EXPECT_TRUE(image) << (image ? "" : image.error().text());
        return image ? *image : Image();
    }

    int size_ = 33;
    std::shared_ptr<const EnvironmentImage> image_;
};

/// Makes a matte model reflect everything.
inline void makeWhite(Scene& scene) {
    for (auto& [id, value] : scene.objects[0].material.model.parameters) {
        if (id == "diffuse.color") {
            value = glm::dvec3(1.0);
        }
    }
}

} // namespace patina
