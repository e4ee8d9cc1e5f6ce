// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/stability/edge_case_directions.h"

#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>
#include <random>

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace patina {
namespace {

using Subject = EvalCase::Subject;
using Places = std::vector<EvalPlace>;

/// Is the smallest float that devices do not flush to 0.
constexpr double smallestFloat = std::numeric_limits<float>::min();

constexpr double cosines[] = {0.0,  smallestFloat, 1e-30,      6e-17,      1e-12,      1e-8,
                              1e-6, 1e-4,          1e-2,       0.1,        0.3,        0.5,
                              0.7,  0.9,           1.0 - 1e-4, 1.0 - 1e-6, 1.0 - 1e-8, 1.0};

/// Are angles between light and viewer, in radians; pi is the mirror's side.
constexpr double azimuths[] = {0.0,
                               1e-7,
                               1e-4,
                               0.5,
                               std::numbers::pi / 2,
                               2.0,
                               std::numbers::pi - 1e-4,
                               std::numbers::pi - 1e-7,
                               std::numbers::pi};

/// Are azimuths of the light from the tangent, in radians: along it, along the bitangent and
/// between.
constexpr double tangentAngles[] = {0.0, std::numbers::pi / 2, 0.7, 1e-6};

glm::dvec3 inFloat(const glm::dvec3& v) {
    return glm::dvec3(glm::vec3(v));
}

double inFloat(double x) {
    return static_cast<double>(static_cast<float>(x));
}

/// Returns the direction at a cosine, exact in float. The sine is computed from the double: a
/// cosine of 1 - 1e-8 is 1 in float, but its sine is not 0.
glm::dvec3 direction(double c, double azimuth) {
    const double s = std::sqrt(std::max(0.0, (1.0 - std::abs(c)) * (1.0 + std::abs(c))));
    return inFloat(glm::dvec3(s * std::cos(azimuth), s * std::sin(azimuth), c));
}

EvalPlace upright(const glm::dvec3& l, const glm::dvec3& v) {
    EvalPlace place;
    place.l = l;
    place.v = v;
    return place;
}

/// Returns every pair of cosines with every azimuth; one in five is repeated with the light, the
/// viewer and both below the horizon.
Places uprightPlaces() {
    Places places;
    std::size_t count = 0;
    for (const double cl : cosines) {
        for (const double cv : cosines) {
            for (const double azimuth : azimuths) {
                const double turn = tangentAngles[count++ % std::size(tangentAngles)];
                const glm::dvec3 l = direction(cl, turn);
                const glm::dvec3 v = direction(cv, turn + azimuth);
                places.push_back(upright(l, v));
                if (count % 5 == 0) {
                    const glm::dvec3 flip{1.0, 1.0, -1.0};
                    places.push_back(upright(l * flip, v));
                    places.push_back(upright(l, v * flip));
                    places.push_back(upright(l * flip, v * flip));
                }
            }
        }
    }
    return places;
}

/// Adds l = v, l = -v and the exact mirror direction, and places slightly off each.
void addRelated(Places& places) {
    constexpr double offsets[] = {0.0, 1e-8, 1e-6, 1e-4, 1e-2};
    for (const double c : cosines) {
        for (const double turn : tangentAngles) {
            const glm::dvec3 l = direction(c, turn);
            for (const glm::dvec3& base : {l, -l, glm::dvec3(-l.x, -l.y, l.z)}) {
                for (const double offset : offsets) {
                    places.push_back(upright(l, inFloat(base + glm::dvec3(offset, -offset, 0.0))));
                    places.push_back(upright(-l, inFloat(base + glm::dvec3(0.0, 0.0, offset))));
                }
            }
        }
    }
}

/// Returns the place turned so that its normal is `normal`, which is no axis: cosines then have
/// roundings.
EvalPlace slanted(const EvalPlace& place, const glm::dvec3& normal) {
    const glm::dvec3 n = glm::normalize(normal);
    const glm::dvec3 t = glm::normalize(glm::cross(glm::dvec3(0.0, 1.0, 0.3), n));
    const glm::dvec3 b = glm::cross(n, t);
    const auto turned = [&](const glm::dvec3& v) { return inFloat(v.x * t + v.y * b + v.z * n); };
    EvalPlace result = place;
    result.n = inFloat(n);
    result.t = inFloat(t);
    result.l = turned(place.l);
    result.v = turned(place.v);
    return result;
}

/// Adds every ninth place about slanting normals, and every seventh with a tangent along the
/// normal, next to it, or of an extreme length.
void addFrames(Places& places) {
    const std::size_t count = places.size();
    for (std::size_t i = 0; i < count; i += 9) {
        places.push_back(slanted(places[i], {0.3, -0.5, 0.7}));
        places.push_back(slanted(places[i], {-1.0, 1e-4, -2e-3}));
    }
    constexpr glm::dvec3 tangents[] = {{0.0, 0.0, 1.0},
                                       {1e-7, 0.0, 1.0},
                                       {1e-3, 1e-3, -1.0},
                                       {1e-20, 1e-20, 0.0},
                                       {0.0, 3e4, 1.0}};
    for (std::size_t i = 0; i < count; i += 7) {
        EvalPlace& place = places.emplace_back(places[i]);
        place.t = inFloat(tangents[i / 7 % std::size(tangents)]);
    }
}

Places edgeCaseModelDirections() {
    Places places = uprightPlaces();
    addRelated(places);
    addFrames(places);
    return places;
}

Places edgeCaseNumbers(std::initializer_list<double> more) {
    Places places;
    const auto add = [&places](double x) { places.emplace_back().number = inFloat(x); };
    for (const double c : cosines) {
        add(c);
        add(0.3 + 0.7 * c);
    }
    for (const double x : more) {
        add(x);
    }
    return places;
}

Places edgeCasePoints() {
    constexpr double steps[] = {0.0, 1e-35, 1e-20, 1e-6, 1.0, -1.0, -1e6, 1e6};
    Places places;
    for (const double x : steps) {
        for (const double y : steps) {
            for (const double z : steps) {
                places.emplace_back().l = inFloat(glm::dvec3(x, y, z));
            }
        }
    }
    return places;
}

/// Returns distances, each from several eyes and in several directions, some along an axis or next
/// to it.
Places edgeCaseRays() {
    constexpr glm::dvec3 eyes[] = {{0.0, 0.0, 0.0},  {0.5, -1.0, 2.0},  {2.0, 0.5, 2.0},
                                   {1e3, 1e3, -1e3}, {1e-20, 5.0, 0.0}, {0.0, -1e6, 1e6}};
    const glm::dvec3 slanting = glm::normalize(glm::dvec3(-0.3, -0.8, 0.5));
    const glm::dvec3 directions[] = {{0.0, 0.0, -1.0}, {0.0, 1.0, 0.0},   {-1.0, 0.0, 0.0},
                                     {0.0, -1.0, 0.0}, {1e-7, 1e-7, 1.0}, {1.0, 1e-30, -1e-4},
                                     slanting,         -slanting};
    Places places;
    for (const EvalPlace& far :
         edgeCaseNumbers({1e-30, 1e-3, 2.0, 10.0, 1e2, 1e3, 1e6, 1e20, 3e38})) {
        for (const glm::dvec3& eye : eyes) {
            for (const glm::dvec3& direction : directions) {
                EvalPlace& place = places.emplace_back(far);
                place.l = inFloat(eye);
                place.v = inFloat(direction);
            }
        }
    }
    return places;
}

/// Draws numbers from a fixed random sequence, so that every call gets the same ones.
class Random {
  public:
    double uniform(double low, double high) {
        return std::uniform_real_distribution(low, high)(engine_);
    }
    std::size_t below(std::size_t count) { return engine_() % count; }

    glm::dvec3 point() {
        const double x = uniform(-ordinaryReach, ordinaryReach);
        const double y = uniform(-ordinaryReach, ordinaryReach);
        return inFloat(glm::dvec3(x, y, uniform(-ordinaryReach, ordinaryReach)));
    }

    glm::dvec3 upperDirection() {
        const double c = uniform(0.05, 1.0);
        const double phi = uniform(0.0, 2.0 * std::numbers::pi);
        const double s = std::sqrt(1.0 - c * c);
        return inFloat(glm::dvec3(s * std::cos(phi), s * std::sin(phi), c));
    }

    /// Returns the mirror direction of l, up to 0.1 off in x and y, with a cosine of about 0.05 at
    /// least.
    glm::dvec3 nearMirror(const glm::dvec3& l) {
        const glm::dvec3 off{uniform(-0.1, 0.1), uniform(-0.1, 0.1), 0.0};
        glm::dvec3 v = glm::normalize(glm::dvec3(-l.x, -l.y, l.z) + off);
        v = v.z < 0.05 ? glm::normalize(glm::dvec3(v.x, v.y, 0.06)) : v;
        return inFloat(v);
    }

  private:
    std::mt19937 engine_{20251121};
};

EvalPlace ordinaryPlace(Subject subject, Random& random) {
    EvalPlace place;
    switch (subject) {
    case Subject::Model:
        place.l = random.upperDirection();
        place.v = random.below(3) == 0 ? random.nearMirror(place.l) : random.upperDirection();
        place.pixel = {inFloat(random.uniform(0, 24)), inFloat(random.uniform(0, 24))};
        break;
    case Subject::Light:
        place.l = random.point();
        break;
    case Subject::Fresnel:
        place.number = inFloat(random.uniform(0.05, 1.0));
        break;
    default:
        place.number = inFloat(random.uniform(0.0, ordinaryReach));
        place.l = random.point();
        place.v = random.upperDirection();
    }
    return place;
}

} // namespace

Places edgeCaseDirections(Subject subject) {
    switch (subject) {
    case Subject::Model:
        return edgeCaseModelDirections();
    case Subject::Light:
        return edgeCasePoints();
    case Subject::Fresnel:
        return edgeCaseNumbers({-1.0, -1e-8, 1.0 + 1e-6, 1e-3, 0.05, 0.2, 0.8});
    default:
        return edgeCaseRays();
    }
}

Places ordinaryPlaces(Subject subject, std::size_t count) {
    Random random;
    Places places;
    for (std::size_t i = 0; i < count; ++i) {
        places.push_back(ordinaryPlace(subject, random));
    }
    return places;
}

} // namespace patina
