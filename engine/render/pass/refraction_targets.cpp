// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/pass/refraction_targets.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <epoxy/gl.h>
#include <glm/geometric.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <glm/matrix.hpp>

#include "render/gpu/binding.h"
#include "render/pass/found_program.h"
#include "shading/effects/refraction_source.h"

namespace patina {
namespace {

void setBall(const gl::Program& program, const Ball& ball) {
    glUniform4f(program.uniform("refractionBody"), static_cast<float>(ball.center.x),
                static_cast<float>(ball.center.y), static_cast<float>(ball.center.z),
                static_cast<float>(ball.radius));
}

/// Returns a plane in the world, as seen from the middle of its body.
glm::vec4 placed(const FacetPlane& plane, const Placement& placement, const glm::dmat3& turn) {
    const glm::dvec3 normal = glm::normalize(turn * plane.normal);
    const glm::dvec3 x(placement.world * glm::dvec4(plane.offset * plane.normal, 1.0));
    return {normal, glm::dot(normal, x - placement.ball.center)};
}

/// Returns the level of the depths whose texels are half as wide as tiles, of which about 32 cover
/// a picture.
int levelOfTiles(glm::ivec2 size) {
    int level = 2;
    while ((64 << level) < std::max(size.x, size.y)) {
        ++level;
    }
    return level;
}

} // namespace

Result<void> RefractionTargets::begin(glm::ivec2 size, Needs needs, const Catalog& catalog,
                                      ProgramCache& cache) {
    if (size != size_ || built_.back != needs.back || built_.behind != needs.behind) {
        std::shared_ptr<const gl::Program> back = std::move(backProgram_);
        std::shared_ptr<const gl::Program> reach = std::move(reachProgram_);
        *this = RefractionTargets();
        backProgram_ = std::move(back);
        reachProgram_ = std::move(reach);
        size_ = size;
        auto built = needs.back ? buildBack() : Result<void>();
        if (built && needs.behind) {
            built = buildBehind();
        }
        if (!built) {
            *this = RefractionTargets();
            return built;
        }
        built_ = needs;
    }
    return makePrograms(catalog, cache);
}

Result<void> RefractionTargets::buildBack() {
    back_ = gl::TargetTexture::create(size_, GL_RGBA32F, 1);
    backDepth_ = gl::TargetTexture::create(size_, GL_DEPTH_COMPONENT32F, 1);
    backTarget_ = gl::Framebuffer::create();
    backTarget_.attachColor(back_, 0);
    backTarget_.attachDepth(backDepth_);
    return backTarget_.check();
}

/// The depths have whole tiles, so that the last ones along both sides have texels, too.
Result<void> RefractionTargets::buildBehind() {
    reachLevel_ = levelOfTiles(size_);
    const int tile = 2 << reachLevel_;
    const glm::ivec2 whole = (size_ + tile - 1) / tile * tile;
    behindDepth_ = gl::TargetTexture::createLevels(whole, GL_DEPTH_COMPONENT32F, reachLevel_);
    behindTarget_ = gl::Framebuffer::create();
    behindTarget_.attachDepth(behindDepth_);
    glDrawBuffer(GL_NONE);
    glReadBuffer(GL_NONE);
    reachTarget_ = gl::Framebuffer::create();
    reachTarget_.attachDepth(behindDepth_, reachLevel_);
    glDrawBuffer(GL_NONE);
    glReadBuffer(GL_NONE);
    return behindTarget_.check().and_then([this] { return reachTarget_.check(); });
}

Result<void> RefractionTargets::makePrograms(const Catalog& catalog, ProgramCache& cache) {
    if (built_.back && !backProgram_) {
        const auto made = foundProgram(bodyBackProgram(catalog), cache);
        if (!made) {
            return tl::unexpected(made.error());
        }
        backProgram_ = *made;
        backProgram_->bindBlock("ViewBlock", binding::view);
        backProgram_->bindBlock("ObjectBlock", binding::object);
    }
    if (built_.behind && !reachProgram_) {
        const auto made = foundProgram(tileReachProgram(catalog), cache);
        if (!made) {
            return tl::unexpected(made.error());
        }
        reachProgram_ = *made;
        reachProgram_->bindSampler("behindDepth", binding::behindDepth);
    }
    return {};
}

void RefractionTargets::beginBack(const Ball& ball, bool isNew) const {
    static constexpr std::array<float, 4> nothing{0.0f, 0.0f, 0.0f, 0.0f};
    static constexpr float nearest = 0.0f;
    glBindFramebuffer(GL_FRAMEBUFFER, backTarget_.name());
    glViewport(0, 0, size_.x, size_.y);
    glDepthMask(GL_TRUE);
    glDepthFunc(GL_GREATER);
    if (isNew) {
        glClearBufferfv(GL_COLOR, 0, nothing.data());
        glClearBufferfv(GL_DEPTH, 0, &nearest);
    }
    backProgram_->use();
    setBall(*backProgram_, ball);
}

void RefractionTargets::takeBehind(const HdrTarget& target) const {
    const glm::ivec2 drawn = target.drawnSize();
    target.resolve();
    glBindFramebuffer(GL_READ_FRAMEBUFFER, target.framebuffer());
    glBindFramebuffer(GL_DRAW_FRAMEBUFFER, behindTarget_.name());
    glBlitFramebuffer(0, 0, drawn.x, drawn.y, 0, 0, size_.x, size_.y, GL_DEPTH_BUFFER_BIT,
                      GL_NEAREST);
    drawReach();
}

void RefractionTargets::drawReach() const {
    const int tile = 2 << reachLevel_;
    const glm::ivec2 texels = (size_ + tile - 1) / tile * 2;
    glBindFramebuffer(GL_FRAMEBUFFER, reachTarget_.name());
    glViewport(0, 0, texels.x, texels.y);
    behindDepth_.bind(binding::behindDepth);
    behindDepth_.showLevels(0);
    glDepthMask(GL_TRUE);
    glDepthFunc(GL_ALWAYS);
    reachProgram_->use();
    glUniform2i(reachProgram_->uniform("behindSize"), size_.x, size_.y);
    glUniform1i(reachProgram_->uniform("behindLevel"), reachLevel_);
    noVertices_.bind();
    glDrawArrays(GL_TRIANGLES, 0, 3);
    behindDepth_.showLevels(reachLevel_);
    glDepthFunc(GL_LESS);
}

void RefractionTargets::bind(const gl::Program& program, const Ball& ball,
                             const HdrTarget& target) const {
    if (built_.back) {
        back_.bind(binding::refractionBack);
        setBall(program, ball);
    }
    if (built_.behind) {
        glActiveTexture(GL_TEXTURE0 + binding::behindColor);
        glBindTexture(GL_TEXTURE_2D, target.averaged().name());
        behindDepth_.bind(binding::behindDepth);
        glUniform1i(program.uniform("behindLevel"), reachLevel_);
    }
    glActiveTexture(GL_TEXTURE0);
}

void RefractionTargets::setFacets(const gl::Program& program, const Placement& placement,
                                  const ConvexFacets& facets) {
    const glm::dmat3 turn = glm::transpose(glm::inverse(glm::dmat3(placement.world)));
    std::array<glm::vec4, ConvexFacets::maxPlanes> planes{};
    int count = 0;
    for (const FacetPlane& plane : facets.planes) {
        const glm::vec4 each = placed(plane, placement, turn);
        if (!std::isfinite(glm::dot(each, each))) {
            count = 0;
            break;
        }
        planes[static_cast<std::size_t>(count++)] = each;
    }
    setBall(program, placement.ball);
    glUniform1i(program.uniform("refractionFacetCount"), count);
    glUniform4fv(program.uniform("refractionFacets"), static_cast<int>(planes.size()),
                 glm::value_ptr(planes.front()));
}

void RefractionTargets::assignUnits(const gl::Program& program) {
    program.bindSampler("refractionBack", binding::refractionBack);
    program.bindSampler("behindColor", binding::behindColor);
    program.bindSampler("behindDepth", binding::behindDepth);
}

} // namespace patina
