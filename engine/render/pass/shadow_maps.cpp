// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/pass/shadow_maps.h"

#include <epoxy/gl.h>

#include "render/gpu/binding.h"

namespace patina {
namespace {

/// The maps are kept for this many plans without shadows in a row, since another view may use them.
constexpr int plansKept = 64;

} // namespace

void ShadowMaps::setCatalog(std::shared_ptr<const Catalog> catalog) {
    catalog_ = std::move(catalog);
    casters_.setCatalog(catalog_);
    drawer_.forget();
    layers_.forget();
}

void ShadowMaps::clearCasters() {
    casters_.clear();
    layers_.clearViews();
}

Result<void> ShadowMaps::plan(const Scene& scene, const Scene& effects,
                              const glm::dmat4& cameraToWorld, ProgramCache& programs,
                              const GpuTextureStore& textures) {
    ++planNumber_;
    hasNewImages_ = false;
    isAnother_ = false;
    const int texels =
        layers_.place({scene, effects, *catalog_, cameraToWorld, casters_.boxes()}, maxTexels_);
    if (layers_.needed() == 0) {
        if (++unneeded_ > plansKept) {
            layers_.forget();
            texture_ = gl::TextureArray();
        }
        return {};
    }
    unneeded_ = 0;
    if (Result<void> made = prepare(programs, textures, texels); !made) {
        layers_.clearViews();
        layers_.forget();
        return made;
    }
    const bool allAnew = casters_.hasChanged();
    isAnother_ = layers_.plan(allAnew) || hasNewImages_;
    if (isAnother_) {
        drawer_.restart();
    }
    if (allAnew) {
        casters_.noteDrawn();
    }
    return {};
}

Result<void> ShadowMaps::prepare(ProgramCache& programs, const GpuTextureStore& textures,
                                 int texels) {
    Result<void> made = drawer_.prepare(*catalog_, programs);
    if (made) {
        made = casters_.prepare(programs, textures);
    }
    return made ? makeTexture(texels, layers_.needed()) : made;
}

Result<void> ShadowMaps::makeTexture(int texels, int layers) {
    if (texture_.size().x == texels && texture_.layers() == layers) {
        return {};
    }
    layers_.forget();
    texture_ = gl::TextureArray();
    while (glGetError() != GL_NO_ERROR) {
    }
    texture_ = gl::TextureArray::create(glm::ivec2(texels), layers, GL_DEPTH_COMPONENT32F);
    if (glGetError() == GL_OUT_OF_MEMORY) {
        texture_ = gl::TextureArray();
        return failure("there is not enough graphics memory for the shadows");
    }
    hasNewImages_ = true;
    return drawer_.check(texture_);
}

void ShadowMaps::drawSome(int triangles, FrameTextures& textures) {
    drawer_.drawSome({texture_, layers_.layers(), casters_, textures}, triangles);
}

void ShadowMaps::bind() const {
    if (texture_.name() != 0) {
        glActiveTexture(GL_TEXTURE0 + binding::shadowMaps);
        glBindTexture(GL_TEXTURE_2D_ARRAY, texture_.name());
        glActiveTexture(GL_TEXTURE0);
    }
}

} // namespace patina
