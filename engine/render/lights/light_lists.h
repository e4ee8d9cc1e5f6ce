// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include <glm/mat4x4.hpp>

#include "catalog/catalog.h"
#include "core/mesh.h"
#include "render/lights/ground_place.h"
#include "scene/scene.h"
#include "shading/effects/light_reach.h"
#include "shading/effects/light_set.h"

namespace patina {

/// Represents a ball that holds an object or the ground, in world space.
struct Ball {
    glm::dvec3 center{0.0};
    double radius = 0.0;
};

/// Returns the ball around a box of object space.
Ball ballAround(const Bounds& bounds, const glm::dmat4& world);

/// Returns the ball around the ground's square.
Ball ballAround(const GroundPlace& ground);

/// Knows which of a scene's lights reach which objects, by what the lights' descriptors say of
/// their reach: a light is on the list of every object that it may reach. Objects that are reached
/// by the same lights share a list. Keeps its memory from frame to frame.
class LightLists {
  public:
    /// Begins a new frame: only the list with all lights is there, number 0.
    void begin(const Scene& scene, const Catalog& catalog);

    /// Returns the number of the list for an object. There are at most `most` of them; objects
    /// beyond get the list with all lights.
    std::size_t listFor(const Ball& ball);
    static constexpr std::size_t maxCount = 64;

    bool holds(std::size_t list, std::size_t light) const;

    /// Returns the lights that are not on the list.
    LightSet unreached(std::size_t list) const;

    /// Tells whether every object has all lights.
    bool isOne() const { return bounded_.empty(); }

    std::size_t count() const { return words_ == 0 ? 1 : bits_.size() / words_; }

  private:
    /// A light that does not reach everything.
    struct Bounded {
        std::size_t light = 0;
        LightReach reach;
    };

    void add(std::size_t index, const Light& light, const Block& block);
    static bool reaches(const LightReach& light, const Ball& ball);

    std::vector<Bounded> bounded_;
    std::vector<std::size_t> places_; ///< by light: its place in bounded_ + 1, or 0
    std::size_t words_ = 0;           ///< per list
    std::vector<std::uint64_t> bits_; ///< of all lists: whether a bounded light is on it
};

} // namespace patina
