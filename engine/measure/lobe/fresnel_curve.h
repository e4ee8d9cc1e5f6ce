// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <vector>

#include <glm/vec3.hpp>
#include <glm/vector_relational.hpp>

#include "material/material.h"

namespace patina {

/// Is a smooth surface between two media, per channel.
struct OpticalInterface {
    double outside = 1.0;       ///< is the index on the viewer's side
    glm::dvec3 index{1.5};      ///< is the index on the other side
    glm::dvec3 extinction{0.0}; ///< is the extinction coefficient there; 0: the medium is clear
    /// Says that the block knows only what is reflected facing the surface, and the index is that
    /// of the clear medium which reflects so much.
    bool isFromReflectance = false;

    bool isClear() const { return extinction == glm::dvec3(0.0); }
    /// Says that light can come from the other side.
    bool letsLightOut() const {
        return isClear() && glm::all(glm::greaterThan(index, glm::dvec3(0.0)));
    }
};

/// Is what an interface reflects of light that is polarised across (s) and in (p) the plane of
/// incidence. What is not reflected is transmitted, and by a metal absorbed.
struct PolarisedPoint {
    double angle = 0.0; ///< radians from the normal
    glm::dvec3 s{0.0};
    glm::dvec3 p{0.0};

    glm::dvec3 mean() const { return 0.5 * (s + p); } ///< is of ordinary light
};

/// Is an interface for light from one of its sides.
struct InterfaceSide {
    std::vector<PolarisedPoint> points; ///< from 0 to pi/2
    /// Is the angle at which p-polarised light is not reflected, in radians.
    glm::dvec3 brewster{0.0};
    /// Is the angle from which on all is reflected, in radians; pi/2 where there is none.
    glm::dvec3 critical{0.0};
};

/// Is what a Fresnel block returns for one angle.
struct FresnelPoint {
    double angle = 0.0; ///< radians from the normal
    glm::dvec3 chosen{0.0};
    glm::dvec3 exact{0.0}; ///< with every accuracy choice at its exact level
};

/// Holds the curves of a material's Fresnel term.
struct FresnelCurves {
    std::string label; ///< is the block's
    std::vector<FresnelPoint> term;
    std::optional<OpticalInterface> media; ///< is empty where the block knows no index
    InterfaceSide fromOutside;             ///< is empty without media
    InterfaceSide fromInside; ///< is empty without media, and where letsLightOut() is not
};

/// Returns the media that a Fresnel block describes: by the roles of its parameters, or by the
/// indices that it works out from them.
std::optional<OpticalInterface> interfaceOf(const Block& fresnel, const Values& values);

/// Returns the reflectances of an interface. `fromInside` takes light from the other side, which
/// must let light out.
PolarisedPoint reflectedAt(const OpticalInterface& media, double angle, bool fromInside = false);

/// Returns the curves of the Fresnel term that fills the model's slot or is blended over its light.
/// It is an error where there is none, or none with code in double precision.
Result<FresnelCurves> fresnelCurves(const Catalog& catalog, const Material& material);

} // namespace patina
