// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/lights/light_lists.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace patina {
namespace {

constexpr std::size_t wordBits = 64;

/// Directions and distances are rounded in the shader, so a light that misses by this much, in
/// radians or as a share of the range, counts as a hit.
constexpr double rangeMargin = 1e-4;

} // namespace

Ball ballAround(const Bounds& bounds, const glm::dmat4& world) {
    Ball ball;
    ball.center = glm::dvec3(world * glm::dvec4(glm::dvec3(bounds.center()), 1.0));
    for (int corner = 0; corner < 4; ++corner) { // the other four lie opposite
        const glm::dvec4 point((corner & 1) != 0 ? bounds.upper.x : bounds.lower.x,
                               (corner & 2) != 0 ? bounds.upper.y : bounds.lower.y, bounds.lower.z,
                               1.0);
        ball.radius = std::max(ball.radius, glm::distance(glm::dvec3(world * point), ball.center));
    }
    return ball;
}

Ball ballAround(const GroundPlace& ground) {
    return {ground.middle, 1.5 * ground.radius};
}

void LightLists::begin(const Scene& scene, const Catalog& catalog) {
    bounded_.clear();
    places_.assign(scene.lights.size(), 0);
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
        const Light& light = scene.lights[i];
        const Block* block = catalog.find(kinds::lights, light.block.id);
        if (block != nullptr) {
            add(i, light, *block);
        }
    }
    words_ = (bounded_.size() + wordBits - 1) / wordBits;
    bits_.assign(words_, ~std::uint64_t(0));
}

void LightLists::add(std::size_t index, const Light& light, const Block& block) {
    const LightReach reach = reachOf(light, block);
    if (!reach.isEverywhere()) {
        bounded_.push_back({index, reach});
        places_[index] = bounded_.size();
    }
}

/// A ball meets the cone when the angle between its middle and the axis is at most the cone's angle
/// plus half the angle that the ball fills, seen from the tip.
bool LightLists::reaches(const LightReach& light, const Ball& ball) {
    const glm::dvec3 way = ball.center - light.from;
    const double distance = glm::length(way);
    if (!(distance > ball.radius)) {
        return true;
    }
    if (light.range > 0.0 && distance - ball.radius > light.range * (1.0 + rangeMargin)) {
        return false;
    }
    if (!(light.angle > 0.0)) {
        return true;
    }
    const double off = std::acos(std::clamp(glm::dot(way / distance, light.axis), -1.0, 1.0));
    return off <= light.angle + std::asin(ball.radius / distance) + rangeMargin;
}

std::size_t LightLists::listFor(const Ball& ball) {
    if (bounded_.empty()) {
        return 0;
    }
    const std::size_t made = bits_.size();
    bits_.resize(made + words_, ~std::uint64_t(0));
    for (std::size_t i = 0; i < bounded_.size(); ++i) {
        if (!reaches(bounded_[i].reach, ball)) {
            bits_[made + i / wordBits] &= ~(std::uint64_t(1) << (i % wordBits));
        }
    }
    const auto newest = bits_.begin() + static_cast<std::ptrdiff_t>(made);
    for (std::size_t list = 0; list * words_ < made; ++list) {
        if (std::equal(newest, bits_.end(),
                       bits_.begin() + static_cast<std::ptrdiff_t>(list * words_))) {
            bits_.resize(made);
            return list;
        }
    }
    if (count() > maxCount) {
        bits_.resize(made);
        return 0;
    }
    return made / words_;
}

bool LightLists::holds(std::size_t list, std::size_t light) const {
    const std::size_t place = light < places_.size() ? places_[light] : 0;
    return place == 0 ||
           ((bits_[list * words_ + (place - 1) / wordBits] >> ((place - 1) % wordBits)) & 1) != 0;
}

LightSet LightLists::unreached(std::size_t list) const {
    LightSet lights;
    for (const Bounded& bounded : bounded_) {
        if (!holds(list, bounded.light)) {
            lights.add(bounded.light);
        }
    }
    return lights;
}

} // namespace patina
