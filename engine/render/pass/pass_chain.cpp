// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/pass/pass_chain.h"

#include <algorithm>
#include <bit>
#include <utility>

#include <epoxy/gl.h>
#include <glm/gtc/type_ptr.hpp>

#include "catalog/picture_roles.h"
#include "render/pass/depth_normal_pass.h"
#include "shading/program/parameter_packer.h"

namespace patina {
namespace {

constexpr unsigned pictureUnit = 0;
constexpr unsigned stageUnit = 1;
constexpr unsigned thresholdUnit = 4; ///< follows those of DepthNormalPass

/// Returns the number of the level that is one pixel wide and high.
int lastLevel(glm::ivec2 size) {
    return std::bit_width(static_cast<unsigned>(std::max(size.x, size.y))) - 1;
}

/// Returns the file that a pass names for its thresholds; empty: it names none.
std::string thresholdFile(const Parameter& parameter, const Values& values) {
    const auto found = values.find(parameter.id);
    const auto* file = found == values.end() ? nullptr : std::get_if<std::string>(&found->second);
    return file == nullptr ? std::string() : *file;
}

void bindImage(unsigned unit, const gl::Texture& texture) {
    glActiveTexture(GL_TEXTURE0 + unit);
    glBindTexture(GL_TEXTURE_2D, texture.name());
}

Result<PassPrograms::Step> stepFor(const PassUse& pass, std::string_view stage,
                                   const Catalog& catalog, ProgramCache& cache) {
    const auto source = pictureProgram(pass.use, stage, catalog);
    if (!source) {
        return tl::unexpected(source.error().front());
    }
    const ProgramCache::Found found = cache.get(*source);
    if (!found.program) {
        return tl::unexpected(found.errors.front());
    }
    found.program->bindSampler("pictureImage", pictureUnit);
    found.program->bindSampler("stageImage", stageUnit);
    found.program->bindSampler("thresholdImage", thresholdUnit);
    DepthNormalPass::nameUnits(*found.program);
    return PassPrograms::Step{found.program, found.program->uniform("passData"),
                              found.program->uniform("pictureLevels")};
}

} // namespace

Result<std::vector<PassPrograms>> passPrograms(const PassesEffect& passes, const Catalog& catalog,
                                               ProgramCache& cache) {
    std::vector<PassPrograms> all;
    for (const PassUse& pass : passes.passes) {
        const Block& block = pass.use.block();
        PassPrograms programs{&block, pass.place, layoutOf(block), {}};
        std::vector<std::string_view> stages(block.picture.stages.begin(),
                                             block.picture.stages.end());
        stages.emplace_back(); // the result
        for (const std::string_view stage : stages) {
            auto step = stepFor(pass, stage, catalog, cache);
            if (!step) {
                return tl::unexpected(step.error());
            }
            programs.steps.push_back(std::move(*step));
        }
        all.push_back(std::move(programs));
    }
    return all;
}

bool PassChain::pack(const std::vector<PassPrograms>& passes, const Scene& scene,
                     const GpuTextureStore& images) {
    static const Values none;
    static const AccuracyLevels exact;
    bool hasImages = true;
    data_.resize(passes.size());
    thresholds_.resize(passes.size());
    for (std::size_t i = 0; i < passes.size(); ++i) {
        const PassPrograms& pass = passes[i];
        const bool isThere =
            pass.place < scene.passes.size() && scene.passes[pass.place].id == pass.block->id;
        const Values& values = isThere ? scene.passes[pass.place].parameters : none;
        data_[i].resize(pass.layout.floats / 4);
        packInto(data_[i], pass.layout, values, exact, glm::dmat4(1.0));
        if (const Parameter* threshold = pass.block->withRole(roles::threshold)) {
            hasImages = thresholds_[i].take(thresholdFile(*threshold, values), images) && hasImages;
        }
    }
    return hasImages;
}

void PassChain::fit(Image& image, glm::ivec2 size) {
    if (image.texture.size() == size) {
        return;
    }
    image.texture = gl::Texture::create(size, GL_RGBA16F, GL_RGBA, GL_HALF_FLOAT);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_LINEAR);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
    image.framebuffer = gl::Framebuffer::create();
    image.framebuffer.attachColor(image.texture);
}

/// Makes the smaller levels for a program that reads them; others read the picture as it is.
void PassChain::bindPicture(const Image& picture, const PassPrograms::Step& step) {
    const bool readsLevels = step.levelsUniform >= 0;
    bindImage(pictureUnit, picture.texture);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL,
                    readsLevels ? lastLevel(picture.texture.size()) : 0);
    glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER,
                    readsLevels ? GL_LINEAR_MIPMAP_LINEAR : GL_LINEAR);
    if (readsLevels) {
        glGenerateMipmap(GL_TEXTURE_2D);
    }
}

unsigned PassChain::begin(glm::ivec2 size) {
    size_ = size;
    fit(pictures_[0], size);
    return pictures_[0].framebuffer.name();
}

void PassChain::draw(const std::vector<PassPrograms>& passes, unsigned framebuffer, double share) {
    noVertices_.bind();
    std::size_t picture = 0;
    for (std::size_t i = 0; i < passes.size(); ++i) {
        const PassPrograms& pass = passes[i];
        const std::size_t last = pass.steps.size() - 1;
        for (std::size_t step = 0; step < last; ++step) {
            Image& image = stages_[step % 2];
            fit(image, size_);
            glBindFramebuffer(GL_FRAMEBUFFER, image.framebuffer.name());
            bindPicture(pictures_[picture], pass.steps[step]);
            bindImage(stageUnit,
                      step > 0 ? stages_[(step - 1) % 2].texture : pictures_[picture].texture);
            drawStep(pass.steps[step], i);
        }
        const bool isLast = i + 1 == passes.size();
        if (!isLast) {
            fit(pictures_[1 - picture], size_);
        }
        glBindFramebuffer(GL_FRAMEBUFFER,
                          isLast ? framebuffer : pictures_[1 - picture].framebuffer.name());
        setShare(isLast ? share : 1.0);
        bindPicture(pictures_[picture], pass.steps[last]);
        bindImage(stageUnit,
                  last > 0 ? stages_[(last - 1) % 2].texture : pictures_[picture].texture);
        drawStep(pass.steps[last], i);
        picture = 1 - picture;
    }
    glDisable(GL_BLEND);
    glActiveTexture(GL_TEXTURE0 + stageUnit);
    glBindTexture(GL_TEXTURE_2D, 0);
    glActiveTexture(GL_TEXTURE0);
}

void PassChain::drawStep(const PassPrograms::Step& step, std::size_t pass) const {
    const std::vector<glm::vec4>& data = data_[pass];
    step.program->use();
    thresholds_[pass].bind(thresholdUnit);
    if (step.levelsUniform >= 0) {
        glUniform1f(step.levelsUniform, static_cast<float>(lastLevel(size_)));
    }
    if (!data.empty()) {
        glUniform4fv(step.dataUniform, static_cast<int>(data.size()), glm::value_ptr(data.front()));
    }
    glDrawArrays(GL_TRIANGLES, 0, 3);
}

void PassChain::release() {
    pictures_ = {};
    stages_ = {};
}

void setShare(double share) {
    (share < 1.0 ? glEnable : glDisable)(GL_BLEND);
    glBlendColor(0.0f, 0.0f, 0.0f, static_cast<float>(share));
    glBlendFunc(GL_CONSTANT_ALPHA, GL_ONE_MINUS_CONSTANT_ALPHA);
}

} // namespace patina
