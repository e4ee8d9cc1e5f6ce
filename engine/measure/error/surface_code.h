// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "core/error.h"
#include "reference/reference.h"
#include "render/surfaces/surface_buffer.h"

namespace patina {

/// Represents all that shades an object, in double precision: the blocks of its program with the
/// very numbers that the program was fed with.
struct SurfaceCode {
    struct BlockCode {
        const reference::Block* code = nullptr;
        std::vector<double> values;
    };
    struct LightCode {
        BlockCode block;
        std::optional<std::size_t> share; ///< the number of its share among a pixel's
    };
    /// Holds what images change, or what is emitted.
    struct FieldPlace {
        std::size_t block = 0; ///< in blocks
        std::size_t offset = 0;
        int components = 1;
        std::size_t value = 0; ///< of a pixel's values
    };
    struct Hemisphere {
        glm::dvec3 sky{0.0};
        glm::dvec3 ground{0.0};
        glm::dvec3 up{0.0, 1.0, 0.0};
    };

    std::vector<BlockCode> blocks; ///< the model, what fills its slots, what blends the sum
    std::size_t slots = 0;
    bool blends = false;
    std::vector<FieldPlace> textured;
    std::vector<FieldPlace> emission;
    std::vector<LightCode> lights;
    std::optional<glm::dvec3> ambient;
    std::optional<Hemisphere> hemisphere;
    std::optional<BlockCode> fog;
    std::optional<std::size_t> firstSample; ///< of an environment's light, among a pixel's values
    bool isSampled = false;                 ///< its directions are others in each round
    std::optional<std::size_t> openness;    ///< of the pixel, among its values
    std::size_t firstShare = 0;
    glm::dvec3 eye{0.0};

    /// The error says what of the object cannot be computed so: blocks without code in double
    /// precision, and what is transparent.
    static Result<SurfaceCode> of(const BufferedObject& object, const SurfaceBuffer& buffer);
};

/// Shades pixels, one thread's after the other.
class SurfaceShader {
  public:
    /// `code` outlives it.
    explicit SurfaceShader(const SurfaceCode& code);
    SurfaceShader(const SurfaceShader&) = delete;
    SurfaceShader& operator=(const SurfaceShader&) = delete;

    /// Looks at a pixel of the buffer that shows the code's object.
    void lookAt(const SurfaceBuffer& buffer, std::size_t pixel);

    /// Returns what its model makes of lamps and ambient light.
    glm::dvec3 still() const;

    /// The mean of what the buffer's samples of an environment make of it.
    glm::dvec3 sampled() const;

    /// Returns the picture's linear light, given the sum of both: blended, with the surface's own
    /// glow, in fog.
    glm::dvec3 finished(glm::dvec3 sum) const;

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
    glm::dvec3 value(const glm::dvec3& l, const glm::dvec3& v) const;
    glm::dvec3 lit() const;
    glm::dvec3 ambient() const;
    glm::dvec3 emitted() const;
    glm::dvec3 blended(const glm::dvec3& shaded) const;
    glm::dvec3 fogged(const glm::dvec3& shaded) const;

    const SurfaceCode& code_;
    const SurfaceBuffer* buffer_ = nullptr;
    std::size_t pixel_ = 0;
    Point point_{};
    std::vector<std::vector<double>> values_; ///< of the blocks, with what images made of them
    std::vector<reference::Filler> fillers_;
    const reference::Function* incidence_;
};

} // namespace patina
