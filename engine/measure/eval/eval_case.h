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

/// Holds the numbers of all fields of a struct, one after the other.
using FieldNumbers = std::array<double, 8>;

/// Represents a block with values, as a case names it.
struct EvalBlock {
    const Block* block = nullptr;
    Values values; ///< those that were given, within their ranges and not rounded
    AccuracyLevels accuracy;

    std::vector<double> packedValues() const { return packed(*block, values, accuracy); }
};

/// Says where a block is evaluated. Each kind of block reads what it is a function of.
struct EvalPlace {
    /// Is as given, of any length. A light's point is in `l`; fog's eye is there, and in `v` the
    /// unit direction from it.
    glm::dvec3 n{0.0, 0.0, 1.0};
    glm::dvec3 t{1.0, 0.0, 0.0};
    glm::dvec3 l{0.0};
    glm::dvec3 v{0.0};
    glm::dvec2 pixel{0.0}; ///< for models that draw marks on the picture
    double number = 0.0;   ///< the cosine of a Fresnel block, the distance of fog
    FieldNumbers fields{}; ///< of what else a block is a function of (fieldsOf())
};

/// Represents one function of a block at one place, to be evaluated on the CPU or on the graphics
/// device; or one function of the shader library.
struct EvalCase : EvalPlace {
    /// Tells what a case calls. Model: a block's function of directions; Fields: of the fields of
    /// another struct, of a number, or of the block's values alone.
    enum class Subject { Model, Fresnel, Light, Fog, Fields, Function };

    nlohmann::json id; ///< whatever tells the case from others; goes back with its answer
    Subject subject = Subject::Model;
    bool gpu = false;

    EvalBlock block;
    /// Is the function of the block's kind; null: its first one.
    const BlockFunction* called = nullptr;
    EvalBlock slot; ///< what fills the model's slot; null block when it has none

    std::string function; ///< of the shader library
    std::vector<double> arguments;
};

/// Returns the function of a block that a case calls.
const BlockFunction& calledFunction(const EvalCase& request);

/// Returns how many numbers the answer of a block is, by what the function returns.
std::size_t resultsOf(const EvalCase& request);

/// Returns how many of them, from the first on, say a direction: their sign says nothing.
std::size_t signedResultsOf(const EvalCase& request);

/// Returns the fields that the block's function takes; none of another subject.
std::span<const ArgumentField> fieldsOf(const EvalCase& request);

/// Returns what a function of a block is evaluated as, by what it takes; nothing where that cannot
/// be said in a line.
std::optional<EvalCase::Subject> subjectOf(const BlockFunction& function);

/// Returns the functions of a kind that are evaluated.
std::vector<const BlockFunction*> evaluatedFunctions(const BlockKind& kind);
std::vector<const BlockFunction*> evaluatedFunctions(const Block& block);

/// Returns the case as a line that `patina eval` reads, all its values included.
nlohmann::json evalJson(const EvalCase& request);

} // namespace patina
