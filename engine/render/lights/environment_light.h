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

/// Holds the light of an environment from all directions, in its own space: rows from straight up,
/// columns from -z over +x; alpha is 1.
struct EnvironmentRadiance {
    glm::ivec2 size{0}; ///< is 0 where there is no environment
    std::span<const glm::vec4> texels;
};

/// Holds the GPU data of a scene's environment: its values, its picture, and a table for sampling
/// it by brightness. Programs read them at the units of binding.h.
class EnvironmentLight {
  public:
    /// Names the scene and the picture to follow.
    struct Subject {
        const Scene& effects; ///< is the scene whose effects the programs have
        const Scene& scene;
        /// Is null while there is no picture; an environment that needs one is black then.
        const std::shared_ptr<const EnvironmentImage>& image;
        EnvironmentPictures& pictures; ///< shares the pictures between views
        bool isFitted = false;         ///< says that programs read the blurred levels
    };

    /// Brings all data up to date with the scene. It allocates nothing while only values change.
    void follow(const Subject& subject, const Catalog& catalog, ProgramCache& cache);

    /// Does the same in steps, each up to the first long step of work: a part of the picture, a
    /// program or the table. Returns true while there may be more to do.
    bool followSome(const Subject& subject, const Catalog& catalog, ProgramCache& cache);

    /// Returns true when programs have an environment to read.
    bool isIn() const { return current_ != nullptr; }

    /// Returns the linear radiance that a white matte surface facing up reflects.
    glm::dvec3 upward() const { return table_.upward(); }

    /// Returns the small picture that the table was made from; empty while there is none. The
    /// texels are valid until the next frame.
    EnvironmentRadiance radiance() const {
        return isIn() && madeFor_ == current_
                   ? EnvironmentRadiance{table_.size(), baked_.radiance()}
                   : EnvironmentRadiance();
    }

    /// Says which samples of the environment's light the programs take.
    struct Samples {
        int firstRound = 0;
        int count = 0;  ///< is a multiple of roundSamples, or less than one round
        int series = 0; ///< is View::environmentSeries
    };
    void setSamples(const Samples& samples);

    static constexpr int roundSamples = 4; ///< is the same as in
                                           ///< shaders/passes/environment_light.glsl

    /// Binds the values, the table and the pictures for the programs that are used next.
    void bind() const;

    /// Returns the program that draws the environment behind the objects; null where it is hidden
    /// or its block does not compile.
    const gl::Program* background() const { return background_; }
    double backgroundBlur() const {
        return blur_;
    } ///< radians: half the angle across the blurring
      ///< disc

    /// Drops all programs and what was made with them, because shaders may have changed.
    void forget();

  private:
    /// Holds the layout and the programs of a block while its text does not change.
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

    std::map<std::uint64_t, Known> known_; ///< maps an EffectKey
    Known* current_ = nullptr;
    const gl::Program* background_ = nullptr;
    double blur_ = 0.0;
    UniformBuffer values_;
    std::vector<glm::vec4> look_; ///< holds the values that the table was made from
    std::vector<glm::vec4> wantedLook_;
    const Known* madeFor_ = nullptr;
    std::shared_ptr<EnvironmentPicture> picture_;
    SmallEnvironment baked_;
    EnvironmentTable table_;
    EnvironmentTexture tableTexture_;
    std::array<glm::vec3, 9> harmonics_{};
    std::shared_ptr<const gl::Program> blurProgram_;
    BlurredEnvironment blurred_;
    bool isFitted_ = false;             ///< is Subject::isFitted of the last call
    const Known* blurredFor_ = nullptr; ///< is null when the blurred levels must be drawn again
                                        ///< before use
};

} // namespace patina
