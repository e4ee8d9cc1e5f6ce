// SPDX-License-Identifier: GPL-3.0-or-later
#include "shading/effects/body_index.h"

#include <algorithm>
#include <cmath>

#include <glm/common.hpp>

#include "catalog/index_trend.h"
#include "shading/program/compiled_block.h"
#include "shading/program/given_value.h"

namespace patina {
namespace {

// The lines F, d and C by which Abbe's numbers are stated, in nm.
constexpr double lineF = 486.1;
constexpr double lineD = 587.6;
constexpr double lineC = 656.3;

template <class Type>
std::optional<Type> valueIn(const Block& block, const Values& values, std::string_view role) {
    const Parameter* parameter = block.withRole(role);
    const auto* value =
        parameter == nullptr ? nullptr : std::get_if<Type>(&givenValue(*parameter, values));
    return value == nullptr ? std::nullopt : std::optional(*value);
}

/// Returns the index of a dielectric that reflects so much of what meets it straight.
double indexOf(const glm::dvec3& f0) {
    const double mean = std::clamp((f0.x + f0.y + f0.z) / 3.0, 0.0, 0.66);
    return (1.0 + std::sqrt(mean)) / (1.0 - std::sqrt(mean));
}

double limited(double index) {
    return std::isfinite(index) ? std::clamp(index, 0.1, 10.0) : 1.0;
}

/// Returns the wavelengths in nm at which a term is asked for its channels.
glm::dvec3 wavelengthsOf(const Block& term, const Values& values, const glm::dvec3& ofScene) {
    const Parameter* parameter = term.withRole(roles::wavelengths);
    if (parameter == nullptr) {
        return ofScene;
    }
    glm::dvec3 numbers = valueIn<glm::dvec3>(term, values, roles::wavelengths).value_or(ofScene);
    takeWavelengths(*parameter, ofScene, &numbers.x);
    return numbers / nmInUnit(*parameter);
}

double indexAt(double wavelength, double index, double dispersion) {
    const auto inverseSquare = [](double nm) { return 1.0 / (nm * nm); };
    const double spread = 0.05 * dispersion * (index - 1.0);
    const double b = spread / (inverseSquare(lineF) - inverseSquare(lineC));
    return std::max(index + b * (inverseSquare(wavelength) - inverseSquare(lineD)), 0.01);
}

/// Returns what lies between numbers of three channels, straight from one to the next.
double between(const glm::dvec3& channels, const glm::dvec3& wavelengths, double wavelength) {
    const double way = wavelength - wavelengths.y;
    const int side = way * (wavelengths.x - wavelengths.y) > 0.0 ? 0 : 2;
    const double gap = wavelengths[side] - wavelengths.y;
    const double share = gap == 0.0 ? 0.0 : std::clamp(way / gap, 0.0, 1.0);
    return glm::mix(channels.y, channels[side], share);
}

} // namespace

bool hasOwnIndex(const RefractionChoice& choice) {
    return valueIn<std::string>(*choice.block, *choice.values, roles::indexFrom).value_or("own") ==
           "own";
}

BodyIndex::BodyIndex(const Material& material, const RefractionChoice& choice,
                     const Catalog& catalog, const glm::dvec3& wavelengths)
    : wavelengths_(wavelengths) {
    const Block& block = *choice.block;
    if (const Parameter* dispersion = block.withRole(roles::dispersion)) {
        const double given =
            valueIn<double>(block, *choice.values, roles::dispersion).value_or(0.0);
        dispersion_ =
            std::isfinite(given) ? std::clamp(given, dispersion->min, dispersion->max) : 0.0;
    }
    std::optional<double> index;
    if (!hasOwnIndex(choice)) {
        const BlockValues* part = material.part(kinds::fresnel);
        const Block* term = part == nullptr ? nullptr : catalog.find(kinds::fresnel, part->id);
        if (term != nullptr) {
            takeTerm(*term, part->parameters, material.accuracy, wavelengths);
        }
        const Block* model = catalog.find(kinds::models, material.model.id);
        if (model != nullptr) {
            index = valueIn<double>(*model, material.model.parameters, roles::index);
        }
    }
    if (!isKnown_) {
        const auto own = valueIn<double>(block, *choice.values, roles::index);
        channels_ = glm::dvec3(index ? *index : own.value_or(1.0));
    }
    for (int channel = 0; channel < 3; ++channel) {
        channels_[channel] = limited(channels_[channel]);
    }
}

void BodyIndex::takeTerm(const Block& term, const Values& values, const AccuracyLevels& levels,
                         const glm::dvec3& wavelengths) {
    const double outside =
        std::max(valueIn<double>(term, values, roles::indexOutside).value_or(1.0), 1e-6);
    const auto inside = valueIn<double>(term, values, roles::indexInside);
    const auto index = valueIn<glm::dvec3>(term, values, roles::index);
    const auto extinction = valueIn<glm::dvec3>(term, values, roles::extinction);
    const auto f0 = valueIn<glm::dvec3>(term, values, roles::f0);
    wavelengths_ = wavelengthsOf(term, values, wavelengths);
    isKnown_ = true;
    if (inside) {
        channels_ = glm::dvec3(indexAtTemperature(term, values, *inside) / outside);
    } else if (index) {
        isKnown_ = !extinction || *extinction == glm::dvec3(0.0);
        channels_ = *index / outside;
    } else if (f0) {
        channels_ = glm::dvec3(indexOf(*f0));
    } else {
        workOut(term, values, levels, outside);
    }
}

void BodyIndex::workOut(const Block& term, const Values& values, const AccuracyLevels& levels,
                        double outside) {
    const auto code = compiledBlock(term);
    const reference::BlockCall* call =
        code ? (*code)->optionalCall(reference::indicesSuffix) : nullptr;
    const Parameter* parameter = term.withRole(roles::wavelengths);
    isKnown_ = call != nullptr && parameter != nullptr;
    if (!isKnown_) {
        return;
    }
    const std::size_t offset = layoutOf(term).withRole(roles::wavelengths)->offset;
    workedOut_ =
        WorkedOut{call, packed(term, values, levels), offset, nmInUnit(*parameter), outside};
    channels_ = workedOut_->at(wavelengths_);
}

glm::dvec3 BodyIndex::WorkedOut::at(const glm::dvec3& nm) const {
    std::vector<double> asked = values;
    for (int channel = 0; channel < 3; ++channel) {
        asked[wavelengths + static_cast<std::size_t>(channel)] = nm[channel] * unit;
    }
    glm::dvec3 indices(0.0);
    call->call(nullptr, &indices.x, asked);
    return indices / outside;
}

bool BodyIndex::bendsApart() const {
    return channels_.x != channels_.y || channels_.z != channels_.y;
}

double BodyIndex::at(double wavelength) const {
    if (!bendsApart()) {
        return indexAt(wavelength, channels_.y, dispersion());
    }
    return limited(workedOut_ ? workedOut_->at(glm::dvec3(wavelength)).y
                              : between(channels_, wavelengths_, wavelength));
}

double BodyIndex::ofBlock() const {
    return bendsApart() && dispersion_ ? at(lineD) : channels_.y;
}

double BodyIndex::dispersion() const {
    if (!bendsApart()) {
        return dispersion_.value_or(0.0);
    }
    const double above = at(lineD) - 1.0;
    return above == 0.0 ? 0.0 : 20.0 * (at(lineF) - at(lineC)) / above;
}

} // namespace patina
