// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <set>
#include <vector>

#include "measure/approximation/compiled_choices.h"
#include "measure/approximation/shader_edit.h"
#include "measure/interpreter/shader_evaluator.h"

namespace patina {

/// Is a shader with what its expressions were in many cases.
struct ObservedShader {
    const ShaderSyntax& syntax;
    const std::vector<ObservedValues>& values; ///< in the order of the syntax's expressions
    const std::set<int>& functions;            ///< are those whose text may be changed
    const CompiledChoices* choices = nullptr;  ///< keeps branches of declared levels as they are

    const ShaderExpression& at(int index) const {
        return syntax.expressions[static_cast<std::size_t>(index)];
    }
    const ObservedValues& valuesOf(int index) const {
        return values[static_cast<std::size_t>(index)];
    }
    /// Tells whether a condition may be taken as true or false: none that asks for a level that the
    /// block's author declared, for what it leads to is no way that was found.
    bool isFree(int condition) const {
        return choices == nullptr || !choices->asksLevel(condition);
    }
};

/// Returns the expressions that were evaluated and whose text can be replaced by another one.
std::vector<int> changeableExpressions(const ObservedShader& shader);

/// Returns a part of a text for words: one line, without its middle where it is long.
std::string shortCode(std::string_view code);

/// Returns moves that leave out a summand, a factor, a bound or a case, take a branch always or
/// never, or put a number in the place of what hardly changes.
std::vector<CheapMove> droppedTerms(const ObservedShader& shader);

/// Returns moves that put what is known to be cheaper in the place of powers, roots, angles,
/// divisions, Fresnel and masking terms.
std::vector<CheapMove> knownSwaps(const ObservedShader& shader);

/// Returns the move that puts numbers in the place of all that was the same in every case, as it is
/// where a preset's values stay; none where nothing is.
std::vector<CheapMove> foldedValues(const ObservedShader& shader);

} // namespace patina
