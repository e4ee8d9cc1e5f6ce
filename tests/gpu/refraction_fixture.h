// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "gpu_fixture.h"
#include "render/lights/environment_image.h"

namespace patina {

/// Draws clear bodies in known surroundings, seen by a camera that looks along -z. Tests compute in
/// double precision what the ray of a pixel meets.
class RefractionTest : public GpuTest {
  protected:
    void SetUp() override {
        GpuTest::SetUp();
        makeRenderer();
        scene_.camera.yaw = 0.0;
        scene_.camera.pitch = 0.0;
        scene_.camera.distance = 4.0;
        scene_.background = glm::dvec3(0.25, 0.5, 0.125);
    }

    /// Makes an object that shows only what it transmits and what it mirrors.
    Object clear(const std::string& mesh, const std::string& kind, double index) const {
        Object made = object("lambert", mesh);
        made.material.model.parameters["diffuse.color"] = glm::dvec3(0.0);
        made.material.opacity = 0.0;
        made.material.parts["refraction"] = block("refraction", kind);
        set(made, "index.from", std::string("own"));
        set(made, "index", index);
        return made;
    }

    static void set(Object& object, const std::string& id, const Value& value) {
        object.material.parts.at("refraction").parameters[id] = value;
    }

    /// Makes a square from -1 to 1 that faces the camera and glows.
    Object glowing(const glm::dvec3& color, const glm::dvec3& at) const {
        Object made = object("lambert", "plane");
        made.material.model.parameters["diffuse.color"] = glm::dvec3(0.0);
        made.material.model.parameters["emissive.color"] = color;
        made.rotation.x = 90.0;
        made.translation = at;
        return made;
    }

    /// Returns the light that arrives from a unit direction.
    static glm::dvec3 smooth(const glm::dvec3& d) { return 0.5 + 0.4 * d; }

    /// Makes surroundings that send smooth(), or 1 everywhere.
    void surround(bool isWhite) {
        constexpr int height = 256;
        Image panorama{2 * height, height, 3, {}};
        for (int i = 0; i < 2 * height * height; ++i) {
            const double across = (i % (2 * height) + 0.5) / height * std::numbers::pi;
            const int row = i / (2 * height);
            const double down = (row + 0.5) / height * std::numbers::pi;
            const glm::dvec3 d(-std::sin(down) * std::sin(across), std::cos(down),
                               std::sin(down) * std::cos(across));
            const glm::dvec3 light = isWhite ? glm::dvec3(1.0) : smooth(d);
            for (int c = 0; c < 3; ++c) {
                panorama.pixels.push_back(static_cast<float>(light[c]));
            }
        }
        environment_ = EnvironmentImage::from(panorama);
        scene_.setPart(kinds::environment, block("environment", "image"));
        scene_.part(kinds::environment)->parameters["image"] = std::string("panorama.hdr");
    }

    /// Returns a sphere of radius 1, of so many triangles that their edges hardly matter.
    static const Mesh& ball() {
        static const Mesh made = [] {
            constexpr int rings = 300;
            Mesh mesh;
            for (int i = 0; i <= rings; ++i) {
                for (int j = 0; j <= 2 * rings; ++j) {
                    const double down = std::numbers::pi * i / rings;
                    const double across = std::numbers::pi * j / rings;
                    Vertex vertex{};
                    vertex.position = {std::sin(down) * std::sin(across), std::cos(down),
                                       std::sin(down) * std::cos(across)};
                    vertex.normal = vertex.position;
                    mesh.vertices.push_back(vertex);
                }
            }
            constexpr unsigned row = 2 * rings + 1;
            for (unsigned i = 0; i < rings * row - 1; ++i) {
                mesh.indices.insert(mesh.indices.end(), {i, i + row, i + 1});
                mesh.indices.insert(mesh.indices.end(), {i + 1, i + row, i + row + 1});
            }
            mesh.bounds = boundsOf(mesh.vertices);
            return mesh;
        }();
        return made;
    }

    Image drawn(int size) {
        View view = viewOf(scene_, size);
        view.samples = 1;
        view.environmentImage = environment_;
        view.environmentSamples = scene_.part(kinds::environment) ? 64 : 0;
        const MeshSource source = [this](const Object& wanted) {
            return wanted.mesh == "builtin:ball" ? ball().view() : mesh(wanted);
        };
        auto image = renderer->capture(scene_, view, source, false);
        EXPECT_TRUE(image) << (image ? "" : image.error().text());
        return image ? *image : Image();
    }

    /// Returns the unit direction of the ray through a pixel's centre, or a place beside it.
    glm::dvec3 rayThrough(double x, double y, int size) const {
        const double up = std::tan(0.5 * glm::radians(scene_.camera.fieldOfView));
        const double half = 0.5 * size;
        return glm::normalize(
            glm::dvec3(up * ((x + 0.5) / half - 1.0), up * (1.0 - (y + 0.5) / half), -1.0));
    }

    Scene scene_;
    std::shared_ptr<const EnvironmentImage> environment_;
};

} // namespace patina
