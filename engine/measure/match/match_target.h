// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <glm/vec3.hpp>

#include "core/error.h"
#include "material/material.h"
#include "material/reading_rights.h"
#include "measure/eval/eval_case.h"
#include "measured/measured_reflectance.h"

namespace patina {

/// Holds the reflectance to be matched: pi f cos(theta_l), as models return it, at many pairs of
/// directions.
struct MatchTarget {
    std::vector<DirectionPair> pairs;
    std::vector<glm::dvec3> values;
    bool isIsotropic = true;
    std::string name{}; ///< says for people what it is of; may be empty
    std::vector<double> weights{}; ///< say how much each pair counts; empty: all count alike

    /// Returns the first `count`, which are spread as all are; all where there are fewer.
    MatchTarget first(std::size_t count) const;
};

/// Returns a target of what was measured, without directions more than 80 degrees from the normal,
/// where instruments see little. It is an error where nothing is left.
Result<MatchTarget> matchTarget(const MeasuredReflectance& measured, std::size_t samples);

/// Holds what is to be matched. Something measured has no material.
struct MatchAim {
    MatchTarget target;
    std::optional<Material> material;
    Errors notes; ///< are those of reading a preset
};

/// Reads a preset, or by its ending a measured file (isMeasuredFile()).
Checked<MatchAim> readMatchAim(const std::filesystem::path& file, const Catalog& catalog,
                               std::size_t samples, const ReadingRights& rights = {});

/// Says in which directions a material is matched.
enum class MatchDirections {
    Spread, ///< are those of spreadPair(): dense around the mirror direction
    /// Are those of the pixels of a ball that is lit from all around. A tenth of the weight is on
    /// those of spreadPair(), so that a narrow highlight is met.
    LitBall
};

/// Returns an aim that is a material.
Result<MatchAim> matchAim(const Material& material, const Catalog& catalog, std::size_t samples,
                          MatchDirections directions = MatchDirections::Spread);

/// Returns a target of a material's model (sweepVariant()), without directions more than 80 degrees
/// from the normal. It is an error where the model is no reflectance (whyNoReflectance()) or cannot
/// be evaluated (ModelValues).
Result<MatchTarget> matchTarget(const EvalCase& model, std::size_t samples, const Catalog& catalog,
                                MatchDirections directions = MatchDirections::Spread);

} // namespace patina
