// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/error/polarised_term.h"

#include <algorithm>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "measure/eval/library_call.h"

namespace patina {
namespace {

constexpr double halfAcross = 0.5; ///< is the share of ordinary light

/// Is what the thread's blocks of polarised terms reflect now.
struct Polarised {
    const PolarisedTerm* term = nullptr;
    double across = halfAcross;
};
thread_local Polarised polarisedNow;

/// Is the one function of such a block.
void callPolarised(const double* in, double* out, reference::Parameters values) {
    const glm::dvec3 share =
        polarisedNow.term->reflectance({in[0], in[1]}, values, polarisedNow.across);
    std::copy_n(&share.x, 3, out);
}

constexpr reference::BlockCall polarisedCalls[] = {{"", 2, 3, &callPolarised}};

/// Returns parts in proportion to what a surface reflects of light that swings across and along the
/// plane of incidence, where it reflects so much facing the light and so much from there.
std::array<double, 2> likeClear(const std::array<double, 2>& incidence, double facing,
                                double ordinary) {
    const double index =
        std::min(libraryCall<1, 1>("indexFromF0", {std::clamp(facing, 0.0, 1.0)})[0], 1e4);
    const double ratio =
        libraryCall<1, 3>("dielectricRatio", {incidence[0], incidence[1], index})[0];
    return {1.0, std::clamp(2.0 * ordinary - 1.0, ratio, 1.0)};
}

std::optional<std::size_t> offsetOf(const BlockPlace& place, std::string_view role) {
    const ParameterField* field = place.layout.withRole(role);
    return field == nullptr ? std::nullopt : std::optional(field->offset);
}

} // namespace

PolarisedTerm::PolarisedTerm(const BlockPlace& place, const reference::Block& code)
    : code_(&code), at_{offsetOf(place, roles::indexOutside), offsetOf(place, roles::indexInside),
                        offsetOf(place, roles::index),        offsetOf(place, roles::extinction),
                        offsetOf(place, roles::f0),           offsetOf(place, roles::polarisation)},
      block_(code) {
    block_.calls = polarisedCalls;
    if (place.block->withRole(roles::wavelengths) != nullptr) {
        at_ = Offsets(); // of which a film's one index tells nothing
    }
}

glm::dvec3 PolarisedTerm::reflectance(const std::array<double, 2>& incidence,
                                      reference::Parameters values, double fieldAcross) const {
    const glm::dvec3 ordinary = code_->fresnel(incidence[0], incidence[1], values);
    constexpr int across = 1; // "s", the first behind "unpolarised"
    const int filter = at_.filter ? static_cast<int>(values[*at_.filter]) : 0;
    if (filter != 0) {
        return 2.0 * (filter == across ? fieldAcross : 1.0 - fieldAcross) * ordinary;
    }
    if (code_->optionalCall(reference::acrossSuffix) != nullptr) {
        const auto s = code_->call<3>(reference::acrossSuffix, incidence, values);
        const glm::dvec3 swings(s[0], s[1], s[2]);
        return glm::max(glm::mix(2.0 * ordinary - swings, swings, fieldAcross), 0.0);
    }
    const glm::dvec3 facing = facingOf(values);
    glm::dvec3 share;
    for (int channel = 0; channel < 3; ++channel) {
        const auto both = reflectancesOf(channel, incidence, values);
        const auto [s, p] = both ? *both : likeClear(incidence, facing[channel], ordinary[channel]);
        const double sum = s + p;
        share[channel] = sum > 1e-30 ? 2.0 * glm::mix(p, s, fieldAcross) / sum : 1.0;
    }
    return ordinary * share;
}

/// Returns what the term reflects of light that comes along the normal.
glm::dvec3 PolarisedTerm::facingOf(reference::Parameters values) const {
    if (at_.f0) {
        return {values[*at_.f0], values[*at_.f0 + 1], values[*at_.f0 + 2]};
    }
    return code_->fresnel(1.0, 0.0, values);
}

/// Returns what one channel reflects of light that swings across and along the plane of incidence,
/// by the indices that roles name; nothing where none do.
std::optional<std::array<double, 2>>
PolarisedTerm::reflectancesOf(int channel, const std::array<double, 2>& incidence,
                              reference::Parameters values) const {
    const auto in = static_cast<std::size_t>(channel);
    const double outside = at_.outside ? values[*at_.outside] : 1.0;
    if (at_.outside && at_.inside) {
        return libraryCall<2, 4>("dielectricReflectances",
                                 {incidence[0], incidence[1], outside, values[*at_.inside]});
    }
    if (at_.index && at_.extinction) {
        return libraryCall<2, 5>("conductorReflectances",
                                 {incidence[0], incidence[1], outside, values[*at_.index + in],
                                  values[*at_.extinction + in]});
    }
    return std::nullopt;
}

FieldAcross::FieldAcross(const PolarisedTerm& term, double fieldAcross) {
    polarisedNow = {&term, fieldAcross};
}

FieldAcross::~FieldAcross() {
    polarisedNow = Polarised();
}

double acrossOf(const glm::dvec3& l, const glm::dvec3& v, const glm::dvec4& field) {
    const glm::dvec3 direction(field);
    const glm::dvec3 across = glm::cross(l, v);
    const glm::dvec3 swings = direction - glm::dot(direction, l) * l;
    const double size = glm::dot(across, across) * glm::dot(swings, swings);
    const double along = glm::dot(across, swings);
    return size > 1e-14 ? glm::mix(halfAcross, std::min(along * along / size, 1.0), field.w)
                        : halfAcross;
}

} // namespace patina
