// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "reference/reference.h"
#include "shading/program/block_place.h"

namespace patina {

/// Reflects polarised light by a Fresnel term in double precision, as passes/polarised.glsl and
/// writePolarisedFresnel() do on the device: by the term's own function for light that swings
/// across the plane of incidence, by the indices that its roles name, or as the clear material that
/// reflects as much facing it.
class PolarisedTerm {
  public:
    /// Takes the code of the block at `place`, which must outlive the term.
    PolarisedTerm(const BlockPlace& place, const reference::Block& code);

    /// Returns the reflectance of light of which such a share swings across the plane of incidence:
    /// half of ordinary light. `incidence` is a cosine and 1 - cosine.
    glm::dvec3 reflectance(const std::array<double, 2>& incidence, reference::Parameters values,
                           double fieldAcross) const;

    /// Returns a block that reflects so in the place of the term's, on the thread whose
    /// FieldAcross exists. It lives as long as the term stays where it is.
    const reference::Block& block() const { return block_; }

    const reference::Block& code() const { return *code_; }

  private:
    /// Are offsets of numbers with a role, where a field has it.
    struct Offsets {
        std::optional<std::size_t> outside;
        std::optional<std::size_t> inside;
        std::optional<std::size_t> index;
        std::optional<std::size_t> extinction;
        std::optional<std::size_t> f0;
        std::optional<std::size_t> filter;
    };

    glm::dvec3 facingOf(reference::Parameters values) const;
    std::optional<std::array<double, 2>> reflectancesOf(int channel,
                                                        const std::array<double, 2>& incidence,
                                                        reference::Parameters values) const;

    const reference::Block* code_;
    Offsets at_;
    reference::Block block_;
};

/// Says, while it exists, how much of the light that the thread's blocks of polarised terms reflect
/// swings across the plane of incidence: what the variable of that name says on the device.
class FieldAcross {
  public:
    FieldAcross(const PolarisedTerm& term, double fieldAcross);
    ~FieldAcross();
    FieldAcross(const FieldAcross&) = delete;
    FieldAcross& operator=(const FieldAcross&) = delete;
};

/// Returns how much of light from l swings across the plane of l and v, as passes/polarised.glsl;
/// `field` is the direction in which it swings and the share of it that does.
double acrossOf(const glm::dvec3& l, const glm::dvec3& v, const glm::dvec4& field);

} // namespace patina
