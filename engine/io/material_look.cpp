// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/material_look.h"

#include <algorithm>

#include <glm/common.hpp>

namespace patina {
namespace {

constexpr double dielectricF0 = 0.04; // of glTF 2.0, appendix B.2.1

glm::dvec3 alphaOf(double roughness) {
    constexpr double smallestAlpha = 1e-4;
    return glm::dvec3(std::clamp(roughness * roughness, smallestAlpha, 1.0));
}

} // namespace

void lookMetallicRough(MeshMaterial& material, const glm::dvec3& base, double metallic,
                       double roughness) {
    const glm::dvec3 color = glm::clamp(base, 0.0, 1.0);
    const bool isMetal = metallic >= 0.5;
    material.look = isMetal ? "metal" : "dielectric";
    material.values["diffuse"] = isMetal ? glm::dvec3(0.0) : color;
    material.values["f0"] = isMetal ? color : glm::dvec3(dielectricF0);
    material.values["alpha"] = alphaOf(roughness);
}

void lookMixed(MeshMaterial& material, const glm::dvec3& base, double metallic, double roughness) {
    material.look = "metallic-roughness";
    material.values["diffuse"] = glm::clamp(base, 0.0, 1.0);
    material.values["metalness"] = glm::dvec3(std::clamp(metallic, 0.0, 1.0));
    material.values["f0"] = glm::dvec3(dielectricF0);
    material.values["alpha"] = alphaOf(roughness);
}

} // namespace patina
