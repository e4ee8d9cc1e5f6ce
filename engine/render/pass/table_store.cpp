// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/pass/table_store.h"

#include <epoxy/gl.h>

#include "render/gpu/binding.h"
#include "render/pass/data_packer.h"

namespace patina {

void TableStore::makeRoom(std::size_t materials) {
    if (tables_.size() < materials) {
        tables_.resize(materials);
    }
}

bool TableStore::fit(std::size_t number, const Pipeline& pipeline, const Material& material,
                     const PackedAround& around) {
    if (!filling_) {
        filling_ = std::make_unique<Filling>();
    }
    const auto vec4s = static_cast<std::size_t>(pipeline.object.vec4s);
    filling_->data.reserve(vec4s);
    packMaterial(filling_->data.staging(), pipeline, material, around);
    Tables& tables = tables_[number];
    if (!take(tables, pipeline, filling_->data.staging())) {
        return false;
    }
    makeTexture(tables, pipeline.object.tables.size);
    filling_->data.upload(vec4s);
    filling_->data.bind(binding::object);
    glBindFramebuffer(GL_FRAMEBUFFER, tables.framebuffer.name());
    glViewport(0, 0, tables.texture.size().x, tables.texture.size().y);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_BLEND);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
    pipeline.tableProgram->use();
    filling_->noVertices.bind();
    glDrawArrays(GL_TRIANGLES, 0, 3);
    return true;
}

/// Notes what the tables are filled from; returns false when they are filled from that already.
bool TableStore::take(Tables& tables, const Pipeline& pipeline, std::span<const glm::vec4> data) {
    const std::vector<std::size_t>& places = pipeline.object.tables.inputs;
    bool isNew = tables.program != pipeline.tableProgram || tables.inputs.size() != places.size();
    tables.program = pipeline.tableProgram;
    tables.inputs.resize(places.size());
    for (std::size_t i = 0; i < places.size(); ++i) {
        const float value = data[places[i] / 4][static_cast<int>(places[i] % 4)];
        isNew = isNew || tables.inputs[i] != value;
        tables.inputs[i] = value;
    }
    return isNew;
}

void TableStore::makeTexture(Tables& tables, glm::ivec2 size) {
    if (tables.texture.size() != size) {
        tables.texture = gl::Texture::create(size, GL_RGBA32F, GL_RGBA, GL_FLOAT);
        tables.framebuffer = gl::Framebuffer::create();
        tables.framebuffer.attachColor(tables.texture);
    }
}

void TableStore::drop(std::size_t number) {
    if (tables_[number].program) {
        tables_[number] = Tables();
    }
}

void TableStore::bind(std::size_t number) const {
    glActiveTexture(GL_TEXTURE0 + binding::blockTables);
    glBindTexture(GL_TEXTURE_2D, tables_[number].texture.name());
}

} // namespace patina
