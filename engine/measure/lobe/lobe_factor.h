// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "measure/lobe/lobe_model.h"

namespace patina {

/// Is a factor of a model's highlight in double precision, in the frame of LobeModel.
class LobeFactor {
  public:
    /// It is an error where the model has no such factor, and for a term that is none. A
    /// distribution and a masking are what the model's code tells by functions of these names. The
    /// Fresnel factor is that of the slot, at the cosine at which the model takes it; which one
    /// that is, is found by the model's values.
    static Result<LobeFactor> create(const Catalog& catalog, const Material& material,
                                     LobeTerm term);

    /// Returns the factor for unit directions: a distribution in 1/sr, else a share. What is not
    /// finite counts as 0.
    glm::dvec3 at(const glm::dvec3& l, const glm::dvec3& v) const;

    const std::string& name() const { return name_; } ///< is "distribution", "masking", "Fresnel"

  private:
    /// Names a cosine at which a Fresnel reflectance is taken.
    enum class Cosine { Half, Light, View };

    glm::dvec3 fresnelAt(Cosine cosine, const glm::dvec3& l, const glm::dvec3& v) const;
    Result<Cosine> findCosine(const EvalCase& request) const;

    std::string name_;
    const reference::Block* block_ = nullptr;
    const reference::Block* slot_ = nullptr;         ///< is null where the slot is empty
    const reference::ModelFactor* factor_ = nullptr; ///< is null for the Fresnel factor
    std::vector<double> values_;
    std::vector<double> slotValues_;
    Cosine cosine_ = Cosine::Half;
};

/// Lists the factors that a material's model has.
std::vector<LobeTerm> factorsOf(const Catalog& catalog, const Material& material);

} // namespace patina
