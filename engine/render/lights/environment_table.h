// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace patina {

/// Holds the distribution from which directions are sampled by the brightness of an environment, as
/// shaders/passes/environment_light.glsl reads it: a texture with a row for each row of directions
/// and one more. Red holds cumulative distributions, which end at 1: of a row's light over its
/// columns, and in the last row of all light over the rows. Green holds the density of each texel
/// over the unit square, computed from the rounded red numbers, so that it is exactly the density
/// of the samples.
class EnvironmentTable {
  public:
    /// Builds the table from the light of a panorama, rows from the top. It allocates only when the
    /// size is new. A hundredth of the samples is uniform, so that no light between two texels is
    /// missed; without any light all of them are.
    void build(glm::ivec2 size, std::span<const glm::vec4> radiance);

    /// Returns the cosine-weighted mean of the light from above, which a white matte surface facing
    /// up shows; linear.
    glm::dvec3 upward() const { return upward_; }

    glm::ivec2 size() const { return size_; } ///< is in columns and rows of directions
    glm::ivec2 textureSize() const;
    std::span<const glm::vec2> texels() const { return texels_; }

  private:
    double weigh(std::span<const glm::vec4> radiance);
    void fillRow(int row);
    void fillDensities();
    void gatherUpward(std::span<const glm::vec4> radiance);

    glm::ivec2 size_{0};
    std::vector<double> weights_; ///< has the weight of each texel
    std::vector<double> rows_;    ///< has the sum of the weights of each row
    std::vector<glm::vec2> texels_;
    glm::dvec3 upward_{0.0};
};

} // namespace patina
