// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/lobe/reflectance_table.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace patina {
namespace {

constexpr int probeCount = 400;
constexpr double lowestProbe = 0.05; ///< is the least cosine at which values are compared

double largestPart(const glm::dvec3& v) {
    return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

/// Returns the tangent that is turned in the surface.
glm::dvec3 turnedTangent(double degrees) {
    const double angle = degrees * std::numbers::pi / 180.0;
    return {std::cos(angle), std::sin(angle), 0.0};
}

/// Returns a direction turned about a unit axis.
glm::dvec3 turned(const glm::dvec3& d, const glm::dvec3& axis, double angle) {
    const glm::dvec3 along = glm::dot(d, axis) * axis;
    return along + std::cos(angle) * (d - along) + std::sin(angle) * glm::cross(axis, d);
}

/// Draws directions above the surface, the same for every table.
class ProbeDirections {
  public:
    glm::dvec3 any() {
        const double z = lowestProbe + (1.0 - lowestProbe) * share_(random_);
        const double s = std::sqrt(1.0 - z * z);
        const double phi = turn();
        return {s * std::cos(phi), s * std::sin(phi), z};
    }

    /// Returns another direction with the same number on the axes.
    glm::dvec3 alike(const glm::dvec3& d, TableAxes axes, const glm::dvec3& t) {
        if (axes == TableAxes::NormalCosines) {
            return turned(d, {0.0, 0.0, 1.0}, turn());
        }
        constexpr int tries = 40;
        for (int i = 0; i < tries; ++i) {
            const glm::dvec3 other = turned(d, t, turn());
            if (other.z > lowestProbe) {
                return other;
            }
        }
        return d;
    }

  private:
    double turn() { return 2.0 * std::numbers::pi * share_(random_); }

    std::mt19937 random_{1998};
    std::uniform_real_distribution<double> share_{0.0, 1.0};
};

/// Returns pi f, or pi f n.l.
glm::dvec3 tabled(const LobeModel& model, bool hasCosine, const glm::dvec3& l,
                  const glm::dvec3& v) {
    return hasCosine ? model.value(l, v) : std::numbers::pi * model.reflectance(l, v);
}

/// Tells whether the two numbers decide the value.
bool isDecidedBy(const LobeModel& model, const ReflectanceTable& table) {
    constexpr double tolerance = 1e-7;
    const glm::dvec3 t = turnedTangent(table.tangentDegrees);
    ProbeDirections probes;
    for (int i = 0; i < probeCount; ++i) {
        const glm::dvec3 l = probes.any();
        const glm::dvec3 v = probes.any();
        const glm::dvec3 here = tabled(model, table.hasCosine, l, v);
        const glm::dvec3 there = tabled(model, table.hasCosine, probes.alike(l, table.axes, t),
                                        probes.alike(v, table.axes, t));
        if (largestPart(here - there) > tolerance * std::max(largestPart(here), 1e-3)) {
            return false;
        }
    }
    return true;
}

/// Returns a direction above the surface with a number on the axes.
glm::dvec3 directionOf(double number, TableAxes axes, const glm::dvec3& t) {
    const double rest = std::sqrt(std::max(1.0 - number * number, 0.0));
    const glm::dvec3 n(0.0, 0.0, 1.0);
    return axes == TableAxes::NormalCosines ? number * n + rest * t : number * t + rest * n;
}

/// Returns the number at a share of an axis.
double numberAt(double share, TableAxes axes) {
    return axes == TableAxes::NormalCosines ? share : 2.0 * share - 1.0;
}

void fill(ReflectanceTable& table, const LobeModel& model) {
    const glm::dvec3 t = turnedTangent(table.tangentDegrees);
    const auto direction = [&](int texel) {
        return directionOf(numberAt((texel + 0.5) / table.size, table.axes), table.axes, t);
    };
    for (int row = 0; row < table.size; ++row) {
        for (int column = 0; column < table.size; ++column) {
            // The file holds floats, and what they lose is lost to who reads it.
            table.values.emplace_back(
                glm::vec3(tabled(model, table.hasCosine, direction(row), direction(column))));
        }
    }
}

/// Compares the table with the model at places of which few are the middle of a texel, and as near
/// to the ends of the axes, where most is lost, as `nearestEnd` of their length.
void measure(ReflectanceTable& table, const LobeModel& model) {
    constexpr double nearestEnd = 1e-3;
    const int places = 4 * table.size + 1;
    const glm::dvec3 t = turnedTangent(table.tangentDegrees);
    const auto direction = [&](int place) {
        const double share = nearestEnd + (1.0 - 2.0 * nearestEnd) * place / (places - 1);
        return directionOf(numberAt(share, table.axes), table.axes, t);
    };
    double sum = 0.0;
    for (int row = 0; row < places; ++row) {
        for (int column = 0; column < places; ++column) {
            const glm::dvec3 l = direction(row);
            const glm::dvec3 v = direction(column);
            const double error = largestPart(table.value(l, v) - model.value(l, v));
            table.maxError = std::max(table.maxError, error);
            sum += error;
        }
    }
    table.meanError = sum / (double(places) * places);
}

/// Returns the turns of the tangent that the model's values name, in degrees.
std::vector<double> tangentTurns(const Block& block, const Material& material) {
    std::vector<double> turns{0.0};
    for (const Parameter& parameter : block.parameters) {
        const auto found = material.model.parameters.find(parameter.id);
        const Value& value =
            found == material.model.parameters.end() ? parameter.defaultValue : found->second;
        const double* degrees = std::get_if<double>(&value);
        if (parameter.type == ParameterType::Angle && degrees != nullptr && *degrees != 0.0) {
            turns.push_back(*degrees);
        }
    }
    return turns;
}

} // namespace

glm::dvec3 ReflectanceTable::read(double light, double viewer) const {
    const auto place = [this](double number) {
        const double share = axes == TableAxes::NormalCosines ? number : 0.5 * number + 0.5;
        return std::clamp(share * size - 0.5, 0.0, size - 1.0);
    };
    const double y = place(light);
    const double x = place(viewer);
    const int row = std::min(static_cast<int>(y), size - 1);
    const int column = std::min(static_cast<int>(x), size - 1);
    const auto at = [this](int r, int c) {
        return values[static_cast<std::size_t>(std::min(r, size - 1) * size +
                                               std::min(c, size - 1))];
    };
    return glm::mix(glm::mix(at(row, column), at(row, column + 1), x - column),
                    glm::mix(at(row + 1, column), at(row + 1, column + 1), x - column), y - row);
}

glm::dvec3 ReflectanceTable::value(const glm::dvec3& l, const glm::dvec3& v) const {
    const glm::dvec3 axis = axes == TableAxes::NormalCosines ? glm::dvec3(0.0, 0.0, 1.0)
                                                             : turnedTangent(tangentDegrees);
    return read(glm::dot(l, axis), glm::dot(v, axis)) * (hasCosine ? 1.0 : std::max(l.z, 0.0));
}

Result<ReflectanceTable> reflectanceTable(const Catalog& catalog, const Material& material,
                                          LobeTerm term, int size) {
    const auto model = reflectanceModel(catalog, material, term);
    if (!model) {
        return tl::unexpected(model.error());
    }
    const Block& block = *catalog.find(kinds::models, material.model.id);
    std::vector<ReflectanceTable> possible;
    for (const TableAxes axes : {TableAxes::NormalCosines, TableAxes::TangentCosines}) {
        for (const double degrees : tangentTurns(block, material)) {
            for (const bool hasCosine : {false, true}) {
                ReflectanceTable table{axes, hasCosine, degrees, size, {}, 0.0, 0.0};
                if (isDecidedBy(*model, table)) {
                    fill(table, *model);
                    measure(table, *model);
                    possible.push_back(std::move(table));
                }
            }
        }
        if (const auto ended = model->ending(); !ended) {
            return tl::unexpected(ended.error());
        }
        if (!possible.empty()) {
            return *std::ranges::min_element(possible, {}, &ReflectanceTable::maxError);
        }
    }
    return failure(
        fmt::format("{} is decided neither by n.l and n.v nor by l.t and v.t", block.label),
        "a material, or a --term of it, with two numbers");
}

std::string tableText(const ReflectanceTable& table) {
    const bool isOfNormal = table.axes == TableAxes::NormalCosines;
    return fmt::format("{} over {}, {} x {} texels, at most {:.2g} off and {:.2g} in the mean",
                       table.hasCosine ? "pi f n.l" : "pi f",
                       isOfNormal ? "n.v and n.l" : "v.t and l.t", table.size, table.size,
                       table.maxError, table.meanError);
}

} // namespace patina
