// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/stability/finding_text.h"

#include <cmath>
#include <numbers>

#include <fmt/format.h>
#include <glm/geometric.hpp>

namespace patina {
namespace {

using Json = nlohmann::json;
using Subject = EvalCase::Subject;

double degrees(double radians) {
    return radians * 180.0 / std::numbers::pi;
}

/// Returns the angle of a direction above the horizon, with the accuracy of its smallest component.
double elevation(const glm::dvec3& n, const glm::dvec3& direction) {
    const glm::dvec3 axis = glm::normalize(n);
    const double along = glm::dot(axis, direction);
    return degrees(std::atan2(along, glm::length(direction - along * axis)));
}

std::string elevationText(const char* name, double degreesUp) {
    if (degreesUp > 90.0 - 1e-6) {
        return fmt::format("{} along the normal", name);
    }
    return fmt::format("{} {:.3g} degrees {} the horizon", name, std::abs(degreesUp),
                       degreesUp < 0.0 ? "below" : "above");
}

/// Returns the degrees between the projections of light and viewer onto the surface; 180 is the
/// mirror's side.
double azimuth(const EvalCase& request) {
    const glm::dvec3 n = glm::normalize(request.n);
    const glm::dvec3 l = request.l - glm::dot(n, request.l) * n;
    const glm::dvec3 v = request.v - glm::dot(n, request.v) * n;
    return degrees(std::atan2(glm::length(glm::cross(l, v)), glm::dot(l, v)));
}

std::string modelPlace(const EvalCase& request) {
    return fmt::format("{}, {}, {:.4g} degrees between them around the normal",
                       elevationText("light", elevation(request.n, request.l)),
                       elevationText("viewer", elevation(request.n, request.v)), azimuth(request));
}

/// Returns each field with its numbers, as "depth 0.5, opacity 1".
std::string fieldsText(const EvalCase& request) {
    std::string text;
    const double* numbers = request.fields.data();
    for (const ArgumentField& field : fieldsOf(request)) {
        const std::string value = field.isTriple() ? fmt::format("({:.9g}, {:.9g}, {:.9g})",
                                                                 numbers[0], numbers[1], numbers[2])
                                                   : fmt::format("{:.9g}", numbers[0]);
        text += fmt::format("{}{} {}", text.empty() ? "" : ", ", field.key, value);
        numbers += field.numbers();
    }
    return text;
}

/// Returns the numbers as a list; equal ones are written as one.
std::string listText(const ReferenceNumbers& numbers, std::size_t count) {
    std::string text;
    bool equal = true;
    for (std::size_t i = 0; i < count; ++i) {
        text += fmt::format("{}{:.7g}", i == 0 ? "" : ", ", numbers[i]);
        equal = equal && numbers[i] == numbers[0];
    }
    return equal ? fmt::format("{:.7g}", numbers[0]) : '(' + text + ')';
}

Json numberJson(double x) {
    return std::isfinite(x) ? Json(x) : Json(fmt::format("{}", x));
}

Json listJson(const ReferenceNumbers& numbers, std::size_t count) {
    Json list = Json::array();
    for (std::size_t i = 0; i < count; ++i) {
        list.push_back(numberJson(numbers[i]));
    }
    return list;
}

Json findingJson(const SweepFinding& finding) {
    Json json{{"case", evalJson(finding.request)},
              {"place", placeText(finding.request)},
              {"value", listJson(finding.value, finding.numbers)},
              {"excess", numberJson(finding.excess)}};
    if (finding.defect >= Defect::Inaccurate) {
        json["exact"] = listJson(finding.exact, finding.numbers);
    }
    return json;
}

std::string argumentsText(const EvalCase& request) {
    switch (request.subject) {
    case Subject::Fields:
        return fieldsText(request);
    case Subject::Model:
        return modelPlace(request);
    case Subject::Fresnel:
        return fmt::format("cosine {:.9g}", request.number);
    case Subject::Fog:
        return fmt::format("distance {:.9g}, eye ({:.9g}, {:.9g}, {:.9g}), direction ({:.9g}, "
                           "{:.9g}, {:.9g})",
                           request.number, request.l.x, request.l.y, request.l.z, request.v.x,
                           request.v.y, request.v.z);
    default:
        return fmt::format("point ({:.9g}, {:.9g}, {:.9g})", request.l.x, request.l.y, request.l.z);
    }
}

} // namespace

std::string placeText(const EvalCase& request) {
    const std::string name(calledFunction(request).suffix);
    const std::string place = argumentsText(request);
    return name + (name.empty() || place.empty() ? "" : ": ") + place;
}

std::string amountText(const SweepFinding& finding) {
    const std::string value = listText(finding.value, finding.numbers);
    const std::string exact = listText(finding.exact, finding.numbers);
    switch (finding.defect) {
    case Defect::Inaccurate:
        return fmt::format("gives {}, exactly {}: {:.3g} times what rounding explains", value,
                           exact, finding.excess);
    case Defect::NotReciprocal:
        return fmt::format("gives {} of n.l, with light and viewer exchanged {}", value, exact);
    case Defect::NotIsotropic:
        return fmt::format("gives {}, turned about the normal {}", value, exact);
    case Defect::NotConserving:
        return fmt::format("gives {} of the light back, {} at most by its claim", value, exact);
    case Defect::NotContinuous:
        return fmt::format("gives {}, {} at most by its claim", value, exact);
    case Defect::NotMonotonic:
        return fmt::format("gives {}, less than the {} before it", value, exact);
    default:
        return "gives " + value;
    }
}

const char* precisionText(bool gpu) {
    return gpu ? "on the graphics device" : "on the CPU in double precision";
}

const char* limitText(const SweepReport& report) {
    if (report.withoutDouble) {
        return " on the graphics device only";
    }
    return report.withoutDevice ? " in double precision only" : "";
}

Json toJson(const SweepReport& report) {
    Json defects = Json::array();
    for (const auto& [key, tally] : report.defects) {
        defects.push_back({{"where", key.gpu ? "gpu" : "double"},
                           {"call", key.call},
                           {"what", wordsFor(key.defect)},
                           {"count", tally.count},
                           {"worst", findingJson(tally.worst)}});
    }
    Json errors = Json::array();
    for (const Error& error : report.errors) {
        errors.push_back(error.text());
    }
    return {{"cases", report.cases},
            {"programs", report.programs},
            {"sound", report.isClean()},
            {"largestError", numberJson(report.largestError)},
            {"defects", defects},
            {"errors", errors},
            {"gpuOnly", report.withoutDouble},
            {"doubleOnly", report.withoutDevice}};
}

} // namespace patina
