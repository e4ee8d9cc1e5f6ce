// SPDX-License-Identifier: GPL-3.0-or-later
#include "stage_pictures.h"

#include <cstdint>
#include <vector>

#include <epoxy/gl.h>
#include <glm/gtc/constants.hpp>
#include <glm/trigonometric.hpp>

#include "render/gpu/binding.h"

namespace patina::benchmarks {
namespace {

constexpr int imageSize = 64;
constexpr int mapSize = 1024;

std::uint8_t wave(int i, double phase) {
    const double turn = glm::two_pi<double>() * i / imageSize;
    return static_cast<std::uint8_t>(160.0 + 60.0 * glm::sin(turn + phase));
}

/// Smooth and without an edge, with alpha on both sides of one half; as a normal map it slopes.
gl::Texture makeImage() {
    std::vector<std::uint8_t> texels;
    for (int row = 0; row < imageSize; ++row) {
        for (int column = 0; column < imageSize; ++column) {
            texels.insert(texels.end(), {wave(column, 0.0), wave(row, 1.0), 220, wave(row, 4.0)});
        }
    }
    gl::Texture image = gl::Texture::create({imageSize, imageSize}, GL_RGBA8, GL_RGBA,
                                            GL_UNSIGNED_BYTE, texels.data());
    for (const unsigned filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER}) {
        glTexParameteri(GL_TEXTURE_2D, filter, GL_LINEAR);
    }
    for (const unsigned wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T}) {
        glTexParameteri(GL_TEXTURE_2D, wrap, GL_REPEAT);
    }
    return image;
}

gl::TextureArray makeDepths() {
    gl::TextureArray depths =
        gl::TextureArray::create({mapSize, mapSize}, 1, GL_DEPTH_COMPONENT32F);
    std::vector<float> texels(std::size_t(mapSize) * mapSize, 1.0f);
    std::fill_n(texels.begin(), texels.size() / 2, 0.0f);
    glBindTexture(GL_TEXTURE_2D_ARRAY, depths.name());
    glTexSubImage3D(GL_TEXTURE_2D_ARRAY, 0, 0, 0, 0, mapSize, mapSize, 1, GL_DEPTH_COMPONENT,
                    GL_FLOAT, texels.data());
    return depths;
}

} // namespace

StagePictures::StagePictures() : image_(makeImage()), depths_(makeDepths()) {}

void StagePictures::bind() const {
    glActiveTexture(GL_TEXTURE0 + binding::firstTexture);
    glBindTexture(GL_TEXTURE_2D, image_.name());
    glActiveTexture(GL_TEXTURE0 + binding::shadowMaps);
    glBindTexture(GL_TEXTURE_2D_ARRAY, depths_.name());
    glActiveTexture(GL_TEXTURE0);
}

ShadowView StagePictures::shadowView(const Catalog& catalog, const Light& light,
                                     const glm::dmat4& cameraToWorld) const {
    const std::vector<CasterBox> ball{{{glm::vec3(-1.0f), glm::vec3(1.0f)}, glm::dmat4(1.0)}};
    return shadowViewOf(*catalog.find("lights", light.block.id), light.block.parameters,
                        cameraToWorld, ball, mapSize);
}

} // namespace patina::benchmarks
