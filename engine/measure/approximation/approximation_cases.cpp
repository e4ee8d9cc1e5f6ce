// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/approximation/approximation_cases.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/matrix.hpp>

#include "catalog/parameter_type.h"
#include "measure/eval/eval_source.h"
#include "measure/stability/edge_case_directions.h"
#include "measure/stability/edge_case_fields.h"
#include "measure/stability/sweep_cases.h"

namespace patina {
namespace {

/// Is the least cosine of light and viewer: lower is in the surface itself.
constexpr double minCosine = 0.05;
constexpr std::size_t rowsOfStatedEdges = 64;
constexpr double maxFogRange = 1000.0; ///< in metres
constexpr double unitSlack = 1e-6; ///< is how far lengths and cosines of axes may be off in floats

glm::dvec3 floatVector(const glm::dvec3& v) {
    return glm::dvec3(glm::vec3(v));
}

/// Is a surface's own axes: along its tangent, its bitangent and its normal.
struct SurfaceAxes {
    glm::dmat3 toWorld{1.0};

    explicit SurfaceAxes(const EvalPlace& place)
        : toWorld(place.t, glm::cross(place.n, place.t), place.n) {}

    glm::dvec3 inWorld(const glm::dvec3& local) const { return floatVector(toWorld * local); }
    glm::dvec3 inSurface(const glm::dvec3& world) const { return glm::transpose(toWorld) * world; }
};

/// Draws directions above the surface, in its own axes.
class DirectionDraw {
  public:
    explicit DirectionDraw(std::uint32_t seed) : engine_(seed) {}

    double uniform(double low, double high) {
        return low + (high - low) * static_cast<double>(engine_()) / 4294967296.0;
    }

    std::uint32_t below(std::uint32_t count) { return engine_() % count; }

    /// Returns a number of any size up to `greatest`: as many between 0.001 and 0.01 of it as
    /// between 0.01 and 0.1.
    double ofAnySize(double greatest) { return greatest * std::pow(10.0, uniform(-6.0, 0.0)); }

    /// Returns a direction anywhere, but of sixteen one near the normal and one near the lowest
    /// that there is: near these formulas lose digits, or bend, within angles of any size.
    glm::dvec3 above() {
        const std::uint32_t which = below(16);
        const double angle = ofAnySize(1.0);
        const double c = which == 0   ? std::max(std::cos(angle), minCosine)
                         : which == 1 ? minCosine + angle * (1.0 - minCosine)
                                      : uniform(minCosine, 1.0);
        const double s = which == 0 ? std::sin(angle) : std::sqrt(std::max(1.0 - c * c, 0.0));
        const double phi = uniform(0.0, 2.0 * std::numbers::pi);
        return raised({s * std::cos(phi), s * std::sin(phi), c});
    }

    /// Returns a direction at an angle of any size to another one.
    glm::dvec3 near(const glm::dvec3& other, double greatest) {
        const double reach = ofAnySize(greatest);
        const glm::dvec3 off{uniform(-reach, reach), uniform(-reach, reach),
                             uniform(-reach, reach)};
        return raised(other + off);
    }

    static glm::dvec3 mirrored(const glm::dvec3& l) { return {-l.x, -l.y, l.z}; }

    EvalPlace place(EvalCase::Subject subject) {
        EvalPlace made;
        if (subject == EvalCase::Subject::Fresnel) {
            made.number = static_cast<double>(static_cast<float>(uniform(0.0, 1.0)));
            return made;
        }
        if (subject == EvalCase::Subject::Fog) {
            return fogRay();
        }
        if (below(4) != 0) {
            turn(made);
        }
        const SurfaceAxes axes(made);
        const glm::dvec3 l = above();
        const std::uint32_t which = below(12);
        made.l = axes.inWorld(l);
        made.v = axes.inWorld(which < 4    ? near(mirrored(l), 0.3)
                              : which == 4 ? near(l, 0.3)
                                           : above());
        made.pixel = floatVector({uniform(0.0, 24.0), uniform(0.0, 24.0), 0.0});
        return made;
    }

  private:
    /// Returns a ray from somewhere near the origin in any direction, of eight one exactly level
    /// along some axis and one nearly. Half of them are short, the others of any length.
    EvalPlace fogRay() {
        EvalPlace made;
        const double range = below(2) == 0 ? uniform(0.0, ordinaryReach) : ofAnySize(maxFogRange);
        made.number = static_cast<double>(static_cast<float>(range));
        for (int axis = 0; axis < 3; ++axis) {
            made.l[axis] = uniform(-ordinaryReach, ordinaryReach);
        }
        made.l = floatVector(made.l);
        const std::uint32_t which = below(8);
        const double across = which == 0   ? 0.0
                              : which == 1 ? (below(2) == 0 ? 1.0 : -1.0) * ofAnySize(1.0)
                                           : uniform(-1.0, 1.0);
        const double phi = uniform(0.0, 2.0 * std::numbers::pi);
        const double side = std::sqrt(std::max(1.0 - across * across, 0.0));
        const int axis = static_cast<int>(below(3));
        made.v[axis] = across;
        made.v[(axis + 1) % 3] = side * std::cos(phi);
        made.v[(axis + 2) % 3] = side * std::sin(phi);
        made.v = floatVector(made.v);
        return made;
    }

    /// Turns the surface anywhere.
    void turn(EvalPlace& place) {
        const double z = uniform(-1.0, 1.0);
        const double side = std::sqrt(std::max(1.0 - z * z, 0.0));
        const double phi = uniform(0.0, 2.0 * std::numbers::pi);
        const double around = uniform(0.0, 2.0 * std::numbers::pi);
        const glm::dvec3 n(side * std::cos(phi), side * std::sin(phi), z);
        const glm::dvec3 other =
            std::abs(z) < 0.7 ? glm::dvec3(0.0, 0.0, 1.0) : glm::dvec3(1.0, 0.0, 0.0);
        const glm::dvec3 first = glm::normalize(glm::cross(other, n));
        const glm::dvec3 second = glm::cross(n, first);
        place.n = floatVector(n);
        place.t = floatVector(std::cos(around) * first + std::sin(around) * second);
    }

    /// Returns the direction of a vector, not lower than the lowest.
    static glm::dvec3 raised(const glm::dvec3& vector) {
        glm::dvec3 unit = glm::normalize(vector);
        const double flat = std::hypot(unit.x, unit.y);
        if (unit.z < minCosine && flat > 0.0) {
            const double scale = std::sqrt(1.0 - minCosine * minCosine) / flat;
            unit = {unit.x * scale, unit.y * scale, minCosine};
        }
        return unit;
    }

    std::mt19937 engine_;
};

/// Moves one value of a block, anywhere or a little, within what its slider reaches.
void moveOneValue(EvalBlock& block, DirectionDraw& draw) {
    std::vector<const Parameter*> free;
    for (const Parameter& parameter : block.block->parameters) {
        if (infoOf(parameter.type).hasRange && parameter.compiled == Compiled::No) {
            free.push_back(&parameter);
        }
    }
    if (free.empty()) {
        return;
    }
    const Parameter& parameter = *free[draw.below(static_cast<std::uint32_t>(free.size()))];
    const double low = std::clamp(parameter.softMin, parameter.min, parameter.max);
    const double high = std::clamp(parameter.softMax, parameter.min, parameter.max);
    const auto found = block.values.find(parameter.id);
    const Value& before = found == block.values.end() ? parameter.defaultValue : found->second;
    const std::uint32_t how = draw.below(4);
    const double step = draw.ofAnySize(high - low);
    const auto moved = [&](double x) {
        return std::clamp(x + draw.uniform(-step, step), low, high);
    };
    const auto* number = std::get_if<double>(&before);
    const auto* triple = std::get_if<glm::dvec3>(&before);
    if (how > 1 && number != nullptr) {
        block.values[parameter.id] = moved(*number);
    } else if (how > 1 && triple != nullptr) {
        block.values[parameter.id] =
            glm::dvec3{moved(triple->x), moved(triple->y), moved(triple->z)};
    } else {
        const auto any = [&] {
            return how == 0 ? draw.uniform(low, high) : draw.below(2) == 0 ? low : high;
        };
        block.values[parameter.id] = infoOf(parameter.type).ordinary(parameter, any);
    }
}

/// Returns common places, different ones for each seed.
std::vector<EvalPlace> commonPlaces(const EvalCase& subject, const CaseWish& wish) {
    const bool isDrawn = subject.subject == EvalCase::Subject::Model ||
                         subject.subject == EvalCase::Subject::Fresnel ||
                         subject.subject == EvalCase::Subject::Fog;
    std::vector<EvalPlace> places;
    if (isDrawn) {
        DirectionDraw draw(wish.seed);
        for (std::size_t i = 0; i < wish.count; ++i) {
            places.push_back(draw.place(subject.subject));
        }
        return places;
    }
    const std::size_t skipped = wish.seed * wish.count; // theirs are the same for every call
    places = subject.subject == EvalCase::Subject::Fields
                 ? ordinaryFields(fieldsOf(subject), skipped + wish.count)
                 : ordinaryPlaces(subject.subject, skipped + wish.count);
    if (places.size() > wish.count) {
        places.erase(places.begin(), places.end() - static_cast<std::ptrdiff_t>(wish.count));
    }
    return places;
}

std::vector<EvalPlace> edgeCasePlaces(const EvalCase& subject) {
    return subject.subject == EvalCase::Subject::Fields ? edgeCaseFields(fieldsOf(subject))
                                                        : edgeCaseDirections(subject.subject);
}

bool isUnit(const glm::dvec3& v) {
    return std::abs(glm::length(v) - 1.0) < unitSlack;
}

/// Tells whether an edge case is one for which an error is stated.
bool isStatedAt(const EvalPlace& place, EvalCase::Subject subject) {
    if (subject == EvalCase::Subject::Fresnel) {
        return place.number >= 0.0 && place.number <= 1.0;
    }
    return subject != EvalCase::Subject::Model ||
           (isUnit(place.n) && isUnit(place.t) && isUnit(place.l) && isUnit(place.v) &&
            std::abs(glm::dot(place.n, place.t)) < unitSlack &&
            glm::dot(place.n, place.l) >= minCosine && glm::dot(place.n, place.v) >= minCosine);
}

/// Moves values of every other set, each with a chance of one half, to an end of their sliders:
/// errors are often largest there, as with the largest exponent.
void moveToEnds(std::vector<EvalCase>& rows) {
    std::mt19937 random(20260204);
    for (std::size_t row = 0; row < rows.size(); row += 2) {
        for (const auto part : {&EvalCase::block, &EvalCase::slot}) {
            EvalBlock& block = rows[row].*part;
            if (block.block == nullptr) {
                continue;
            }
            for (const Parameter& parameter : block.block->parameters) {
                const ParameterTypeInfo& info = infoOf(parameter.type);
                if (!info.hasRange || parameter.compiled != Compiled::No || random() % 2 == 0) {
                    continue;
                }
                const auto end = [&] {
                    return std::clamp(random() % 2 == 0 ? parameter.softMin : parameter.softMax,
                                      parameter.min, parameter.max);
                };
                block.values[parameter.id] = info.ordinary(parameter, end);
            }
        }
    }
}

/// Says up to which numbers the fields of common cases go that have no largest one.
std::string fieldsInWords(std::span<const ArgumentField> fields) {
    std::string words;
    for (const ArgumentField& field : fields) {
        if (field.type == ArgumentField::Type::Color || field.type == ArgumentField::Type::Amount) {
            words += fmt::format("{}{} up to {}", words.empty() ? "" : ", ", field.key,
                                 ordinaryMax(field));
        }
    }
    return words.empty() ? "all that it can be given" : words;
}

/// Returns places with sets of values: different ones, as many as are asked for.
std::vector<EvalCase> atPlaces(const std::vector<EvalPlace>& places,
                               const std::vector<EvalCase>& rows, std::size_t count) {
    if (places.empty()) {
        return rows;
    }
    std::vector<EvalCase> cases;
    // Steps that have no divisor in common with their number reach all places and rows.
    for (std::size_t i = 0; i < count; ++i) {
        cases.push_back(rows[i * 7919 % rows.size()]);
        static_cast<EvalPlace&>(cases.back()) = places[i * 104729 % places.size()];
    }
    return cases;
}

} // namespace

std::vector<EvalCase> commonCases(const EvalCase& subject, const CaseWish& wish) {
    const std::vector<EvalPlace> places = commonPlaces(subject, wish);
    std::vector<EvalCase> rows =
        wish.hasOwnValues
            ? std::vector<EvalCase>{subject}
            : ordinaryRows(subject, wish.firstRow + std::max<std::size_t>(wish.rows, 1));
    if (!wish.hasOwnValues) {
        rows.erase(rows.begin(), rows.begin() + static_cast<std::ptrdiff_t>(wish.firstRow));
    }
    if (wish.reachesEnds && !wish.hasOwnValues) {
        moveToEnds(rows);
    }
    std::vector<EvalCase> cases;
    cases.reserve(places.size());
    for (std::size_t i = 0; i < places.size(); ++i) {
        cases.push_back(i % 4 == 0 ? subject : rows[(i - i / 4) % rows.size()]);
        static_cast<EvalPlace&>(cases.back()) = places[i];
    }
    return cases;
}

std::vector<EvalCase> edgeCases(const EvalCase& subject, std::size_t count, bool hasOwnValues) {
    return atPlaces(edgeCasePlaces(subject),
                    hasOwnValues ? std::vector<EvalCase>{subject} : sweepRows(subject), count);
}

std::vector<EvalCase> statedEdgeCases(const EvalCase& subject, std::size_t count,
                                      bool hasOwnValues) {
    std::vector<EvalPlace> places = edgeCasePlaces(subject);
    std::erase_if(
        places, [&subject](const EvalPlace& place) { return !isStatedAt(place, subject.subject); });
    std::vector<EvalCase> rows{subject};
    if (!hasOwnValues) {
        rows = ordinaryRows(subject, rowsOfStatedEdges);
        moveToEnds(rows);
        rows.push_back(subject);
    }
    return atPlaces(places, rows, count);
}

std::vector<EvalCase> nearbyCases(const EvalCase& from, std::size_t count, bool hasOwnValues,
                                  std::uint32_t seed) {
    DirectionDraw draw(seed);
    std::vector<EvalCase> cases(count, from);
    for (EvalCase& each : cases) {
        const std::uint32_t which = draw.below(4); // bit 0: not the light, bit 1: not the viewer
        if (each.subject == EvalCase::Subject::Model) {
            const SurfaceAxes axes(each);
            for (glm::dvec3* direction :
                 {(which & 1u) == 0 ? &each.l : nullptr, (which & 2u) == 0 ? &each.v : nullptr}) {
                if (direction != nullptr) {
                    *direction = axes.inWorld(draw.near(axes.inSurface(*direction), 1.0));
                }
            }
        } else if (each.subject == EvalCase::Subject::Fresnel) {
            const double step = draw.ofAnySize(1.0);
            each.number = static_cast<double>(
                static_cast<float>(std::clamp(each.number + draw.uniform(-step, step), 0.0, 1.0)));
        }
        const bool isMoved = !hasOwnValues && (which == 3 || draw.below(3) == 0);
        EvalBlock& block =
            each.slot.block != nullptr && draw.below(3) == 0 ? each.slot : each.block;
        if (isMoved && block.block != nullptr) {
            moveOneValue(block, draw);
        }
    }
    return cases;
}

std::string placesInWords(const EvalCase& subject) {
    switch (subject.subject) {
    case EvalCase::Subject::Model:
        return fmt::format("light and viewer {:.0f} degrees or more above the surface",
                           std::asin(minCosine) * 180.0 / std::numbers::pi);
    case EvalCase::Subject::Fresnel:
        return "cosines from 0 to 1";
    case EvalCase::Subject::Light:
        return fmt::format("points within {} m of the origin along each axis", ordinaryReach);
    case EvalCase::Subject::Fog:
        return fmt::format("ways of up to {} m in any direction, from within {} m of the origin "
                           "along each axis",
                           maxFogRange, ordinaryReach);
    default:
        return fieldsInWords(fieldsOf(subject));
    }
}

std::string slidersInWords(const EvalCase& subject) {
    std::string words;
    for (const EvalBlock* part : {&subject.block, &subject.slot}) {
        if (part->block == nullptr) {
            continue;
        }
        for (const Parameter& parameter : part->block->parameters) {
            const bool isReached =
                parameter.softMin <= parameter.min && parameter.softMax >= parameter.max;
            if (infoOf(parameter.type).hasRange && !isReached) {
                words += fmt::format("{}{} from {} to {}{}", words.empty() ? "" : ", ",
                                     parameter.label, std::max(parameter.softMin, parameter.min),
                                     std::min(parameter.softMax, parameter.max),
                                     parameter.unit.empty() ? "" : ' ' + parameter.unit);
            }
        }
    }
    return words;
}

CaseTexels texelsOfCases(const std::vector<EvalCase>& cases) {
    CaseTexels all;
    all.reserve(cases.size());
    for (const EvalCase& each : cases) {
        const std::vector<float> place = placeTexels(each);
        const std::vector<float> values = valueTexels(each);
        all.emplace_back(place.begin(), place.end());
        all.back().insert(all.back().end(), values.begin(), values.end());
    }
    return all;
}

} // namespace patina
