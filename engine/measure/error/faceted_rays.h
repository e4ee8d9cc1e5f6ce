// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include <glm/vec3.hpp>

#include "catalog/catalog.h"
#include "core/error.h"
#include "reference/reference.h"
#include "render/surfaces/surface_buffer.h"
#include "render/view.h"

namespace patina {

/// Holds what is around the surfaces of a buffer.
struct BufferedScene {
    const Scene& scene;
    const View& view;
    const MeshSource& meshes;
    const Catalog& catalog;
};

/// Follows the rays of a pixel through a convex body of flat facets in double precision: those that
/// passes/refraction_facets*.glsl follow on the device, up to as many reflections inside, but
/// without leaving out what is faint.
class FacetedRays {
  public:
    /// Takes all that it needs of the object with an index and of what is around it. An error says
    /// why such rays are not what the object shows.
    static Result<FacetedRays> of(const BufferedObject& object, std::size_t index,
                                  const BufferedScene& around);

    /// Returns what the ray of a round of an environment's directions sees at a pixel that shows
    /// the body; without an environment there is one ray through the middle of each pixel.
    glm::dvec3 seen(const SurfaceBuffer& buffer, std::size_t pixel, std::uint32_t round) const;

    /// Tells whether each round has another ray.
    bool isSampled() const { return sky_.code != nullptr; }

  private:
    /// Is a plane in the world: x on it has dot(n, x) = offset, and n points outward.
    struct Plane {
        glm::dvec3 n{0.0};
        double offset = 0.0;
    };
    /// Is light that has a ray of its own: the values that the body's functions get for it, its
    /// channel, and what it adds to each.
    struct Light {
        std::vector<double> values;
        int channel = 1;
        glm::dvec3 shares{1.0};
    };
    struct Sky {
        const reference::Block* code = nullptr; ///< is null where the background is all there is
        std::vector<double> values;
        double cosine = 1.0; ///< of its rotation
        double sine = 0.0;
        double limit = 0.0; ///< 0: there is none
    };
    struct Start {
        glm::dvec3 x;
        glm::dvec3 n;
        glm::dvec3 v;
    };

    Result<void> takeBody(const Object& object, const BufferedScene& around);
    void takeLights(const BufferedObject& object, const Material& material, const Scene& scene);
    Result<void> takeSky(const BufferedScene& around);
    const Plane& facetAt(const glm::dvec3& x, const glm::dvec3& n) const;
    Start start(const SurfaceBuffer& buffer, std::size_t pixel, std::uint32_t round) const;
    const Plane* next(const glm::dvec3& x, const glm::dvec3& d, double& way) const;
    glm::dvec3 inside(glm::dvec3 x, glm::dvec3 d, const Light& light) const;
    glm::dvec3 far(const glm::dvec3& d) const;

    const reference::Block* body_ = nullptr;
    int reflections_ = 0;
    std::vector<Plane> planes_;
    double size_ = 1.0; ///< metres, across the body
    std::vector<Light> lights_;
    Sky sky_;
    glm::dvec3 background_{0.0};
    glm::dvec3 eye_{0.0};
    glm::dvec3 right_{0.0};  ///< is the way of a pixel to the right, one metre before the eye
    glm::dvec3 up_{0.0};     ///< is the same upwards
    glm::dvec3 before_{0.0}; ///< is unit, to the middle of the picture
    std::uint32_t series_ = 0;
};

} // namespace patina
