// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/approximation/approximation_subject.h"

#include <fmt/format.h>

#include "measure/stability/sweep_cases.h"

namespace patina {
namespace {

Checked<EvalCase> caseOfValues(const Block& block, const Values& values) {
    const auto functions = evaluatedFunctions(block);
    if (functions.empty()) {
        return tl::unexpected(
            oneError(failure(fmt::format("\"{}\" gives no single values", block.id),
                             "a preset, or a block of a kind that `patina eval` takes")
                         .value()));
    }
    EvalCase made;
    made.subject = *subjectOf(*functions.front());
    made.called = functions.front();
    made.block.block = &block;
    for (const Parameter& parameter : block.parameters) {
        const auto given = values.find(parameter.id);
        const Value& value = given == values.end() ? parameter.defaultValue : given->second;
        made.block.values.emplace(parameter.id, roundedToFloat(value));
    }
    return made;
}

} // namespace

Checked<EvalCase> defaultCase(const Catalog& catalog, const Block& block) {
    return block.kind == kinds::models
               ? sweepVariant(catalog, defaultMaterial(block)).map_error(oneError)
               : caseOfValues(block, {});
}

Checked<EvalCase> caseInMaterial(const Catalog& catalog, const Material& material,
                                 const Block& block) {
    if (block.kind == kinds::models) {
        Material exact = material;
        exact.accuracy.clear();
        return sweepVariant(catalog, exact).map_error(oneError);
    }
    const BlockValues* part = material.part(block.kind);
    return caseOfValues(block, part != nullptr ? part->parameters : Values());
}

} // namespace patina
