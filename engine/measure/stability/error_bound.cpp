// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/stability/error_bound.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace patina {
namespace {

using Subject = EvalCase::Subject;

constexpr double rounding = 0x1p-24; ///< is half a unit in the last place of a float near 1
constexpr double noiseShare = 16.0;
constexpr double roundings = 32.0;
constexpr double flushed = 1e-30; ///< is allowed, since devices may flush results to 0

/// Adds the larger change of each number, of a move up and a move down. A change that is not finite
/// does not count.
void addChange(ReferenceNumbers& noise, const ReferenceNumbers& exact, const ReferenceNumbers& up,
               const ReferenceNumbers& down) {
    for (std::size_t i = 0; i < noise.size(); ++i) {
        const double changeUp = std::abs(up[i] - exact[i]);
        const double changeDown = std::abs(down[i] - exact[i]);
        noise[i] += std::max(std::isfinite(changeUp) ? changeUp : 0.0,
                             std::isfinite(changeDown) ? changeDown : 0.0);
    }
}

bool moves(const ParameterField& field) {
    return field.parameter != nullptr && infoOf(field.parameter->type).isContinuous;
}

/// Returns a value moved by its rounding, within the parameter's range. The numbers of a function
/// are not limited, since not all of them are its values.
double moved(const Parameter& parameter, double x, double sign) {
    const double next = x + sign * rounding * std::abs(x);
    if (infoOf(parameter.type).function != nullptr) {
        return next;
    }
    const bool angle = infoOf(parameter.type).isAngle;
    const double low = angle ? glm::radians(parameter.min) : parameter.min;
    const double high = angle ? glm::radians(parameter.max) : parameter.max;
    return std::clamp(next, low, high);
}

ReferenceNumbers larger(const ReferenceNumbers& a, const ReferenceNumbers& b) {
    ReferenceNumbers result{};
    std::transform(a.begin(), a.end(), b.begin(), result.begin(),
                   [](double x, double y) { return std::max(x, y); });
    return result;
}

/// Returns the sign by which number i moves in a pattern of moves of all numbers. The patterns are
/// such that every two numbers meet with equal and with opposite signs.
double signOf(std::size_t pattern, std::size_t i) {
    constexpr std::uint32_t patterns[] = {0x0000, 0x3fff, 0x15a3, 0x2939,
                                          0x06c6, 0x33f0, 0x2c0f, 0x1a95};
    return (patterns[pattern] >> i & 1U) != 0 ? 1.0 : -1.0;
}
constexpr std::size_t signPatterns = 8;

using Enough = ErrorBound::Enough;

/// Points to the numbers of a place, and holds how far each moves.
struct Movable {
    std::vector<double*> numbers;
    std::vector<double> steps;
    std::function<ReferenceNumbers()> evaluate;
};

/// Returns the change as all numbers move at once. It comes first, since one evaluation of it tells
/// most about the noise.
ReferenceNumbers noiseTogether(const Movable& movable, const ReferenceNumbers& exact,
                               const Enough& enough) {
    ReferenceNumbers noise{};
    std::vector<double> kept;
    for (const double* number : movable.numbers) {
        kept.push_back(*number);
    }
    for (std::size_t pattern = 0; pattern < signPatterns && !enough(noise); ++pattern) {
        for (std::size_t i = 0; i < kept.size(); ++i) {
            *movable.numbers[i] = kept[i] + signOf(pattern, i) * movable.steps[i];
        }
        const ReferenceNumbers changed = movable.evaluate();
        ReferenceNumbers together{};
        addChange(together, exact, changed, changed);
        noise = larger(noise, together);
    }
    for (std::size_t i = 0; i < kept.size(); ++i) {
        *movable.numbers[i] = kept[i];
    }
    return noise;
}

ReferenceNumbers noiseOf(const Movable& movable, const ReferenceNumbers& exact,
                         const Enough& enough) {
    const ReferenceNumbers together = noiseTogether(movable, exact, enough);
    if (enough(together)) {
        return together;
    }
    ReferenceNumbers sum{};
    for (std::size_t i = 0; i < movable.numbers.size() && !enough(sum); ++i) {
        double& x = *movable.numbers[i];
        const double kept = x;
        x = kept + movable.steps[i];
        const ReferenceNumbers up = movable.evaluate();
        x = kept - movable.steps[i];
        addChange(sum, exact, up, movable.evaluate());
        x = kept;
    }
    return larger(sum, together);
}

/// Moves the light and the viewer towards mirror directions, each by at most its rounding. A lobe
/// has its peak there, which may be narrower than a rounding and then lie between the places that
/// other moves reach.
void moveTowardsMirror(reference::Geometry& geometry) {
    const glm::dvec3 half = geometry.l + geometry.v;
    const glm::dvec3 across = half - glm::dot(half, geometry.n) * geometry.n;
    const glm::dvec3 step = glm::clamp(0.5 * across, -rounding, rounding);
    geometry.l -= step;
    geometry.v -= step;
}

/// Tells whether cosines with the normal are exact, however small: the normal is (0, 0, 1), and the
/// value does not depend on the tangent, whose frame would mix in the roundings of the other
/// components.
bool hasExactCosines(const ReferenceCase& bound, const reference::Geometry& geometry,
                     const ReferenceNumbers& exact) {
    if (geometry.n != glm::dvec3(0.0, 0.0, 1.0)) {
        return false;
    }
    constexpr glm::dvec3 grains[] = {{1.0, 0.0, 0.0}, {0.6, 0.8, 0.0}};
    return std::ranges::all_of(grains, [&](const glm::dvec3& grain) {
        reference::Geometry turned = reference::geometry(geometry.n, grain, geometry.l, geometry.v);
        turned.pixel = geometry.pixel;
        return bound.evaluate(turned) == exact;
    });
}

ReferenceNumbers modelNoise(const ReferenceCase& bound, const EvalPlace& place,
                            const ReferenceNumbers& exact, const Enough& enough) {
    reference::Geometry geometry = geometryOf(place);
    Movable movable;
    for (glm::dvec3* vector : {&geometry.l, &geometry.v, &geometry.n, &geometry.t}) {
        for (int i = 0; i < 3; ++i) {
            movable.numbers.push_back(&(*vector)[i]);
        }
    }
    movable.steps.assign(movable.numbers.size(), rounding);
    if (hasExactCosines(bound, geometry, exact)) {
        for (double* number :
             {&geometry.l.z, &geometry.v.z, &geometry.n.x, &geometry.n.y, &geometry.n.z}) {
            const auto at = std::ranges::find(movable.numbers, number);
            movable.steps[static_cast<std::size_t>(at - movable.numbers.begin())] *=
                std::abs(*number);
        }
    }
    for (double* coordinate : {&geometry.pixel.x, &geometry.pixel.y}) {
        movable.numbers.push_back(coordinate);
        movable.steps.push_back(rounding * std::abs(*coordinate));
    }
    movable.evaluate = [&] { return bound.evaluate(geometry); };
    const ReferenceNumbers noise = noiseOf(movable, exact, enough);
    if (enough(noise)) {
        return noise;
    }
    moveTowardsMirror(geometry);
    const ReferenceNumbers mirrored = bound.evaluate(geometry);
    ReferenceNumbers change{};
    addChange(change, exact, mirrored, mirrored);
    return larger(noise, change);
}

/// Adds the fields' numbers. Those of a unit vector move by the rounding of 1, others by their own.
void addFields(Movable& movable, std::span<const ArgumentField> fields, EvalPlace& place) {
    double* number = place.fields.data();
    for (const ArgumentField& field : fields) {
        for (std::size_t i = 0; i < field.numbers(); ++i, ++number) {
            if (field.isContinuous()) {
                movable.numbers.push_back(number);
                movable.steps.push_back(rounding * (field.isDirection() ? 1.0 : std::abs(*number)));
            }
        }
    }
}

ReferenceNumbers placeNoise(const EvalCase& request, const ReferenceCase& bound,
                            const EvalPlace& place, const ReferenceNumbers& exact,
                            const Enough& enough) {
    const Subject subject = request.subject;
    if (subject == Subject::Model) {
        return modelNoise(bound, place, exact, enough);
    }
    EvalPlace changed = place;
    Movable movable;
    movable.evaluate = [&] { return bound.evaluate(changed); };
    if (subject == Subject::Fields) {
        addFields(movable, fieldsOf(request), changed);
        return noiseOf(movable, exact, enough);
    }
    if (subject == Subject::Light) {
        movable.numbers = {&changed.l.x, &changed.l.y, &changed.l.z};
    } else if (subject == Subject::Fog) {
        movable.numbers = {&changed.number, &changed.l.x, &changed.l.y, &changed.l.z,
                           &changed.v.x,    &changed.v.y, &changed.v.z};
    } else {
        movable.numbers = {&changed.number};
    }
    for (const double* number : movable.numbers) {
        const double size = subject == Subject::Fresnel ? 1.0 : std::abs(*number);
        movable.steps.push_back(rounding * size);
    }
    return noiseOf(movable, exact, enough);
}

void addValueNoise(ReferenceNumbers& noise, const ReferenceNumbers& exact, const Block& block,
                   const std::vector<double>& values,
                   const std::function<ReferenceNumbers(const std::vector<double>&)>& evaluate,
                   const Enough& enough) {
    std::vector<double> changed = values;
    for (const ParameterField& field : layoutOf(block).fields) {
        for (int i = 0; moves(field) && i < field.components && !enough(noise); ++i) {
            double& x = changed[field.offset + static_cast<std::size_t>(i)];
            const double kept = x;
            x = moved(*field.parameter, kept, 1.0);
            const ReferenceNumbers up = evaluate(changed);
            x = moved(*field.parameter, kept, -1.0);
            addChange(noise, exact, up, evaluate(changed));
            x = kept;
        }
    }
}

} // namespace

ErrorBound::ErrorBound(const ReferenceCode& code, const EvalCase& request)
    : code_(code), request_(request) {}

double ErrorBound::floor(double exact) {
    return roundings * rounding * std::abs(exact) + flushed;
}

ReferenceNumbers ErrorBound::at(const ReferenceCase& bound, const EvalPlace& place,
                                const ReferenceNumbers& exact) const {
    return limits(noise(bound, place, exact, [](const ReferenceNumbers&) { return false; }), exact);
}

double ErrorBound::excess(const ReferenceCase& bound, const EvalPlace& place,
                          const ReferenceNumbers& exact, const ReferenceNumbers& answer) const {
    const auto excessWith = [&](const ReferenceNumbers& known) {
        const ReferenceNumbers allowed = limits(known, exact);
        double maxShare = 0.0;
        for (std::size_t i = 0; i < allowed.size(); ++i) {
            maxShare = std::max(maxShare, std::abs(answer[i] - exact[i]) / allowed[i]);
        }
        return maxShare;
    };
    return excessWith(noise(bound, place, exact, [&](const ReferenceNumbers& known) {
        return excessWith(known) <= 1.0;
    }));
}

ReferenceNumbers ErrorBound::noise(const ReferenceCase& bound, const EvalPlace& place,
                                   const ReferenceNumbers& exact, const Enough& enough) const {
    ReferenceNumbers noise = placeNoise(request_, bound, place, exact, enough);
    addValueNoise(
        noise, exact, *request_.block.block, bound.values(),
        [&](const std::vector<double>& values) {
            return ReferenceCase(code_, values, bound.slotValues()).evaluate(place);
        },
        enough);
    if (code_.slot != nullptr) {
        addValueNoise(
            noise, exact, *request_.slot.block, bound.slotValues(),
            [&](const std::vector<double>& values) {
                return ReferenceCase(code_, bound.values(), values).evaluate(place);
            },
            enough);
    }
    return noise;
}

/// Returns the bound of each number. A function of a field that is a direction or a colour may mix
/// its numbers by a matrix, so that each has the roundings of the largest.
ReferenceNumbers ErrorBound::limits(const ReferenceNumbers& noise,
                                    const ReferenceNumbers& exact) const {
    const bool isTurned = std::ranges::any_of(fieldsOf(request_), &ArgumentField::isTriple);
    double largest = 0.0;
    for (const double x : exact) {
        largest = isTurned ? std::max(largest, std::abs(x)) : 0.0;
    }
    ReferenceNumbers allowed{};
    for (std::size_t i = 0; i < allowed.size(); ++i) {
        allowed[i] = noiseShare * noise[i] + floor(std::max(std::abs(exact[i]), largest));
    }
    return allowed;
}

} // namespace patina
