// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "catalog/catalog.h"
#include "catalog/parameter_layout.h"
#include "core/error.h"

namespace patina {

/// A block with values, as a case names it.
struct EvalBlock {
    const Block* block = nullptr;
    Values values; ///< those that were given, within their ranges and not rounded
    AccuracyLevels accuracy;

    std::vector<double> packedValues() const { return packed(*block, values, accuracy); }
};

/// What one line of `patina eval` asks for.
struct EvalCase {
    enum class Subject { Model, Fresnel, Light, Fog, Function };

    nlohmann::json id;
    Subject subject = Subject::Model;
    bool gpu = false;

    EvalBlock block;
    EvalBlock slot; ///< what fills the model's slot; null block when it has none

    /// As given, of any length. A light's point is in `l`.
    glm::dvec3 n{0.0, 0.0, 1.0};
    glm::dvec3 t{1.0, 0.0, 0.0};
    glm::dvec3 l{0.0};
    glm::dvec3 v{0.0};
    double number = 0.0; ///< the cosine of a Fresnel block, the distance of fog

    std::string function; ///< of the shader library
    std::vector<double> arguments;
};

/// A case, or what is wrong with it. The id is what could be read of it.
struct EvalLine {
    nlohmann::json id;
    Result<EvalCase> request;
};

/// Reads one line. Parameters that are not given have their defaults; one that is unknown, of the
/// wrong type or outside its range is an error.
EvalLine readEvalLine(std::string_view line, const Catalog& catalog);

} // namespace patina
