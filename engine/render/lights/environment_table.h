// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

namespace patina {

/// Holds what directions are drawn from by the brightness of an environment, as
/// shaders/passes/environment_light.glsl reads it: a texture with a row for each row of directions
/// and one more. Red holds running shares, which end at 1: of a row's light up to a column, and in
/// the last row of all light up to a row. Green holds the density of each place over the unit
/// square, computed from the shares as they are stored, so that it is the one that is drawn from.
class EnvironmentTable {
  public:
    /// Builds the table from the light of a panorama, rows from the top. Allocates only when the
    /// size is new. A hundredth of the directions is drawn evenly, so that no light between two
    /// texels is missed; all of them are where there is no light.
    void build(glm::ivec2 size, std::span<const glm::vec4> radiance);

    /// The mean of the light from above, each direction counted by how upright it is: what a white
    /// matte surface that faces up shows.
    glm::dvec3 upward() const { return upward_; }

    glm::ivec2 size() const { return size_; } ///< columns and rows of directions
    glm::ivec2 textureSize() const;
    std::span<const glm::vec2> texels() const { return texels_; }

  private:
    double weigh(std::span<const glm::vec4> radiance);
    void fillRow(int row);
    void fillDensities();
    void gatherUpward(std::span<const glm::vec4> radiance);

    glm::ivec2 size_{0};
    std::vector<double> weights_; ///< of each place
    std::vector<double> rows_;    ///< of each row together
    std::vector<glm::vec2> texels_;
    glm::dvec3 upward_{0.0};
};

} // namespace patina
