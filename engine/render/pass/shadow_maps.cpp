// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/pass/shadow_maps.h"

#include <epoxy/gl.h>

#include "render/gpu/binding.h"

namespace patina {

bool ShadowMaps::areOf(const ShadowWish& wish) const {
    return haveSizeOf(wish.views) && layers_.areOf(wish.views.all()) &&
           casters_ == wish.casters.record();
}

bool ShadowMaps::haveSizeOf(const ShadowViews& views) const {
    return texture_.size().x == views.texels() && texture_.layers() == views.layers();
}

Result<bool> ShadowMaps::plan(const ShadowWish& wish) {
    if (auto prepared = drawer_.prepare(wish.catalog, wish.programs); !prepared) {
        return tl::unexpected(prepared.error());
    }
    const Result<bool> made = makeTexture(wish.views);
    if (!made) {
        return made;
    }
    const bool allAnew = *made || casters_ != wish.casters.record();
    if (layers_.plan(wish.views.all(), allAnew)) {
        drawer_.restart();
    }
    if (allAnew) {
        casters_ = wish.casters.record();
    }
    return made;
}

Result<bool> ShadowMaps::makeTexture(const ShadowViews& views) {
    if (haveSizeOf(views)) {
        return false;
    }
    release();
    while (glGetError() != GL_NO_ERROR) {
    }
    texture_ =
        gl::TextureArray::create(glm::ivec2(views.texels()), views.layers(), GL_DEPTH_COMPONENT32F);
    if (glGetError() == GL_OUT_OF_MEMORY) {
        release();
        return failure("there is not enough graphics memory for the shadows");
    }
    if (auto checked = drawer_.check(texture_); !checked) {
        release();
        return tl::unexpected(checked.error());
    }
    return true;
}

void ShadowMaps::release() {
    texture_ = gl::TextureArray();
}

void ShadowMaps::drawSome(int triangles, ShadowCasters& casters, FrameTextures& textures) {
    drawer_.drawSome({texture_, layers_.layers(), casters, textures}, triangles);
}

void ShadowMaps::bind() const {
    if (!areReleased()) {
        glActiveTexture(GL_TEXTURE0 + binding::shadowMaps);
        glBindTexture(GL_TEXTURE_2D_ARRAY, texture_.name());
        glActiveTexture(GL_TEXTURE0);
    }
}

std::int64_t ShadowMaps::bytes() const {
    return std::int64_t(4) * texture_.size().x * texture_.size().y * texture_.layers();
}

} // namespace patina
