// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <string>
#include <vector>

#include <nlohmann/json.hpp>

#include "catalog/catalog.h"
#include "catalog/parameter_layout.h"
#include "core/error.h"

namespace patina {

/// Holds the numbers of all fields of a struct, in order.
using FieldNumbers = std::array<double, 8>;

/// Holds a block with values, as a case names it.
struct EvalBlock {
    const Block* block = nullptr;
    Values values; ///< are those that were given, within their ranges and not rounded
    AccuracyLevels accuracy;

    std::vector<double> packedValues() const { return packed(*block, values, accuracy); }
};

/// Holds the arguments at which a block is evaluated. Each kind of block reads those of its
/// function.
struct EvalPlace {
    /// Is the normal; it, t, l and v are as given, of any length. A light's point is in `l`; fog
    /// has the eye in `l`, and in `v` the unit direction from it.
    glm::dvec3 n{0.0, 0.0, 1.0};
    glm::dvec3 t{1.0, 0.0, 0.0};
    glm::dvec3 l{0.0};
    glm::dvec3 v{0.0};
    glm::dvec2 pixel{0.0}; ///< is for models that draw marks on the picture
    double number = 0.0;   ///< is the cosine of a Fresnel block, the distance of fog
    FieldNumbers fields{}; ///< are other arguments (fieldsOf())
};

/// Describes one function of a block or of the shader library with its arguments, to be evaluated
/// on the CPU or on the graphics device.
struct EvalCase : EvalPlace {
    /// Tells which arguments the function takes. Model is a block's function of directions; Fields
    /// is one of the fields of another struct, of a number, or of the block's values alone;
    /// Function is one of the library.
    enum class Subject { Model, Fresnel, Light, Fog, Fields, Function };

    nlohmann::json id; ///< identifies the case; it is returned with the answer
    Subject subject = Subject::Model;
    bool gpu = false;

    EvalBlock block;
    /// Is the function of the block's kind; null: its first one.
    const BlockFunction* called = nullptr;
    EvalBlock slot; ///< fills the model's slot; its block is null where there is none

    std::string function; ///< is the name of a function of the shader library
    std::vector<double> arguments;
};

/// Returns the function of a block that a case calls.
const BlockFunction& calledFunction(const EvalCase& request);

/// Returns how many numbers the block's function returns.
std::size_t resultsOf(const EvalCase& request);

/// Returns how many of them, from the first on, may have any sign, as those of a direction.
std::size_t signedResultsOf(const EvalCase& request);

/// Returns the fields that the block's function takes; empty unless the subject is Fields.
std::span<const ArgumentField> fieldsOf(const EvalCase& request);

/// Returns the subject of a block's function, by its argument; nothing where a case cannot hold the
/// argument.
std::optional<EvalCase::Subject> subjectOf(const BlockFunction& function);

/// Returns the functions of a kind that have a subject.
std::vector<const BlockFunction*> evaluatedFunctions(const BlockKind& kind);
std::vector<const BlockFunction*> evaluatedFunctions(const Block& block);

/// Returns the case as a line that `patina eval` reads, with all its values.
nlohmann::json evalJson(const EvalCase& request);

} // namespace patina
