// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/spectrum.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "catalog/value_json.h"
#include "catalog/wavelengths.h"
#include "core/number_text.h"

namespace patina {
namespace {

using Json = nlohmann::json;

constexpr std::string_view spectrumWord = "spectrum";
constexpr const char* spectrumExample = R"({"nm": [400, 700], "values": [1.5, 1.4]})";

bool hasNumbers(const Json& json, const char* key) {
    const auto found = json.find(key);
    return found != json.end() && found->is_array() &&
           std::ranges::all_of(*found, [](const Json& each) { return each.is_number(); });
}

double wavelengthOf(const NumberList& spectrum, std::size_t i) {
    return spectrum.numbers[2 * i];
}

double numberOf(const NumberList& spectrum, std::size_t i) {
    return spectrum.numbers[2 * i + 1];
}

double atWavelength(const NumberList& spectrum, double nm) {
    const std::size_t last = spectrum.numbers.size() / 2 - 1;
    std::size_t upper = 0;
    while (upper < last && wavelengthOf(spectrum, upper) < nm) {
        ++upper;
    }
    if (upper == 0 || !(nm < wavelengthOf(spectrum, upper))) {
        return numberOf(spectrum, upper);
    }
    const double from = wavelengthOf(spectrum, upper - 1);
    const double share = (nm - from) / (wavelengthOf(spectrum, upper) - from);
    return std::lerp(numberOf(spectrum, upper - 1), numberOf(spectrum, upper), share);
}

ValueReading spectrumFromJson(const Parameter& parameter, const Json& json) {
    if (json.size() != 2 || !hasNumbers(json, "nm") || !hasNumbers(json, "values")) {
        return failureWithin("", "this is no spectrum", spectrumExample);
    }
    const Json& nm = json["nm"];
    const Json& values = json["values"];
    if (nm.size() < 2 || nm.size() != values.size()) {
        return failureWithin(
            "/values", fmt::format("{} wavelengths have {} numbers", nm.size(), values.size()),
            "two or more wavelengths, and a number for each");
    }
    NumberList spectrum{spectrumWord};
    for (std::size_t i = 0; i < nm.size(); ++i) {
        const auto wavelength = nm[i].get<double>();
        const auto number = values[i].get<double>();
        if (!(wavelength > (i == 0 ? 0.0 : wavelengthOf(spectrum, i - 1)))) {
            return failureWithin(fmt::format("/nm/{}", i), "the wavelengths do not rise",
                                 "wavelengths above 0 in nm, the shortest first");
        }
        if (!(number >= parameter.min && number <= parameter.max)) {
            return failureWithin(
                fmt::format("/values/{}", i),
                fmt::format("the value is outside the range of '{}'", parameter.id),
                fmt::format("{} to {}", shortestFloatText(parameter.min),
                            shortestFloatText(parameter.max)));
        }
        spectrum.numbers.insert(spectrum.numbers.end(), {wavelength, number});
    }
    return spectrum;
}

Json spectrumJson(const NumberList& spectrum) {
    Json json{{"nm", Json::array()}, {"values", Json::array()}};
    for (std::size_t i = 0; 2 * i < spectrum.numbers.size(); ++i) {
        json["nm"].push_back(wavelengthOf(spectrum, i));
        json["values"].push_back(numberOf(spectrum, i));
    }
    return json;
}

} // namespace

const NumberList* spectrumIn(const Value& value) {
    const auto* list = std::get_if<NumberList>(&value);
    return list != nullptr && list->type == spectrumWord ? list : nullptr;
}

ValueReading fillFromJson(const Parameter& parameter, const Json& json) {
    return parameter.type == ParameterType::Vec3 && json.is_object()
               ? spectrumFromJson(parameter, json)
               : valueFromJson(parameter, json);
}

Json fillJson(const Value& fill) {
    const NumberList* spectrum = spectrumIn(fill);
    return spectrum == nullptr ? toJson(fill) : spectrumJson(*spectrum);
}

glm::dvec3 atWavelengths(const NumberList& spectrum, const glm::dvec3& nm) {
    return {atWavelength(spectrum, nm.x), atWavelength(spectrum, nm.y),
            atWavelength(spectrum, nm.z)};
}

std::pair<double, double> rangeOf(const NumberList& spectrum) {
    return {wavelengthOf(spectrum, 0), wavelengthOf(spectrum, spectrum.numbers.size() / 2 - 1)};
}

Value atSrgbWavelengths(const Value& value) {
    const NumberList* spectrum = spectrumIn(value);
    return spectrum == nullptr ? value : Value(atWavelengths(*spectrum, srgbWavelengths));
}

} // namespace patina
