// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "gpu_fixture.h"

namespace patina {

/// Is the tolerance of a texel's value; the target's half floats add up to one step of rounding.
inline constexpr float texelTolerance = 1e-4f;
inline constexpr float halfFloatStep = 1.0f / 1024.0f;

/// Is what white Lambert sends; dividing by it rounds nothing.
inline constexpr float brightness = 0.125f;

/// Draws a quad that fills the view, seen and lit from the front; u runs to the right, v up.
class TextureTest : public GpuTest {
  protected:
    void SetUp() override {
        GpuTest::SetUp();
        makeRenderer();
        renderer->setTextures([this](const TextureUse& use, TextureDecoding decoding) {
            asked.push_back(decoding);
            if (use.file == "missing") {
                return TextureLookup{nullptr, true};
            }
            const auto found = files.find(use.file);
            if (found == files.end()) {
                return TextureLookup{};
            }
            auto& made = pictures[{use.file, decoding}];
            if (!made) {
                made = std::make_shared<const TexturePicture>(
                    madeTexture(found->second, decoding));
            }
            return TextureLookup{made, false};
        });
        scene = simpleScene("lambert");
        scene.lights.front().block.parameters["intensity"] = double(brightness);
        scene.objects.front().mesh = "quad";
        color(glm::dvec3(0.5));
        // It is as high and wide as the view: 2 at distance 1 and 90 degrees.
        scene.camera.distance = 1.0;
        scene.camera.fieldOfView = 90.0;
    }

    void color(const glm::dvec3& value) {
        scene.objects.front().material.model.parameters["diffuse.color"] = value;
    }

    /// Adds a file; `texels` are rows from the top.
    void file(const std::string& name, glm::ivec2 size, int channels, std::vector<float> texels,
              int bits = 0) {
        files[name] = {{size.x, size.y, channels, std::move(texels)}, bits};
    }

    TextureUse& use(const std::string& key, const std::string& name) {
        TextureUse& made = scene.objects.front().material.textures[key];
        made = textureUse(key, name);
        made.filter = TextureFilter::Nearest;
        return made;
    }

    Image drawn(int size = 16) {
        auto image = renderer->capture(
            scene, viewOf(scene, size), [this](const Object&) { return quad(); }, false);
        EXPECT_TRUE(image) << (image ? "" : image.error().text());
        return image ? *image : Image();
    }

    /// Returns what the surface shows at (u, v), as a share of the light.
    glm::vec3 at(const Image& image, double u, double v) {
        return pixel(image, int(u * image.width), int((1.0 - v) * image.height)) / brightness;
    }

    MeshView quad() {
        if (mesh_.indices.empty()) {
            for (const glm::vec2 corner : {glm::vec2(0, 0), glm::vec2(1, 0), glm::vec2(1, 1),
                                           glm::vec2(0, 1)}) {
                mesh_.vertices.push_back({glm::vec3(2.0f * corner - 1.0f, 0.0f),
                                          {0, 0, 1},
                                          {1, 0, 0, 1},
                                          corner});
            }
            mesh_.indices = {0, 1, 2, 0, 2, 3};
            mesh_.bounds = boundsOf(mesh_.vertices);
        }
        return mesh_.view();
    }

    Scene scene;
    std::map<std::string, FileImage> files;
    std::map<std::pair<std::string, TextureDecoding>, std::shared_ptr<const TexturePicture>>
        pictures;
    std::vector<TextureDecoding> asked;

  private:
    Mesh mesh_;
};

inline void expectNear(const glm::vec3& shown, const glm::vec3& expected) {
    for (int i = 0; i < 3; ++i) {
        EXPECT_NEAR(shown[i], expected[i], texelTolerance + halfFloatStep * expected[i]) << i;
    }
}

} // namespace patina
