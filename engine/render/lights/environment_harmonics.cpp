// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/lights/environment_harmonics.h"

#include <cmath>
#include <numbers>

#include <glm/common.hpp>
#include <glm/vector_relational.hpp>

namespace patina {
namespace {

using std::numbers::pi;

using Basis = std::array<double, 9>;

Basis basisAt(const glm::dvec3& d) {
    return {1.0,
            d.y,
            d.z,
            d.x,
            d.x * d.y,
            d.y * d.z,
            3.0 * d.z * d.z - 1.0,
            d.x * d.z,
            d.x * d.x - d.y * d.y};
}

/// Each factor is the squared normalization of a function times the factor of its order in a
/// convolution with the cosine over pi: 1, 2/3 and 1/4.
constexpr Basis factors{1.0 / (4.0 * pi),
                        2.0 / 3.0 * 3.0 / (4.0 * pi),
                        2.0 / 3.0 * 3.0 / (4.0 * pi),
                        2.0 / 3.0 * 3.0 / (4.0 * pi),
                        0.25 * 15.0 / (4.0 * pi),
                        0.25 * 15.0 / (4.0 * pi),
                        0.25 * 5.0 / (16.0 * pi),
                        0.25 * 15.0 / (4.0 * pi),
                        0.25 * 15.0 / (16.0 * pi)};

} // namespace

std::array<glm::vec3, 9> irradianceHarmonics(glm::ivec2 size, std::span<const glm::vec4> radiance) {
    std::array<glm::dvec3, 9> sums{};
    const auto columns = static_cast<std::size_t>(size.x);
    for (std::size_t i = 0; i < radiance.size(); ++i) {
        const std::size_t row = i / columns;
        const double from = pi * double(row) / size.y;
        const double to = pi * double(row + 1) / size.y;
        const double solidAngle = (std::cos(from) - std::cos(to)) * 2.0 * pi / size.x;
        const double down = 0.5 * (from + to);
        const double across = ((double(i % columns) + 0.5) / size.x - 0.5) * 2.0 * pi;
        const glm::dvec3 d(std::sin(down) * std::sin(across), std::cos(down),
                           -std::sin(down) * std::cos(across));
        const glm::dvec3 light(radiance[i]);
        if (glm::any(glm::isnan(light))) {
            continue;
        }
        const Basis basis = basisAt(d);
        for (std::size_t k = 0; k < basis.size(); ++k) {
            sums[k] += solidAngle * basis[k] * light;
        }
    }
    std::array<glm::vec3, 9> harmonics{};
    for (std::size_t k = 0; k < sums.size(); ++k) {
        harmonics[k] = glm::vec3(factors[k] * sums[k]);
    }
    return harmonics;
}

} // namespace patina
