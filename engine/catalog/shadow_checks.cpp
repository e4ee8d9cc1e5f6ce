// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/shadow_checks.h"

#include <algorithm>

namespace patina {
namespace {

bool hasSpace(const Block& block, Space world, Space camera) {
    return std::any_of(block.parameters.begin(), block.parameters.end(),
                       [=](const Parameter& p) { return p.space == world || p.space == camera; });
}

bool hasAngle(const Block& block) {
    return std::any_of(block.parameters.begin(), block.parameters.end(),
                       [](const Parameter& p) { return infoOf(p.type).isAngle; });
}

} // namespace

Errors shadowMistakes(const Descriptor& descriptor) {
    const Block& block = descriptor.block;
    const ShadowProjection projection = block.shadowProjection;
    const bool isCone = projection == ShadowProjection::Cone;
    Errors errors;
    const auto add = [&](const char* problem, const char* expected) {
        errors.push_back(descriptor.document.error("/shadowProjection", problem, expected));
    };
    if (projection != ShadowProjection::None && block.kind != kinds::lights) {
        add("only a light casts shadows", "no such key");
    }
    if ((isCone || projection == ShadowProjection::Sphere) &&
        !hasSpace(block, Space::WorldPoint, Space::CameraPoint)) {
        add("the light has no place", "a vec3 whose space is worldPoint or cameraPoint");
    }
    if ((isCone || projection == ShadowProjection::Parallel) &&
        !hasSpace(block, Space::WorldDirection, Space::CameraDirection)) {
        add("the light has no direction",
            "a vec3 whose space is worldDirection or cameraDirection");
    }
    if (isCone && !hasAngle(block)) {
        add("the light has no angle", "a parameter of type angle");
    }
    return errors;
}

} // namespace patina
