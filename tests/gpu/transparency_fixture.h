// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>

#include "gpu_fixture.h"
#include "render/lights/frustum.h"

namespace patina {

/// Says where a ray through a pixel meets a glowing sheet.
struct Crossing {
    double depth = 0.0; ///< is the distance along the view
    glm::dvec3 color{0.0};
    double opacity = 0.0;
};

/// Draws glowing sheets behind each other, seen by a camera that looks along -z, and computes their
/// pixels on the CPU in double precision.
class TransparencyTest : public GpuTest {
  protected:
    void SetUp() override {
        GpuTest::SetUp();
        makeRenderer();
        scene_.camera.yaw = 0.0;
        scene_.camera.pitch = 0.0;
        scene_.background = glm::dvec3(0.25, 0.5, 0.125);
    }

    Object sheet(const glm::dvec3& color, double opacity, double z) const {
        Object made = object("lambert", "plane");
        made.material.model.parameters["diffuse.color"] = glm::dvec3(0.0);
        made.material.model.parameters["emissive.color"] = color;
        made.material.opacity = opacity;
        made.rotation.x = 90.0;
        made.translation.z = z;
        return made;
    }

    void choose(const std::string& id) {
        scene_.setPart(kinds::transparency, block("transparency", id));
    }

    /// Adds sheets at random places, turned so that many of them cross.
    void addRandomSheets(int count, unsigned seed, double maxTurn = 50.0) {
        std::mt19937 random(seed);
        std::uniform_real_distribution<double> share(0.0, 1.0);
        for (int i = 0; i < count; ++i) {
            const glm::dvec3 color(share(random), share(random), share(random));
            Object made = sheet(color, 0.15 + 0.6 * share(random), share(random) - 0.5);
            made.rotation.x += maxTurn * (2.0 * share(random) - 1.0);
            made.rotation.y = maxTurn * (2.0 * share(random) - 1.0);
            made.scale = glm::dvec3(0.5 + share(random));
            scene_.objects.push_back(made);
        }
    }

    /// Finds what the ray of a pixel meets, from the nearest on. Returns false where an edge, or
    /// two sheets, are so near that rounding decides.
    bool crossings(glm::ivec2 pixel, int size, std::vector<Crossing>& out) const {
        const glm::dvec3 origin = eye(scene_.camera);
        const double up = std::tan(0.5 * glm::radians(scene_.camera.fieldOfView));
        const glm::dvec2 place = 2.0 * (glm::dvec2(pixel) + 0.5) / double(size) - 1.0;
        const glm::dvec3 way(up * place.x, -up * place.y, -1.0);
        out.clear();
        bool isClear = true;
        for (const Object& object : scene_.objects) {
            const glm::dmat4 inverse = glm::inverse(worldMatrix(object));
            const glm::dvec3 from(inverse * glm::dvec4(origin, 1.0));
            const glm::dvec3 along(inverse * glm::dvec4(way, 0.0));
            const double depth = -from.y / along.y;
            const glm::dvec3 hit = from + depth * along;
            const double beyond = std::max(std::abs(hit.x), std::abs(hit.z)) - 1.0;
            isClear = isClear && std::abs(beyond) > 1e-3 && std::abs(along.y) > 1e-3;
            if (beyond < 0.0 && depth > 0.0) {
                const auto& color =
                    std::get<glm::dvec3>(object.material.model.parameters.at("emissive.color"));
                out.push_back({depth, color, object.material.opacity});
            }
        }
        std::ranges::sort(out, {}, &Crossing::depth);
        for (std::size_t i = 1; i < out.size(); ++i) {
            isClear = isClear && out[i].depth - out[i - 1].depth > 1e-4;
        }
        return isClear;
    }

    /// Returns the light of the nearest `layers` crossings, each over what is behind it.
    glm::dvec3 inOrder(const std::vector<Crossing>& crossings, std::size_t layers) const {
        glm::dvec3 light(0.0);
        double left = 1.0;
        for (std::size_t i = 0; i < std::min(layers, crossings.size()); ++i) {
            light += left * crossings[i].opacity * crossings[i].color;
            left *= 1.0 - crossings[i].opacity;
        }
        return light + left * scene_.background;
    }

    Image drawn(int size, int samples = 1) {
        View view = viewOf(scene_, size);
        view.samples = samples;
        auto image = renderer->capture(scene_, view, meshSource(), false);
        EXPECT_TRUE(image) << (image ? "" : image.error().text());
        return image ? *image : Image();
    }

    Scene scene_;
};

} // namespace patina
