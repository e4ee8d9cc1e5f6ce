// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/pass/frame_environment.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <epoxy/gl.h>
#include <glm/trigonometric.hpp>

#include "gl/driver.h"
#include "render/gpu/slow_allocation.h"
#include "shading/effects/opacity.h"

namespace patina {
namespace {

constexpr int roundSamples = EnvironmentLight::roundSamples;

/// Limits the rounds of directions in one frame.
constexpr int maxRounds = 64;

/// Limits the rounds in a frame that only improves a picture that is already seen.
constexpr int addedRounds = 8;

/// Is the number of rounds for the blurred background where nothing else is sampled.
constexpr int fittedRounds = 4;

/// Returns the rounds of a frame that must not keep a window waiting.
int usualRounds() {
    static const int rounds = gl::isSoftware() ? 1 : 4;
    return rounds;
}

/// Returns true when a visible object is transparent; such objects are drawn in one step, however
/// long that takes.
bool blends(const Scene& effects, const Catalog& catalog) {
    return std::ranges::any_of(effects.objects, [&catalog](const Object& object) {
        return object.visible && isTransparent(object.material, catalog);
    });
}

/// Rounds up to whole rounds, except a number below one round.
int wholeRounds(int samples) {
    return samples < roundSamples ? samples
                                  : (samples + roundSamples - 1) / roundSamples * roundSamples;
}

int samplesOf(const View& view, const Scene& effects, const Catalog& catalog, int done) {
    if (view.environmentSamples <= 0) {
        // Adds at most as many as there are already, so that the first ones are seen soon.
        const int added = blends(effects, catalog) ? 0 : std::min(done, addedRounds * roundSamples);
        const int maxSamples = std::max(usualRounds() * roundSamples, added);
        return wholeRounds(std::clamp(view.maxSamples - done, 1, maxSamples));
    }
    return wholeRounds(std::min(view.environmentSamples, maxRounds * roundSamples));
}

bool isFitted(const Scene& effects, const View& view) {
    return view.isMoving || effects.accuracy.fitsEnvironment();
}

void set(const gl::Program& program, const char* name, const glm::dvec3& value) {
    glUniform3f(program.uniform(name), static_cast<float>(value.x), static_cast<float>(value.y),
                static_cast<float>(value.z));
}

} // namespace

Result<bool> FrameEnvironment::begin(const SceneToPack& scene, const View& view,
                                     const Catalog& catalog, const Shared& shared) {
    ProgramCache& cache = shared.cache;
    const int built = cache.builtCount();
    const bool fits = isFitted(scene.effects, view);
    if (light_.followSome(
            {scene.effects, scene.scene, view.environmentImage, shared.pictures, fits}, catalog,
            cache) ||
        cache.builtCount() > built) {
        return true;
    }
    if (!isIn() || fits) {
        const bool isWantedSoon = isIn() && !scene.effects.accuracy.fitsEnvironment();
        if (!isWantedSoon && accumulation_.mean().size().x > 0) {
            accumulation_ = Accumulation();
        }
        done_ = 0;
        count_ = 0;
        if (isIn()) {
            light_.setSamples({0, fittedRounds * roundSamples, view.environmentSeries});
        }
        return false;
    }
    if (auto prepared = accumulation_.prepare(catalog, cache); !prepared) {
        return tl::unexpected(prepared.error());
    }
    if (cache.builtCount() > built) {
        return true;
    }
    const auto kept = accumulation_.fit(view.size, catalog, cache);
    if (!kept) {
        return tl::unexpected(kept.error());
    }
    done_ = *kept && view.isContinued ? done_ : 0;
    if (!*kept && isSlowToAllocate(view.size)) {
        return true;
    }
    count_ = samplesOf(view, scene.effects, catalog, done_);
    light_.setSamples({(done_ + roundSamples - 1) / roundSamples, count_, view.environmentSeries});
    return false;
}

void FrameEnvironment::prewarm(const SceneToPack& scene, const View& view, const Catalog& catalog,
                               const Shared& shared) {
    light_.follow({scene.effects, scene.scene, view.environmentImage, shared.pictures,
                   isFitted(scene.effects, view)},
                  catalog, shared.cache);
    if (isIn()) {
        light_.setSamples({0, roundSamples, 0});
    }
}

void FrameEnvironment::drawBackground(const Camera& camera, const glm::dmat4& cameraToWorld,
                                      double aspect) const {
    const gl::Program* program = light_.background();
    if (program == nullptr) {
        return;
    }
    light_.bind();
    program->use();
    const double up = std::tan(0.5 * glm::radians(std::clamp(camera.fieldOfView, 1.0, 170.0)));
    set(*program, "backgroundForward", -glm::dvec3(cameraToWorld[2]));
    set(*program, "backgroundRight", up * aspect * glm::dvec3(cameraToWorld[0]));
    set(*program, "backgroundUp", up * glm::dvec3(cameraToWorld[1]));
    std::array<GLint, 4> viewport{};
    glGetIntegerv(GL_VIEWPORT, viewport.data());
    glUniform2f(program->uniform("backgroundSize"), static_cast<float>(viewport[2]),
                static_cast<float>(viewport[3]));
    glUniform1f(program->uniform("backgroundBlur"), static_cast<float>(light_.backgroundBlur()));
    glEnable(GL_DEPTH_TEST);
    glDepthFunc(GL_LEQUAL);
    glDepthMask(GL_FALSE);
    glDepthRange(1.0, 1.0);
    glDisable(GL_BLEND);
    noVertices_.bind();
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glBindVertexArray(0);
    glDepthRange(0.0, 1.0);
    glDepthMask(GL_TRUE);
    glDepthFunc(GL_LESS);
}

void FrameEnvironment::bind() const {
    if (isIn()) {
        light_.bind();
    }
}

void FrameEnvironment::add(const gl::Texture& frame) {
    done_ += count_;
    accumulation_.add(frame, static_cast<float>(double(count_) / double(done_)));
}

/// Draws twice, because the first frame of a mean replaces it and the next ones are blended.
void FrameEnvironment::addUnseen(const gl::Texture& frame, const Catalog& catalog,
                                 ProgramCache& cache) const {
    Accumulation mean;
    if (isIn() && mean.fit(glm::ivec2(1), catalog, cache)) {
        mean.add(frame, 1.0f);
        mean.add(frame, 0.5f);
    }
}

int FrameEnvironment::samples() const {
    return done_;
}

int FrameEnvironment::rounds() const {
    return isSampled() ? (count_ + roundSamples - 1) / roundSamples : 0;
}

bool FrameEnvironment::holds(glm::ivec2 size) const {
    return hasPicture() && accumulation_.mean().size() == size;
}

void FrameEnvironment::forget() {
    light_.forget();
    accumulation_.forget();
    done_ = 0;
}

} // namespace patina
