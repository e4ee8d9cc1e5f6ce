// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/pass/shadow_drawer.h"

#include <epoxy/gl.h>
#include <glm/gtc/type_ptr.hpp>

#include "shading/effects/shadow_source.h"

namespace patina {

Result<void> ShadowDrawer::prepare(const Catalog& catalog, ProgramCache& programs) {
    if (program_) {
        return {};
    }
    const auto source = shadowMapProgram(catalog);
    if (!source) {
        return tl::unexpected(source.error().front());
    }
    const ProgramCache::Found found = programs.get(*source);
    if (!found.program) {
        return tl::unexpected(found.errors.front());
    }
    program_ = found.program;
    return {};
}

Result<void> ShadowDrawer::check(const gl::TextureArray& texture) {
    if (framebuffer_.name() == 0) {
        framebuffer_ = gl::Framebuffer::create();
    }
    framebuffer_.attachDepth(texture, 0);
    return framebuffer_.check();
}

void ShadowDrawer::restart() {
    layer_ = 0;
    isBegun_ = false;
}

void ShadowDrawer::drawSome(const ShadowTargets& targets, std::int64_t triangles) {
    std::int64_t left = triangles;
    while (left > 0 && layer_ < targets.layers.size()) {
        ShadowLayers::Layer& layer = targets.layers[layer_];
        if (layer.isDrawn || (isBegun_ && run_ == runs_.size())) {
            layer.isDrawn = true;
            isBegun_ = false;
            ++layer_;
            continue;
        }
        beginLayer(targets);
        while (left > 0 && run_ < runs_.size()) {
            const ShadowCasters::Run& run = runs_[run_];
            beginRun(targets);
            const DrawRange range = slices_.next(run.mesh->triangles(), run.first, run.count, left);
            run.mesh->draw(instances_, range);
            left -= range.total();
            if (slices_.isDone(run.count)) {
                slices_ = DrawSlices();
                ++run_;
            }
        }
    }
}

/// Sets the state for a layer and gathers its casters. Triangles are drawn from both sides, so that
/// open meshes cast shadows too.
void ShadowDrawer::beginLayer(const ShadowTargets& targets) {
    framebuffer_.attachDepth(targets.texture, static_cast<int>(layer_));
    glViewport(0, 0, targets.texture.size().x, targets.texture.size().y);
    glEnable(GL_DEPTH_TEST);
    glDepthMask(GL_TRUE);
    glDepthFunc(GL_LESS);
    glDisable(GL_CULL_FACE);
    glDisable(GL_BLEND);
    if (!isBegun_) {
        glClear(GL_DEPTH_BUFFER_BIT);
        const ShadowLayers::Layer& layer = targets.layers[layer_];
        targets.casters.gather(shadowClip(layer.view, layer.face), runs_, instances_);
        run_ = 0;
        slices_ = DrawSlices();
        isBegun_ = true;
    }
}

void ShadowDrawer::beginRun(const ShadowTargets& targets) {
    const ShadowLayers::Layer& layer = targets.layers[layer_];
    const glm::mat4 worldToMap(shadowClip(layer.view, layer.face));
    const ShadowCasters::Run& run = runs_[run_];
    if (run.alphaTested != ShadowCasters::solid) {
        targets.casters.useAlphaTest(run, worldToMap, targets.textures);
        return;
    }
    program_->use();
    glUniformMatrix4fv(program_->uniform("worldToMap"), 1, GL_FALSE, glm::value_ptr(worldToMap));
}

} // namespace patina
