// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/pass/lobe_store.h"

#include <algorithm>

#include <epoxy/gl.h>

#include "render/gpu/binding.h"
#include "render/pass/data_packer.h"
#include "shading/program/surface_output.h"

namespace patina {
namespace {

/// The layers of a table, as lobe_fit.glsl writes them.
constexpr int layers = 5;

} // namespace

void LobeStore::makeRoom(std::size_t materials) {
    if (lobes_.size() < materials) {
        lobes_.resize(materials);
    }
}

bool LobeStore::fit(std::size_t number, const Pipeline& pipeline, const Material& material,
                    const glm::dmat4& cameraToWorld) {
    if (!fitting_) {
        fitting_ = std::make_unique<Fitting>();
    }
    const auto vec4s = static_cast<std::size_t>(pipeline.object.vec4s);
    fitting_->data.reserve(vec4s);
    packMaterial(fitting_->data.staging(), pipeline, material, cameraToWorld);
    Lobes& lobes = lobes_[number];
    if (!take(lobes, pipeline, fitting_->data.staging().first(vec4s))) {
        return false;
    }
    const LobeTableShape shape = lobeTableShape(*pipeline.object.model->block);
    if (lobes.table.size() != shape.size()) {
        lobes.table = gl::TextureArray::createColors(shape.size(), layers, GL_RGBA32F);
        lobes.framebuffer = gl::Framebuffer::create();
        lobes.framebuffer.attachColors(lobes.table);
    }
    fitting_->data.upload(vec4s);
    fitting_->data.bind(binding::object);
    for (const GLenum state : {GL_DEPTH_TEST, GL_BLEND, GL_DITHER, GL_CULL_FACE}) {
        glDisable(state);
    }
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    fitting_->noVertices.bind();
    drawSamples(pipeline, shape.samples());
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, fitting_->samples.name());
    glBindFramebuffer(GL_FRAMEBUFFER, lobes.framebuffer.name());
    glViewport(0, 0, shape.size().x, shape.size().y);
    pipeline.lobeFit->use();
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glBindTexture(GL_TEXTURE_2D, 0);
    return true;
}

void LobeStore::drawSamples(const Pipeline& pipeline, glm::ivec2 size) {
    if (fitting_->samples.size() != size) {
        fitting_->samples = gl::Texture::create(size, GL_RGBA32F, GL_RGBA, GL_FLOAT);
        fitting_->framebuffer = gl::Framebuffer::create();
        fitting_->framebuffer.attachColor(fitting_->samples);
    }
    glBindFramebuffer(GL_FRAMEBUFFER, fitting_->framebuffer.name());
    glViewport(0, 0, size.x, size.y);
    pipeline.lobeSamples->use();
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

/// Notes what they are fitted to; false when they are so already.
bool LobeStore::take(Lobes& lobes, const Pipeline& pipeline, std::span<const glm::vec4> values) {
    if (lobes.program == pipeline.lobeSamples && std::ranges::equal(lobes.values, values)) {
        return false;
    }
    lobes.program = pipeline.lobeSamples;
    lobes.values.assign(values.begin(), values.end());
    return true;
}

void LobeStore::drop(std::size_t number) {
    if (lobes_[number].program) {
        lobes_[number] = Lobes();
    }
}

void LobeStore::bind(std::size_t number) const {
    glActiveTexture(GL_TEXTURE0 + binding::lobeTable);
    glBindTexture(GL_TEXTURE_2D_ARRAY, lobes_[number].table.name());
    glActiveTexture(GL_TEXTURE0);
}

} // namespace patina
