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
/// Evaluator for Alternating Images, Proc. ACM Comput. Graph. Interact. Tech. 3(2), 2020. It
/// compares display values after filtering them as the eye does.
class Flip {
  public:
    /// Is for a display 0.7 m wide with 3840 pixels, seen from 0.7 m.
    static constexpr double usualPixelsPerDegree = 3840.0 * std::numbers::pi / 180.0;

    /// Prepares comparisons with `right`: sRGB values 0 .. 1, rows from the top.
    Flip(glm::ivec2 size, const std::vector<glm::dvec3>& right,
         double pixelsPerDegree = usualPixelsPerDegree);

    /// Prepares the same in `work`. Until that is done, `right` and this object must not move.
    Flip(glm::ivec2 size, const std::vector<glm::dvec3>& right, ParallelJob& work,
         double pixelsPerDegree = usualPixelsPerDegree);

    /// Returns the difference of each pixel, 0 .. 1.
    std::vector<double> differences(const std::vector<glm::dvec3>& shown) const;

    /// Writes the difference of each pixel into `map` in `work`. Until that is done, the arguments
    /// and this object must not move.
    void addDifferences(ParallelJob& work, const std::vector<glm::dvec3>& shown,
                        std::vector<double>& map) const;

  private:
    /// Holds a picture as the eye filters it.
    struct Seen {
        std::vector<glm::dvec3> colors; ///< are filtered, in Hunt-adjusted L*a*b*
        std::vector<double> edges;      ///< are strengths of edges
        std::vector<double> points;     ///< are strengths of points
    };

    Flip(glm::ivec2 size, double pixelsPerDegree);

    void addSeeing(ParallelJob& work, const std::vector<glm::dvec3>& shown, Seen& seen) const;
    double difference(const Seen& other, std::size_t pixel) const;

    glm::ivec2 size_;
    double pixelsPerDegree_;
    double farthest_; ///< is the largest distance, of green and blue, to colorPower
    Seen reference_;
};

} // namespace patina
