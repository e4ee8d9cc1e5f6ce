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

/// Returns an aim that is a material.
Result<MatchAim> matchAim(const Material& material, const Catalog& catalog, std::size_t samples);

/// Returns a target of a material's model (sweepVariant()), in directions that are dense around the
/// mirror direction and sparse at grazing angles. It is an error where the model is no
/// reflectance (whyNoReflectance()) or cannot be evaluated (ModelValues).
Result<MatchTarget> matchTarget(const EvalCase& model, std::size_t samples, const Catalog& catalog);

} // namespace patina
