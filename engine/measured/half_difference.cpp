// SPDX-License-Identifier: GPL-3.0-or-later
#include "measured/half_difference.h"

#include <cmath>
#include <numbers>

#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

namespace patina {

double radicalInverse(std::size_t index, std::size_t base) {
    double result = 0.0;
    double digit = 1.0;
    for (; index > 0; index /= base) {
        digit /= double(base);
        result += digit * double(index % base);
    }
    return result;
}

HalfDifference halfDifference(const DirectionPair& pair) {
    const glm::dvec3 h = glm::normalize(pair.l + pair.v);
    const double sine = std::hypot(h.x, h.y);
    const double half = std::atan2(sine, h.z);
    const glm::dvec2 around = sine > 0.0 ? glm::dvec2(h) / sine : glm::dvec2(1.0, 0.0);
    // The light in the frame in which the half vector is z: turned back by the azimuth, then
    // tilted.
    const glm::dvec2 flat(around.x * pair.l.x + around.y * pair.l.y,
                          around.x * pair.l.y - around.y * pair.l.x);
    const glm::dvec3 d(flat.x * h.z - pair.l.z * sine, flat.y, flat.x * sine + pair.l.z * h.z);
    const double azimuth = std::atan2(d.y, d.x);
    return {half, std::atan2(std::hypot(d.x, d.y), d.z),
            azimuth < 0.0 ? azimuth + std::numbers::pi : azimuth};
}

DirectionPair directionsAt(const HalfDifference& angles) {
    const glm::dvec3 d(std::sin(angles.difference) * std::cos(angles.azimuth),
                       std::sin(angles.difference) * std::sin(angles.azimuth),
                       std::cos(angles.difference));
    const double c = std::cos(angles.half);
    const double s = std::sin(angles.half);
    const glm::dvec3 h(s, 0.0, c);
    const glm::dvec3 l(d.x * c + d.z * s, d.y, d.z * c - d.x * s);
    return {l, 2.0 * glm::dot(l, h) * h - l};
}

DirectionPair spreadPair(std::size_t index) {
    constexpr double pi = std::numbers::pi;
    const double root = radicalInverse(index, 2);
    const DirectionPair flat =
        directionsAt({root * root * 0.5 * pi, radicalInverse(index, 3) * 0.5 * pi,
                      radicalInverse(index, 5) * 2.0 * pi});
    const double azimuth = radicalInverse(index, 7) * 2.0 * pi;
    const auto turned = [azimuth](const glm::dvec3& v) {
        return glm::dvec3(v.x * std::cos(azimuth) - v.y * std::sin(azimuth),
                          v.x * std::sin(azimuth) + v.y * std::cos(azimuth), v.z);
    };
    return {turned(flat.l), turned(flat.v)};
}

} // namespace patina
