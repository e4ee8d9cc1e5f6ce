// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <string_view>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

// This file gives access to the shading code of shaders/, compiled for the CPU in double precision.
// The GPU's answers are compared with it.
namespace patina::reference {

/// Holds the values of a block, packed by the catalogue's ParameterLayout.
using Parameters = std::span<const double>;

/// Says where a surface is lit and seen from. All vectors are unit and point away from the surface;
/// n, t and b are orthogonal.
struct Geometry {
    glm::dvec3 n{0.0, 0.0, 1.0};
    glm::dvec3 t{1.0, 0.0, 0.0};
    glm::dvec3 b{0.0, 1.0, 0.0};
    glm::dvec3 l{0.0, 0.0, 1.0};
    glm::dvec3 v{0.0, 0.0, 1.0};
    glm::dvec2 pixel{0.0}; ///< is the place on the picture, for models that draw marks
};

/// Makes a Geometry of directions of any length by the shaders' own functions: n, l and v are
/// normalised and t is made orthogonal to n. A zero n becomes +z, a zero l or v becomes n, and a
/// zero t or one along n becomes any tangent.
Geometry geometry(const glm::dvec3& n, const glm::dvec3& t, const glm::dvec3& l,
                  const glm::dvec3& v);

/// Holds what a light sends to a point.
struct Illumination {
    glm::dvec3 l{0.0, 0.0, 1.0}; ///< unit, towards the light
    glm::dvec3 radiance{0.0};    ///< is the irradiance over pi
};

/// Holds the straight path from the eye to a surface.
struct FogRay {
    glm::dvec3 eye{0.0};
    glm::dvec3 direction{0.0, 0.0, -1.0}; ///< unit
    double range = 0.0;                   ///< metres, 0 or more
};

/// Holds a ray where it meets the surface of a transparent body.
struct Interface {
    glm::dvec3 l{0.0, 0.0, 1.0}; ///< unit, from the surface to where the ray comes from
    glm::dvec3 n{0.0, 0.0, 1.0}; ///< unit normal on the side of l
    int channel = 1;             ///< 0, 1, 2: red, green, blue light
    bool leaves = false;         ///< says that it goes on out of the body
};

/// Describes an edge of a mesh as it is seen (shaders/lib/edge.glsl).
struct Edge {
    bool silhouette = false;
    bool open = false;
    double dihedral = 0.0; ///< radians
};

/// Describes one packed field as it was when the block was compiled.
struct Field {
    std::string_view name;
    std::size_t offset = 0; ///< counts numbers from the first
    int components = 1;

    friend bool operator==(const Field&, const Field&) = default;
};

struct Block;

/// Holds a compiled block with its values, which fills a slot.
struct Filler {
    const Block* block = nullptr;
    Parameters parameters; ///< block->size numbers, which must outlive it
};

/// Lists what fills a model's slots, in any order and at most one of each kind. An empty slot is
/// black.
using Fillers = std::span<const Filler>;

/// Calls a function of a block with plain numbers: a vec3 is three of them, a struct its fields in
/// order.
struct BlockCall {
    std::string_view suffix; ///< follows the block's name in the function's
    std::size_t arguments = 0;
    std::size_t results = 0;
    void (*call)(const double* arguments, double* results, Parameters) = nullptr;
};

/// Calls a function by which a model tells a factor of its highlight: one of Directions whose name
/// is the model's with a suffix of factorSuffixes.
struct ModelFactor {
    std::string_view suffix;
    /// Returns the factor, in all three channels where it is one number.
    glm::dvec3 (*call)(const Geometry&, Parameters, Fillers) = nullptr;
};

/// Lists how functions that tell a factor end: the distribution of facets in 1/sr, and the share of
/// them that is neither shadowed nor masked.
inline constexpr std::string_view factorSuffixes[] = {"Distribution", "Masking"};

/// Ends the name of a function by which a Fresnel block tells the index of each channel that it
/// works out from its values; not every block has one.
inline constexpr std::string_view indicesSuffix = "Indices";

/// Ends the name of a function by which a Fresnel block tells what it reflects of light that swings
/// across the plane of incidence, where the roles of its parameters do not.
inline constexpr std::string_view acrossSuffix = "Across";

/// Holds a compiled block.
struct Block {
    std::string_view kind;
    std::string_view id;
    std::span<const Field> fields;
    std::size_t size = 0; ///< is how many numbers its parameters take
    bool lightGate = true;
    bool viewGate = true;

    /// Is the function of Directions; null where the kind has none.
    glm::dvec3 (*model)(const Geometry&, Parameters, Fillers) = nullptr;
    /// Holds the other functions of the kind, in the kind's order, and then those that not every
    /// block has.
    std::span<const BlockCall> calls;
    /// Holds the factors that a model tells; often none.
    std::span<const ModelFactor> factors;

    // These are the functions of each kind with their types. Only those of the block's own kind may
    // be called.
    glm::dvec3 fresnel(double c, double versine, Parameters) const;
    glm::dvec3 tint(Parameters) const;
    Illumination light(const glm::dvec3& x, Parameters) const;
    double fog(const FogRay& ray, Parameters) const;
    glm::dvec3 fogColor(Parameters) const;
    /// Returns the irradiance over pi from the unit direction d, where the picture has this colour.
    glm::dvec3 environment(const glm::dvec3& d, const glm::dvec3& picture, Parameters) const;
    /// Returns linear light, 0 or more, after the tone curve.
    glm::dvec3 toned(const glm::dvec3& light, Parameters) const;
    /// Returns the weight of a surface at the depth 0 .. 1.
    double transparency(double depth, double opacity, Parameters) const;
    /// Returns the direction in which the ray goes on.
    glm::dvec3 refract(const Interface&, Parameters) const;
    /// Returns the share of light that is reflected.
    double mirrored(const Interface&, Parameters) const;
    /// Returns the share of light that is left after so many metres inside the body.
    glm::dvec3 left(double way, Parameters) const;
    /// Returns the widths of an edge's lines outside of the shape and on it, in pixels.
    glm::dvec2 outline(const Edge& edge, Parameters) const;
    glm::dvec3 lineColor(Parameters) const;

    /// Calls the function with a suffix and returns its `Count` results. The block must have it.
    template <std::size_t Count>
    std::array<double, Count> call(std::string_view suffix, std::span<const double> arguments,
                                   Parameters parameters) const {
        std::array<double, Count> results{};
        findCall(suffix).call(arguments.data(), results.data(), parameters);
        return results;
    }
    const BlockCall& findCall(std::string_view suffix) const;
    /// Returns the function with a suffix, or null.
    const BlockCall* optionalCall(std::string_view suffix) const;
    /// Returns the factor with a suffix, or null.
    const ModelFactor* findFactor(std::string_view suffix) const;
};

/// Returns every block, sorted by kind and id.
std::span<const Block> blocks();

/// Returns the block, or null.
const Block* findBlock(std::string_view kind, std::string_view id);

/// Returns what the model's function returns, with the gates its descriptor names and not yet cut
/// at 0: pi f cos(theta_l). `parameters` holds model.size numbers.
glm::dvec3 modelValue(const Block& model, const Geometry& geometry, Parameters parameters,
                      Fillers fillers = {});

/// Returns modelValue() with what is below 0 raised to 0, as lights are summed. A NaN stays one.
glm::dvec3 shade(const Block& model, const Geometry& geometry, Parameters parameters,
                 Fillers fillers = {});

/// Calls a function of shaders/lib/ with plain numbers: a vec3 argument is three of them, a struct
/// its fields in order; out parameters are results after the returned value.
struct Function {
    std::string_view name;
    std::string_view signature; ///< is its declaration
    std::size_t arguments = 0;
    std::size_t results = 0;
    void (*call)(const double* arguments, double* results) = nullptr;
    std::string_view glslCall; ///< calls it in GLSL: reads ARGUMENT(i), writes RESULT(i, x)
};

/// Returns every function of shaders/lib/, sorted by name. Those of elementary.glsl are the exact
/// ones of elementary.h.
std::span<const Function> functions();

/// Returns the functions of lib/elementary.glsl themselves, whose polynomials are evaluated in
/// double precision.
std::span<const Function> elementaryPolynomials();

/// Returns the function of shaders/lib/ by its name or the same in snake case ("ggx_d"); null where
/// there is none.
const Function* findFunction(std::string_view name);

} // namespace patina::reference
