// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string_view>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

/// Is the shading code of shaders/ compiled for the CPU in double precision: what the GPU's answers
/// are held against. Nothing else in the program compiles a block.
namespace patina::reference {

/// Holds the values of a block, packed by the catalogue's ParameterLayout.
using Parameters = std::span<const double>;

/// Says where a surface is lit and seen from. All unit, away from the surface; n, t, b orthogonal.
struct Geometry {
    glm::dvec3 n{0.0, 0.0, 1.0};
    glm::dvec3 t{1.0, 0.0, 0.0};
    glm::dvec3 b{0.0, 1.0, 0.0};
    glm::dvec3 l{0.0, 0.0, 1.0};
    glm::dvec3 v{0.0, 0.0, 1.0};
    glm::dvec2 pixel{0.0}; ///< place on the picture; where models that draw put their marks
};

/// Directions of any length made into a Geometry by the shaders' own functions: n, l and v are
/// normalised and t is made orthogonal to n. A zero n is +z, a zero l or v is n, and a zero t or
/// one along n becomes any tangent.
Geometry geometry(const glm::dvec3& n, const glm::dvec3& t, const glm::dvec3& l,
                  const glm::dvec3& v);

/// Holds what a light sends to a point.
struct Illumination {
    glm::dvec3 l{0.0, 0.0, 1.0}; ///< unit, towards the light
    glm::dvec3 radiance{0.0};    ///< E / pi
};

/// Holds the way from the eye to a surface.
struct FogRay {
    glm::dvec3 eye{0.0};
    glm::dvec3 direction{0.0, 0.0, -1.0}; ///< unit
    double range = 0.0;                   ///< metres, 0 or more
};

/// Holds a ray where it meets the surface of a transparent body.
struct Crossing {
    glm::dvec3 l{0.0, 0.0, 1.0}; ///< unit, from the surface to where the ray comes from
    glm::dvec3 n{0.0, 0.0, 1.0}; ///< unit normal on the side of l
    int channel = 1;             ///< 0, 1, 2: red, green, blue light
    bool leaves = false;         ///< from the body into what surrounds it
};

/// Represents an edge of a mesh as it is seen (shaders/lib/edge.glsl).
struct Edge {
    bool turns = false;
    bool ends = false;
    double bend = 0.0; ///< radians
};

/// Represents one packed field, as it was when the block was compiled.
struct Field {
    std::string_view name;
    std::size_t offset = 0; ///< in numbers
    int components = 1;

    friend bool operator==(const Field&, const Field&) = default;
};

struct Block;

/// Represents a compiled block with its values: what fills a slot.
struct Filler {
    const Block* block = nullptr;
    Parameters parameters; ///< block->size numbers, which must outlive it
};

/// Says what fills a model's slots, in any order: at most one of each kind. A slot without one is
/// black.
using Fillers = std::span<const Filler>;

/// Represents a function of a block, called with plain numbers: a vec3 is three of them, a struct
/// its fields in order.
struct BlockCall {
    std::string_view suffix; ///< of its name, after the block's
    std::size_t arguments = 0;
    std::size_t results = 0;
    void (*call)(const double* arguments, double* results, Parameters) = nullptr;
};

/// Holds a compiled block.
struct Block {
    std::string_view kind;
    std::string_view id;
    std::span<const Field> fields;
    std::size_t size = 0; ///< numbers its parameters take
    bool lightGate = true;
    bool viewGate = true;

    /// Is the function of Directions, where the kind has one.
    glm::dvec3 (*model)(const Geometry&, Parameters, Fillers) = nullptr;
    /// Are the other functions of the kind, in its order.
    std::span<const BlockCall> calls;

    // The functions of each kind with their types. Only those of the block's own may be called.
    glm::dvec3 fresnel(double c, double versine, Parameters) const;
    glm::dvec3 tint(Parameters) const;
    Illumination light(const glm::dvec3& x, Parameters) const;
    double fog(const FogRay& ray, Parameters) const;
    glm::dvec3 fogColor(Parameters) const;
    /// Returns what comes from the unit direction d, E / pi, and the picture's colour there.
    glm::dvec3 environment(const glm::dvec3& d, const glm::dvec3& picture, Parameters) const;
    /// Returns what a tone curve makes of linear light from 0.
    glm::dvec3 toned(const glm::dvec3& light, Parameters) const;
    /// Returns how much a surface at the depth 0 .. 1 counts.
    double transparency(double depth, double opacity, Parameters) const;
    /// Returns what refraction gives: the way on, the share mirrored, and what is left after so
    /// many metres.
    glm::dvec3 refract(const Crossing&, Parameters) const;
    double mirrored(const Crossing&, Parameters) const;
    glm::dvec3 left(double way, Parameters) const;
    /// Returns how wide an edge's lines are, in pixels: outside of the shape, and on it.
    glm::dvec2 outline(const Edge& edge, Parameters) const;
    glm::dvec3 lineColor(Parameters) const;

    /// Returns the function with a suffix, called with these numbers; `Count` of them come back.
    template <std::size_t Count>
    std::array<double, Count> call(std::string_view suffix, std::span<const double> arguments,
                                   Parameters parameters) const {
        std::array<double, Count> results{};
        findCall(suffix).call(arguments.data(), results.data(), parameters);
        return results;
    }
    const BlockCall& findCall(std::string_view suffix) const;
};

/// Returns every block, sorted by kind and id.
std::span<const Block> blocks();

/// Returns the block, or null.
const Block* findBlock(std::string_view kind, std::string_view id);

/// Returns what the model's function returns, with the gates its descriptor names and not yet cut
/// at 0: pi f cos(theta_l). `parameters` holds model.size numbers.
glm::dvec3 modelValue(const Block& model, const Geometry& geometry, Parameters parameters,
                      Fillers fillers = {});

/// modelValue cut at 0 from below, as lights are summed. A NaN stays one.
glm::dvec3 shade(const Block& model, const Geometry& geometry, Parameters parameters,
                 Fillers fillers = {});

/// Represents a function of shaders/lib/ called with plain numbers: a vec3 argument is three of
/// them, a struct its fields in order; out parameters are results after the returned value.
struct Function {
    std::string_view name;
    std::string_view signature; ///< as it is declared
    std::size_t arguments = 0;
    std::size_t results = 0;
    void (*call)(const double* arguments, double* results) = nullptr;
    std::string_view glslCall; ///< the same in GLSL: reads ARGUMENT(i), writes RESULT(i, x)
};

/// Returns every function of shaders/lib/, sorted by name. The elementary ones are the exact twins.
std::span<const Function> functions();

/// lib/elementary.glsl as it stands, its polynomials in double precision.
std::span<const Function> elementaryPolynomials();

/// By its name or the same in snake case ("ggx_d"); null where there is none.
const Function* findFunction(std::string_view name);

} // namespace patina::reference
