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

/// Is a bounding sphere of an object or of the ground, in world space.
struct Ball {
    glm::dvec3 center{0.0};
    double radius = 0.0;
};

/// Returns the bounding sphere of a box of object space.
Ball ballAround(const Bounds& bounds, const glm::dmat4& world);

/// Returns the bounding sphere of the ground's square.
Ball ballAround(const GroundPlace& ground);

/// Knows which lights of a scene reach which objects, from the reach in the lights' descriptors: a
/// light is on the list of every object that it may reach. Objects that the same lights reach share
/// a list. It keeps its memory from frame to frame.
class LightLists {
  public:
    /// Begins a frame with one list, number 0, which has all lights.
    void begin(const Scene& scene, const Catalog& catalog);

    /// Returns the number of the list for an object. There are at most `maxCount` lists besides
    /// number 0; when they are used up, an object gets number 0.
    std::size_t listFor(const Ball& ball);
    static constexpr std::size_t maxCount = 64;

    bool holds(std::size_t list, std::size_t light) const;

    /// Returns the lights that are not on the list.
    LightSet unreached(std::size_t list) const;

    /// Returns true when every object has all lights.
    bool isOne() const { return bounded_.empty(); }

    std::size_t count() const { return words_ == 0 ? 1 : bits_.size() / words_; }

  private:
    /// Is a light that does not reach everything.
    struct Bounded {
        std::size_t light = 0;
        LightReach reach;
    };

    void add(std::size_t index, const Light& light, const Block& block);
    static bool reaches(const LightReach& light, const Ball& ball);

    std::vector<Bounded> bounded_;
    std::vector<std::size_t> places_; ///< has for each light its index in bounded_ + 1; 0 if it is
                                      ///< not there
    std::size_t words_ = 0;           ///< is the number of words per list in bits_
    std::vector<std::uint64_t> bits_; ///< has a bit for each list and bounded light, 1 if the light
                                      ///< is on the list
};

} // namespace patina
