// SPDX-License-Identifier: GPL-3.0-or-later
#include "shading/effects/light_reach.h"

#include <algorithm>
#include <string>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "shading/program/given_value.h"

namespace patina {
namespace {

/// Returns a value that a descriptor's reach names; `none` where it names nothing.
template <class T>
T valueOf(const Block& block, const Values& values, const std::string& id, T none) {
    const Parameter* parameter = id.empty() ? nullptr : block.parameter(id);
    const T* held =
        parameter == nullptr ? nullptr : std::get_if<T>(&givenValue(*parameter, values));
    return held != nullptr && isFinite(Value(*held)) ? *held : none;
}

} // namespace

LightReach reachOf(const Light& light, const Block& block) {
    LightReach bounds;
    if (!block.reach) {
        return bounds;
    }
    const Reach& reach = *block.reach;
    const Values& values = light.block.parameters;
    bounds.from = valueOf(block, values, reach.from, glm::dvec3(0.0));
    bounds.range = std::max(valueOf(block, values, reach.range, 0.0), 0.0);
    const glm::dvec3 axis = valueOf(block, values, reach.axis, glm::dvec3(0.0));
    if (glm::length(axis) > 0.0) {
        bounds.axis = glm::normalize(axis);
        bounds.angle = glm::radians(std::max(valueOf(block, values, reach.angle, 0.0), 0.0));
    }
    return bounds;
}

} // namespace patina
