// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include <glm/vec3.hpp>

#include "catalog/block.h"

namespace patina {

class SurfaceText;
struct EffectSet;
struct LightGroup;

/// Holds what a light's colour is multiplied by, linear, from 0.
struct LightColors {
    glm::dvec3 diffuse{1.0};   ///< where it meets the model's diffuse term
    glm::dvec3 highlight{1.0}; ///< where it meets the rest
    glm::dvec3 ambient{0.0};   ///< of the ambient light that it adds

    /// Tells whether the diffuse term and the highlight see different light than one without these
    /// colours.
    bool areSeparate() const { return diffuse != glm::dvec3(1.0) || highlight != glm::dvec3(1.0); }
    bool hasAmbient() const { return ambient != glm::dvec3(0.0); }

    friend bool operator==(const LightColors&, const LightColors&) = default;
};

/// Returns those of a light, by the roles of its parameters.
LightColors lightColors(const Block& light, const Values& values);

/// Holds how a light is polarised.
struct LightPolarisation {
    double degree = 0.0;                ///< 0 .. 1, the share that swings along one line
    glm::dvec3 direction{0.0, 1.0, 0.0}; ///< unit, in world space

    friend bool operator==(const LightPolarisation&, const LightPolarisation&) = default;
};

/// Returns that of a light, by the roles of its parameters.
LightPolarisation lightPolarisation(const Block& light, const Values& values);

/// Is the number of vec4s of a light's data that are no field of its block: diffuse, highlight,
/// ambient, and the direction and degree of its polarisation.
inline constexpr int lightColorVec4s = 4;

/// Writes what multiplies the light that the function `from` returns for a group's lights. `colors`
/// is where they lie behind a light's first vec4. Returns the name of the function to call in place
/// of `from`.
std::string writeSeparateColors(SurfaceText& text, const std::string& from, int colors);

/// Tells whether the program has a Fresnel term in the model that answers to polarised light, and
/// such light.
bool answersPolarisedLight(const EffectSet& set);

/// Returns a sentence where a Fresnel term of the model does not answer to such light, with a space
/// before it; else an empty text.
std::string polarisationNote(const EffectSet& set, const Block& fresnel);

/// Writes the Fresnel term of the model's slot once more, for polarised light: by its own function
/// for light that swings across the plane of incidence, else its reflectance times that of the
/// light over that of ordinary light, by the indices that its roles name.
void writePolarisedFresnel(SurfaceText& text, const Block& fresnel);

/// Writes the function that returns the ambient light of one of a group's lights, and returns its
/// name.
std::string writeLightAmbient(SurfaceText& text, const LightGroup& group, std::size_t index,
                              int colors);

} // namespace patina
