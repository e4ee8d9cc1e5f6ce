// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <numbers>
#include <vector>

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "measure/error/parallel_job.h"

namespace patina {

/// Measures how different two pictures look to somebody who flips between them: P. Andersson, J.
/// Nilsson, T. Akenine-Möller, M. Oskarsson, K. Åström, M. D. Fairchild, FLIP: A Difference
/// Evaluator for Alternating Images, Proc. ACM Comput. Graph. Interact. Tech. 3(2), 2020. For
/// pictures of a display, which it compares as the eye filters them.
class Flip {
  public:
    /// Is that of a display 0.7 m wide with 3840 pixels, seen from 0.7 m.
    static constexpr double usualPixelsPerDegree = 3840.0 * std::numbers::pi / 180.0;

    /// `right`: sRGB values 0 .. 1, rows from the top.
    Flip(glm::ivec2 size, const std::vector<glm::dvec3>& right,
         double pixelsPerDegree = usualPixelsPerDegree);

    /// Makes the same, ready when `work` is done. Until then `right` and this must stay where they
    /// are.
    Flip(glm::ivec2 size, const std::vector<glm::dvec3>& right, ParallelJob& work,
         double pixelsPerDegree = usualPixelsPerDegree);

    /// Returns the difference of each pixel, 0 .. 1.
    std::vector<double> differences(const std::vector<glm::dvec3>& shown) const;

    /// Writes the same into `map`, by `work`. Until it is done all of them must stay where they
    /// are.
    void addDifferences(ParallelJob& work, const std::vector<glm::dvec3>& shown,
                        std::vector<double>& map) const;

  private:
    /// Holds what the eye makes of a picture.
    struct Seen {
        std::vector<glm::dvec3> colors; ///< filtered, in Hunt-adjusted L*a*b*
        std::vector<double> edges;      ///< how strong an edge is there
        std::vector<double> points;
    };

    Flip(glm::ivec2 size, double pixelsPerDegree);

    void addSeeing(ParallelJob& work, const std::vector<glm::dvec3>& shown, Seen& seen) const;
    double difference(const Seen& other, std::size_t pixel) const;

    glm::ivec2 size_;
    double pixelsPerDegree_;
    double farthest_; ///< the power of the distance of the two colours that are most apart
    Seen reference_;
};

} // namespace patina
