// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "core/error.h"
#include "measure/error/faceted_rays.h"
#include "measure/error/polarised_term.h"
#include "reference/reference.h"
#include "render/surfaces/surface_buffer.h"
#include "shading/effects/light_colors.h"

namespace patina {

/// Holds all that shades an object in double precision: the blocks of its program with the same
/// numbers that the program got.
struct SurfaceCode {
    struct BlockCode {
        const reference::Block* code = nullptr;
        std::vector<double> values;
    };
    struct LightCode {
        BlockCode block;
        std::optional<std::size_t>
            share; ///< is the index of its shadow among a pixel's; empty: it has none
        std::optional<LightColors> colors{}; ///< are empty where it has its own colour alone
        /// Is the direction in which it swings and the share that does, where that counts.
        std::optional<glm::dvec4> field{};
    };
    /// Is the Fresnel term in a slot that answers to polarised light.
    struct Polarised {
        PolarisedTerm term;
        std::size_t slot = 0;
    };
    /// Says where the field is that an image or the pixel's place changes, or that is emitted.
    struct FieldPlace {
        std::size_t block = 0; ///< is the index in blocks
        std::size_t offset = 0;
        int components = 1;
        std::size_t value = 0; ///< is the index among a pixel's values
    };
    struct Hemisphere {
        glm::dvec3 sky{0.0};
        glm::dvec3 ground{0.0};
        glm::dvec3 up{0.0, 1.0, 0.0};
    };

    std::vector<BlockCode> blocks; ///< are the model, what fills its slots, what blends the sum
    std::size_t slots = 0;
    bool blends = false;
    std::vector<FieldPlace> textured;
    std::vector<FieldPlace> emission;
    std::vector<FieldPlace> diffuse; ///< multiply the model's diffuse term
    glm::dvec3 highlightAmbient{0.0}; ///< is what a highlight in the slot adds to ambient light
    std::vector<LightCode> lights;
    std::optional<Polarised> polarised;
    std::optional<glm::dvec3> ambient;
    std::optional<Hemisphere> hemisphere;
    std::optional<BlockCode> fog;
    std::optional<std::size_t>
        firstSample;                     ///< is where a pixel's values have an environment's light
    bool isSampled = false;              ///< says that its directions differ from round to round
    std::optional<std::size_t> openness; ///< is where a pixel's values have it
    std::size_t firstShare = 0;
    glm::dvec3 eye{0.0};

    std::optional<FacetedRays> facets; ///< are followed where it is a body of flat facets

    /// Collects the code of an object of the buffer. An error says what of it cannot be computed: a
    /// block or an effect without code in double precision, transparency, and refraction but by
    /// facets in a scene that is known.
    static Result<SurfaceCode> of(std::size_t object, const SurfaceBuffer& buffer,
                                  const BufferedScene* around);
};

/// Shades pixels one after the other; each thread needs its own.
class SurfaceShader {
  public:
    /// Keeps a reference to `code`, which must outlive it.
    explicit SurfaceShader(const SurfaceCode& code);
    SurfaceShader(const SurfaceShader&) = delete;
    SurfaceShader& operator=(const SurfaceShader&) = delete;

    /// Goes to a pixel of the buffer, which must show the code's object.
    void lookAt(const SurfaceBuffer& buffer, std::size_t pixel);

    /// Returns the light of lamps and ambient light that the model reflects.
    glm::dvec3 still() const;

    /// Returns the light of an environment that the model reflects, averaged over the buffer's
    /// samples.
    glm::dvec3 sampled() const;

    /// Returns the picture's linear light, given the sum of both: blended, with what the surface
    /// emits, and in fog.
    glm::dvec3 finished(glm::dvec3 sum) const;

    /// Returns what the ray of a round sees through a body of facets; 0 of other objects.
    glm::dvec3 passed(std::uint32_t round) const;

    /// Returns the picture's light where a body shows so much of what is around it, behind what is
    /// finished; the latter alone of other objects.
    glm::dvec3 over(const glm::dvec3& passed, const glm::dvec3& finished) const;

  private:
    struct Point {
        glm::dvec3 x;
        glm::dvec3 n;
        glm::dvec3 t;
        glm::dvec3 toEye;
        glm::dvec2 place;
    };

    void takeImages();
    glm::dvec4 noted(std::size_t value) const;
    glm::dvec3 value(const glm::dvec3& l, const glm::dvec3& v, reference::Fillers fillers) const;
    glm::dvec3 highlightAlone(const glm::dvec3& l, reference::Fillers fillers) const;
    glm::dvec3 lit() const;
    glm::dvec3 fromLights() const;
    glm::dvec3 ambient() const;
    glm::dvec3 emitted() const;
    glm::dvec3 blended(const glm::dvec3& shaded) const;
    glm::dvec3 fogged(const glm::dvec3& shaded) const;

    const SurfaceCode& code_;
    const SurfaceBuffer* buffer_ = nullptr;
    std::size_t pixel_ = 0;
    Point point_{};
    std::vector<std::vector<double>> values_; ///< are those of the blocks, as images changed them
    std::vector<reference::Filler> fillers_;
    std::vector<reference::Filler> polarised_; ///< are the same for polarised light
    const reference::Function* incidence_;
};

} // namespace patina
