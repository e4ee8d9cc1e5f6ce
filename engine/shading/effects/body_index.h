// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include <glm/vec3.hpp>

#include "catalog/wavelengths.h"
#include "reference/reference.h"
#include "shading/effects/refraction.h"

namespace patina {

/// Tells whether a body has the index of its own block, whatever its surface reflects.
bool hasOwnIndex(const RefractionChoice& choice);

/// Finds the index of refraction of a body relative to what surrounds it, by the roles of
/// parameters: the refraction's own `index`, or, where its `indexFrom` does not say "own", that of
/// the material's Fresnel term or the model's `index`. A term tells it as `indexInside`, as a
/// function that works it out (reference::indicesSuffix), as the `index` of what does not absorb,
/// each over `indexOutside`, or as the mean of `f0`: sqrt(f0) = (n - 1) / (n + 1). 0.1 .. 10.
class BodyIndex {
  public:
    /// Is of light of these wavelengths in nm for red, green and blue. It points to no argument but
    /// the catalogue.
    BodyIndex(const Material& material, const RefractionChoice& choice, const Catalog& catalog,
              const glm::dvec3& wavelengths = srgbWavelengths);

    /// Tells whether the term's index differs between the channels, which then decides how far
    /// colours come apart, in place of the refraction's `dispersion`.
    bool bendsApart() const;

    /// Returns the indices of the three channels by the term: those of all light where it does not
    /// bend them apart.
    const glm::dvec3& channels() const { return channels_; }

    /// Returns the index for light of a wavelength in nm, above 0. One number and a dispersion are
    /// Cauchy's two terms, as dispersedIndices() has them (lib/interface.glsl). At least 0.01.
    double at(double wavelength) const;

    /// Return what the refraction's own functions are given: with a dispersion the index is that
    /// for the line d, else that of the green channel, and the dispersion 20 over Abbe's number.
    double ofBlock() const;
    double dispersion() const;

  private:
    /// Is a function of a term with its packed values.
    struct WorkedOut {
        const reference::BlockCall* call = nullptr;
        std::vector<double> values;
        std::size_t wavelengths = 0; ///< counts numbers before those that are wavelengths
        double unit = 1.0;           ///< of theirs per nm
        double outside = 1.0;

        glm::dvec3 at(const glm::dvec3& nm) const;
    };

    void takeTerm(const Block& term, const Values& values, const AccuracyLevels& levels,
                  const glm::dvec3& wavelengths);
    void workOut(const Block& term, const Values& values, const AccuracyLevels& levels,
                 double outside);

    bool isKnown_ = false;
    glm::dvec3 channels_{1.0};
    glm::dvec3 wavelengths_; ///< nm, of the channels
    std::optional<WorkedOut> workedOut_;
    std::optional<double> dispersion_; ///< is the refraction's own, where it has one
};

} // namespace patina
