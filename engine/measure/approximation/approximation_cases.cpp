// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/approximation/approximation_cases.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

#include <glm/geometric.hpp>

#include "catalog/parameter_type.h"
#include "measure/eval/eval_source.h"
#include "measure/stability/edge_case_directions.h"
#include "measure/stability/edge_case_fields.h"
#include "measure/stability/sweep_cases.h"

namespace patina {
namespace {

/// Is the least cosine of light and viewer: lower is in the surface itself.
constexpr double minCosine = 0.05;

glm::dvec3 floatVector(const glm::dvec3& v) {
    return glm::dvec3(glm::vec3(v));
}

/// Draws directions above the surface.
class DirectionDraw {
  public:
    explicit DirectionDraw(std::uint32_t seed) : engine_(seed) {}

    double uniform(double low, double high) {
        return low + (high - low) * static_cast<double>(engine_()) / 4294967296.0;
    }

    glm::dvec3 above() {
        const double c = uniform(minCosine, 1.0);
        const double phi = uniform(0.0, 2.0 * std::numbers::pi);
        const double s = std::sqrt(1.0 - c * c);
        return floatVector({s * std::cos(phi), s * std::sin(phi), c});
    }

    glm::dvec3 nearMirror(const glm::dvec3& l) {
        const double reach = std::pow(10.0, uniform(-3.0, -0.5));
        const glm::dvec3 off{uniform(-reach, reach), uniform(-reach, reach), 0.0};
        glm::dvec3 v = glm::normalize(glm::dvec3(-l.x, -l.y, l.z) + off);
        v.z = std::max(v.z, minCosine);
        return floatVector(glm::normalize(v));
    }

    EvalPlace place(EvalCase::Subject subject) {
        EvalPlace made;
        if (subject == EvalCase::Subject::Fresnel) {
            made.number = static_cast<double>(static_cast<float>(uniform(0.0, 1.0)));
            return made;
        }
        made.l = above();
        made.v = engine_() % 3 == 0 ? nearMirror(made.l) : above();
        made.pixel = floatVector({uniform(0.0, 24.0), uniform(0.0, 24.0), 0.0});
        return made;
    }

  private:
    std::mt19937 engine_;
};

/// Returns common places, different ones for each seed.
std::vector<EvalPlace> commonPlaces(const EvalCase& subject, const CaseWish& wish) {
    const bool isDrawn = subject.subject == EvalCase::Subject::Model ||
                         subject.subject == EvalCase::Subject::Fresnel;
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
    const std::vector<EvalPlace> places = edgeCasePlaces(subject);
    const std::vector<EvalCase> rows =
        hasOwnValues ? std::vector<EvalCase>{subject} : sweepRows(subject);
    std::vector<EvalCase> cases;
    if (places.empty()) {
        return rows;
    }
    // Steps that have no divisor in common with their number reach all places and rows.
    for (std::size_t i = 0; i < count; ++i) {
        cases.push_back(rows[i * 7919 % rows.size()]);
        static_cast<EvalPlace&>(cases.back()) = places[i * 104729 % places.size()];
    }
    return cases;
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
