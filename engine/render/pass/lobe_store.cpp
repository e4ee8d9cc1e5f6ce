// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/pass/lobe_store.h"

#include <algorithm>

#include <epoxy/gl.h>

#include "render/gpu/binding.h"
#include "render/pass/data_packer.h"

namespace patina {
namespace {

void drawTo(const gl::Framebuffer& framebuffer, glm::ivec2 size, const gl::Program& program) {
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer.name());
    glViewport(0, 0, size.x, size.y);
    program.use();
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

} // namespace

void LobeStore::makeRoom(std::size_t materials) {
    if (lobes_.size() < materials) {
        lobes_.resize(materials);
    }
}

bool LobeStore::fit(std::size_t number, const Pipeline& pipeline, const Material& material,
                    const PackedAround& around, const SharedTable& measured) {
    if (!fitting_) {
        fitting_ = std::make_unique<Fitting>();
    }
    const auto vec4s = static_cast<std::size_t>(pipeline.object.vec4s);
    fitting_->data.reserve(vec4s);
    packMaterial(fitting_->data.staging(), pipeline, material, around);
    Lobes& lobes = lobes_[number];
    if (!take(lobes, pipeline, fitting_->data.staging().first(vec4s), measured)) {
        return false;
    }
    const LobeTableShape shape = lobeTableShape(*pipeline.object.model->block);
    if (lobes.table.size() != shape.table()) {
        lobes.table = gl::TextureArray::createColors(shape.table(), shape.layers(), GL_RGBA32F);
        glBindTexture(GL_TEXTURE_2D_ARRAY, lobes.table.name());
        // Azimuths are periodic.
        glTexParameteri(GL_TEXTURE_2D_ARRAY, GL_TEXTURE_WRAP_T, GL_REPEAT);
        glBindTexture(GL_TEXTURE_2D_ARRAY, 0);
        lobes.framebuffer = gl::Framebuffer::create();
        lobes.framebuffer.attachColors(lobes.table);
    }
    fitting_->makeRoom(shape);
    fitting_->data.upload(vec4s);
    fitting_->data.bind(binding::object);
    for (const GLenum state : {GL_DEPTH_TEST, GL_BLEND, GL_DITHER, GL_CULL_FACE}) {
        glDisable(state);
    }
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    fitting_->noVertices.bind();
    glActiveTexture(GL_TEXTURE0);
    drawTo(fitting_->sampling, shape.samples(), *pipeline.lobeSamples);
    glBindTexture(GL_TEXTURE_2D, fitting_->samples.name());
    drawTo(fitting_->fitting, shape.fitted(), *pipeline.lobeFit);
    glBindTexture(GL_TEXTURE_2D, 0);
    glBindTexture(GL_TEXTURE_2D_ARRAY, fitting_->fitted.name());
    drawTo(lobes.framebuffer, shape.table(), *pipeline.lobeTable);
    glBindTexture(GL_TEXTURE_2D_ARRAY, 0);
    return true;
}

void LobeStore::Fitting::makeRoom(const LobeTableShape& shape) {
    if (samples.size() == shape.samples()) {
        return;
    }
    samples = gl::Texture::create(shape.samples(), GL_RGBA32F, GL_RGBA, GL_FLOAT);
    sampling = gl::Framebuffer::create();
    sampling.attachColor(samples);
    fitted = gl::TextureArray::createColors(shape.fitted(), shape.layers(), GL_RGBA32F);
    fitting = gl::Framebuffer::create();
    fitting.attachColors(fitted);
}

/// Notes what the lobes are fitted to; returns false when they are fitted to that already.
bool LobeStore::take(Lobes& lobes, const Pipeline& pipeline, std::span<const glm::vec4> values,
                     const SharedTable& measured) {
    if (lobes.program == pipeline.lobeSamples && lobes.measured.lock() == measured &&
        std::ranges::equal(lobes.values, values)) {
        return false;
    }
    lobes.measured = measured;
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
