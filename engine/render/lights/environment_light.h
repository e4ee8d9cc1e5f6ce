// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <map>
#include <memory>
#include <span>
#include <vector>

#include "render/gpu/uniform_buffer.h"
#include "render/lights/blurred_environment.h"
#include "render/lights/environment_pictures.h"
#include "render/lights/environment_table.h"
#include "render/lights/environment_texture.h"
#include "shading/effects/environment_effect.h"
#include "shading/program/block_use.h"
#include "shading/program/program_cache.h"

namespace patina {

/// Holds the light of an environment from all around, in its own space: rows from straight up,
/// columns from -z over +x; alpha is 1.
struct EnvironmentRadiance {
    glm::ivec2 size{0}; ///< 0 where there is none
    std::span<const glm::vec4> texels;
};

/// Holds what the frames of a scene know of its environment: its values, its picture, and where it
/// is bright. Programs read it at the places of binding.h.
class EnvironmentLight {
  public:
    /// Holds what is followed.
    struct Subject {
        const Scene& effects; ///< whose effects the programs have
        const Scene& scene;
        /// Without a picture that is there an environment that needs one is black.
        const std::shared_ptr<const EnvironmentImage>& image;
        EnvironmentPictures& pictures; ///< of which its own one is
        bool isFitted = false;         ///< programs look it up out of focus
    };

    /// Follows the scene. Allocates nothing while only values change.
    void follow(const Subject& subject, const Catalog& catalog, ProgramCache& cache);

    /// Returns the same up to and with the first thing that takes long, a part of the picture, a
    /// program or the table: true as long as there may be more, and the next call goes on.
    bool followSome(const Subject& subject, const Catalog& catalog, ProgramCache& cache);

    /// Tells whether programs look at an environment.
    bool isIn() const { return current_ != nullptr; }

    /// Returns what a white matte surface that faces up reflects.
    glm::dvec3 upward() const { return table_.upward(); }

    /// Returns the small picture that its table was made from, which stays until the next frame.
    EnvironmentRadiance radiance() const {
        return isIn() && madeFor_ == current_
                   ? EnvironmentRadiance{table_.size(), baked_.radiance()}
                   : EnvironmentRadiance();
    }

    /// Says which samples programs draw.
    struct Samples {
        int firstRound = 0;
        int count = 0;  ///< whole rounds or a part of one
        int series = 0; ///< see View::environmentSeries
    };
    void setSamples(const Samples& samples);

    static constexpr int roundSamples = 4; ///< as in shaders/passes/environment_light.glsl

    /// Binds it for the programs that are used next.
    void bind() const;

    /// Returns the program for what is seen behind the objects; null where the environment is
    /// hidden or the block does not compile.
    const gl::Program* background() const { return background_; }
    double backgroundBlur() const { return blur_; } ///< half the width of the disc, in radians

    /// Shaders may have changed.
    void forget();

  private:
    /// Holds what is kept of a block as long as its text stays.
    struct Known {
        BlockUse use;
        ParameterLayout layout;
        std::map<EnvironmentOutput, std::shared_ptr<const gl::Program>> programs;
    };

    Known& known(std::uint64_t key, const Scene& effects, const Catalog& catalog);
    const gl::Program* program(Known& known, EnvironmentOutput output, const Catalog& catalog,
                               ProgramCache& cache);
    void pack(const BlockValues& values);
    bool takeImage(const Subject& subject);
    bool looksOtherwise();
    void makeTable(const gl::Program* program);
    bool makeBlurred(const Catalog& catalog, ProgramCache& cache);
    void upload();

    std::map<std::uint64_t, Known> known_; ///< by EffectKey
    Known* current_ = nullptr;
    const gl::Program* background_ = nullptr;
    double blur_ = 0.0;
    UniformBuffer values_;
    std::vector<glm::vec4> look_; ///< the values that the table was made from
    std::vector<glm::vec4> wantedLook_;
    const Known* madeFor_ = nullptr;
    std::shared_ptr<EnvironmentPicture> picture_;
    SmallEnvironment baked_;
    EnvironmentTable table_;
    EnvironmentTexture tableTexture_;
    std::array<glm::vec3, 9> harmonics_{};
    std::shared_ptr<const gl::Program> blurProgram_;
    BlurredEnvironment blurred_;
    bool isFitted_ = false;             ///< Subject::isFitted
    const Known* blurredFor_ = nullptr; ///< null: it is to be drawn anew, if anyone asks for it
};

} // namespace patina
