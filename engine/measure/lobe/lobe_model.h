// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>

#include "material/material.h"
#include "measure/eval/model_values.h"

namespace patina {

/// Tells which part of a model's light is looked at: all of it, a term of the sum, or a factor of
/// the highlight.
enum class LobeTerm { Whole, Diffuse, Highlight, Distribution, Masking, Fresnel };

/// Tells whether a term is a factor, which is no reflectance.
inline bool isFactor(LobeTerm term) {
    return term >= LobeTerm::Distribution;
}

/// Returns the word of a term: "whole", "diffuse", "distribution"; and the term of a word.
std::string_view wordOf(LobeTerm term);
std::optional<LobeTerm> lobeTermOf(std::string_view word);

/// Is the reflectance of a material's model in double precision, with the material's values and
/// what fills its slot. Images, the opacity, what it emits, and a Fresnel term that is blended over
/// the light are no part of it. Its frame is fixed: the normal is +z, the tangent +x.
class LobeModel {
  public:
    /// Is an error for an unknown model and for one without code in double precision, and where the
    /// model does not tell such a term apart.
    static Result<LobeModel> create(const Catalog& catalog, const Material& material,
                                    LobeTerm term = LobeTerm::Whole);

    /// Returns pi f cos(theta_l) for unit directions, cut at 0 from below. What is not finite
    /// counts as 0.
    glm::dvec3 value(const glm::dvec3& l, const glm::dvec3& v) const;

    /// Returns f in 1/sr for unit directions; 0 where l is not above the surface.
    glm::dvec3 reflectance(const glm::dvec3& l, const glm::dvec3& v) const;

    /// Is an error where the model did not end in some direction, so that what it returned means
    /// nothing.
    Result<void> ending() const;

    /// Says that the reflectance does not change where light and viewer turn about the normal.
    bool isIsotropic() const { return isIsotropic_; }

  private:
    LobeModel(const Block& block, ModelValues values)
        : block_(&block), values_(std::move(values)) {}

    const Block* block_; ///< is the catalogue's
    ModelValues values_;
    std::optional<ModelValues> subtracted_; ///< is empty where nothing is taken away
    bool isIsotropic_ = false;
};

/// Says why a model is no reflectance, so that its albedo means nothing; empty where it is one.
std::string whyNoReflectance(const Block& model);

/// Returns a material's model to be plotted. It is an error, which says why, where its values are
/// no reflectance, and where LobeModel::create() is one.
Result<LobeModel> reflectanceModel(const Catalog& catalog, const Material& material,
                                   LobeTerm term = LobeTerm::Whole);

/// Says which plots mean nothing for a model that is no reflectance, and why; empty for one that
/// is.
std::string whyNoPlots(const Block& model);

/// Tells whether the model's light is the sum of a diffuse term and a highlight, so that these can
/// be looked at alone.
bool hasTerms(const Block& model);

/// Returns the case without its diffuse term.
EvalCase withoutDiffuse(const EvalCase& request);

/// Returns the material with every accuracy choice at its exact level.
Material atExactLevels(const Material& material);

} // namespace patina
