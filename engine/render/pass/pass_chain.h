// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <memory>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include "catalog/catalog.h"
#include "catalog/parameter_layout.h"
#include "core/error.h"
#include "gl/framebuffer.h"
#include "gl/texture.h"
#include "gl/vertex_array.h"
#include "render/pass/threshold_image.h"
#include "scene/scene.h"
#include "shading/effects/passes_effect.h"
#include "shading/program/program_cache.h"

namespace patina {

/// Holds the programs of one pass over the picture: those of its stages, then that of its result.
struct PassPrograms {
    struct Step {
        std::shared_ptr<const gl::Program> program;
        int dataUniform = -1;
        int levelsUniform = -1; ///< says, where it is there, that it reads smaller levels
    };

    const Block* block = nullptr;
    std::size_t place = 0; ///< is its index in Scene::passes
    ParameterLayout layout;
    std::vector<Step> steps;
};

/// Finds or compiles the programs of all passes; the error is the first message of the compiler.
Result<std::vector<PassPrograms>> passPrograms(const PassesEffect& passes, const Catalog& catalog,
                                               ProgramCache& cache);

/// Draws passes over a finished picture, one after the other, in images of its own, which it has
/// only while there are passes.
class PassChain {
  public:
    /// Packs the values that the scene has for the passes; defaults where it has another pass.
    /// Takes their images from `images`, and returns false while one of them is being loaded.
    bool pack(const std::vector<PassPrograms>& passes, const Scene& scene,
              const GpuTextureStore& images);

    /// Fits the images to a picture's size, in pixels, and returns the framebuffer that the picture
    /// is to be drawn into.
    unsigned begin(glm::ivec2 size);

    /// Draws all passes, of which there is at least one, the last one into `framebuffer`. A `share`
    /// below 1 blends its result with what is there.
    void draw(const std::vector<PassPrograms>& passes, unsigned framebuffer, double share);

    /// Frees the images.
    void release();

  private:
    struct Image {
        gl::Texture texture;
        gl::Framebuffer framebuffer;
    };

    static void fit(Image& image, glm::ivec2 size);
    static void bindPicture(const Image& picture, const PassPrograms::Step& step);
    void drawStep(const PassPrograms::Step& step, std::size_t pass) const;

    gl::VertexArray noVertices_ = gl::VertexArray::create();
    glm::ivec2 size_{0};
    std::array<Image, 2> pictures_;            ///< hold the picture before and behind a pass
    std::array<Image, 2> stages_;              ///< hold what the stages of a pass draw
    std::vector<std::vector<glm::vec4>> data_; ///< has the packed values of each pass
    std::vector<ThresholdImage> thresholds_;   ///< has the image of each pass that has one
};

/// Sets the state for blending what is drawn next by `share` with what is there.
void setShare(double share);

} // namespace patina
