// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/stability/edge_case_fields.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <random>

#include <glm/geometric.hpp>

#include "measure/stability/pairwise.h"

namespace patina {
namespace {

using Type = ArgumentField::Type;
using Triples = std::vector<glm::dvec3>;

/// Are numbers from 0 to 1: the ends, those next to them, and some between.
constexpr double shares[] = {0.0,        std::numeric_limits<float>::min(),
                             1e-30,      1e-12,
                             1e-8,       1e-4,
                             1e-2,       0.1,
                             0.3,        0.5,
                             0.7,        0.9,
                             1.0 - 1e-4, 1.0 - 1e-6,
                             1.0};

/// Are amounts without an upper limit, from 0 to nearly the largest float.
constexpr double amounts[] = {0.0,   std::numeric_limits<float>::min(),
                              1e-30, 1e-12,
                              1e-6,  1e-3,
                              0.1,   1.0,
                              10.0,  1e3,
                              1e6,   1e20,
                              3e38};

/// Are the largest amount and the brightest colour that count as ordinary.
constexpr double ordinaryAmount = 5.0;
constexpr double ordinaryColor = 2.0;

glm::dvec3 rounded(const glm::dvec3& v) {
    return glm::dvec3(glm::vec3(v));
}

/// Returns a direction with this cosine to an axis, in float.
glm::dvec3 directionTo(int axis, double c, double azimuth) {
    const double s = std::sqrt(std::max(0.0, (1.0 - std::abs(c)) * (1.0 + std::abs(c))));
    glm::dvec3 v;
    v[axis] = c;
    v[(axis + 1) % 3] = s * std::cos(azimuth);
    v[(axis + 2) % 3] = s * std::sin(azimuth);
    return rounded(v);
}

Triples edgeCasesOfDirection() {
    Triples directions;
    for (const double c : shares) {
        for (const double azimuth : {0.0, 0.7, std::numbers::pi / 2, 2.5, 4.0, 5.5}) {
            for (const int axis : {1, 2}) {
                directions.push_back(directionTo(axis, c, azimuth));
                directions.push_back(directionTo(axis, -c, azimuth));
            }
        }
    }
    return directions;
}

Triples edgeCasesOfNormal() {
    return {{0.0, 0.0, 1.0}, {0.0, 1.0, 0.0}, rounded(glm::normalize(glm::dvec3(0.3, -0.5, 0.7)))};
}

Triples edgeCasesOfColor() {
    return {glm::dvec3(1.0),     glm::dvec3(0.0),
            {1.0, 0.0, 0.0},     rounded(glm::dvec3(1e-30)),
            glm::dvec3(65504.0), rounded({0.2, 0.5, 0.9})};
}

std::vector<double> edgeCasesOfNumber(const ArgumentField& field) {
    std::vector<double> numbers;
    if (!field.isContinuous()) {
        for (double x = 0.0; x <= field.max; x += 1.0) {
            numbers.push_back(x);
        }
        return numbers;
    }
    if (field.type == Type::Amount) {
        for (const double amount : amounts) {
            numbers.push_back(double(float(amount)));
        }
        return numbers;
    }
    for (const double share : shares) {
        numbers.push_back(std::min(double(float(share * field.max)), field.max));
    }
    return numbers;
}

Triples edgeCasesOf(const ArgumentField& field) {
    if (field.isTriple()) {
        return field.type == Type::Color    ? edgeCasesOfColor()
               : field.type == Type::Normal ? edgeCasesOfNormal()
                                            : edgeCasesOfDirection();
    }
    Triples all;
    for (const double x : edgeCasesOfNumber(field)) {
        all.emplace_back(x);
    }
    return all;
}

/// Fills the fields of a place in order.
class Filling {
  public:
    void add(const ArgumentField& field, glm::dvec3 value) {
        if (field.type == Type::Normal && glm::dot(value, direction_) < 0.0) {
            value = -value;
        }
        direction_ = field.type == Type::Direction ? value : direction_;
        for (std::size_t i = 0; i < field.numbers(); ++i) {
            place.fields[next_++] = value[static_cast<int>(i)];
        }
    }

    EvalPlace place;

  private:
    glm::dvec3 direction_{0.0};
    std::size_t next_ = 0;
};

glm::dvec3 ordinaryValue(const ArgumentField& field, std::mt19937& random) {
    const auto between = [&random](double low, double high) {
        return std::uniform_real_distribution<double>(low, high)(random);
    };
    if (field.isDirection()) {
        return directionTo(2, between(-1.0, 1.0), between(0.0, 2.0 * std::numbers::pi));
    }
    if (field.isTriple()) {
        const double x = between(0.0, ordinaryColor);
        const double y = between(0.0, ordinaryColor);
        return rounded({x, y, between(0.0, ordinaryColor)});
    }
    const double largest = ordinaryMax(field);
    const double x = between(0.0, largest);
    return field.isContinuous() ? rounded(glm::dvec3(std::min(x, largest)))
                                : glm::dvec3(std::round(x));
}

} // namespace

std::vector<EvalPlace> edgeCaseFields(std::span<const ArgumentField> fields) {
    std::vector<Triples> values;
    std::vector<std::size_t> counts;
    for (const ArgumentField& field : fields) {
        values.push_back(edgeCasesOf(field));
        counts.push_back(values.back().size());
    }
    std::vector<EvalPlace> places;
    for (const auto& row : pairwiseRows(counts)) {
        Filling filling;
        for (std::size_t i = 0; i < fields.size(); ++i) {
            filling.add(fields[i], values[i][row[i]]);
        }
        places.push_back(filling.place);
    }
    return places;
}

double ordinaryMax(const ArgumentField& field) {
    return field.type == Type::Amount  ? ordinaryAmount
           : field.type == Type::Color ? ordinaryColor
                                       : field.max;
}

std::vector<EvalPlace> ordinaryFields(std::span<const ArgumentField> fields, std::size_t count) {
    std::mt19937 random(20251121);
    std::vector<EvalPlace> places;
    for (std::size_t i = 0; i < count; ++i) {
        Filling filling;
        for (const ArgumentField& field : fields) {
            filling.add(field, ordinaryValue(field, random));
        }
        places.push_back(filling.place);
    }
    return places;
}

} // namespace patina
