// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/stability/sweep_cases.h"

#include <algorithm>
#include <cmath>
#include <random>

#include <fmt/format.h>

#include "catalog/wavelength_ray_choices.h"
#include "material/measured_preset.h"
#include "measure/stability/edge_case_values.h"
#include "measure/stability/pairwise.h"

namespace patina {
namespace {

using Candidates = std::vector<Value>;

bool isZero(const Value& value) {
    return value == Value(0.0);
}

/// Returns the number of the program that a value needs: values with the same number share one.
std::size_t compiledState(const Parameter& parameter, const Value& value) {
    switch (parameter.compiled) {
    case Compiled::Yes:
        return infoOf(parameter.type).state(parameter, value);
    case Compiled::WhenZero:
        return isZero(value) ? 0 : 1;
    default:
        return 0;
    }
}

Candidates zeroAndNot(const Parameter& parameter) {
    const Candidates values = edgeCaseValues(parameter);
    Candidates both;
    for (const bool zero : {true, false}) {
        const auto found = std::find_if(values.begin(), values.end(), [zero](const Value& value) {
            return isZero(value) == zero;
        });
        if (found != values.end()) {
            both.push_back(*found);
        }
    }
    return both;
}

/// Returns a value for each program that a parameter can need; empty where it is not compiled in.
Candidates compiledCandidates(const Parameter& parameter) {
    switch (parameter.compiled) {
    case Compiled::Yes:
        return infoOf(parameter.type).states(parameter);
    case Compiled::WhenZero:
        return zeroAndNot(parameter);
    default:
        return {};
    }
}

std::vector<std::size_t> compiledCounts(const Block& block) {
    std::vector<std::size_t> counts;
    for (const Parameter& parameter : block.parameters) {
        if (const std::size_t count = compiledCandidates(parameter).size(); count > 0) {
            counts.push_back(count);
        }
    }
    for (const AccuracyChoice& choice : block.accuracy) {
        counts.push_back(isOfProgram(block, choice) ? 1 : choice.values.size());
    }
    return counts;
}

EvalBlock defaults(const Block& block) {
    EvalBlock made{&block, {}, {}};
    for (const Parameter& parameter : block.parameters) {
        made.values.emplace(parameter.id, roundedToFloat(parameter.defaultValue));
    }
    return made;
}

/// Returns the block with the compiled choices of a row of pairwiseRows(compiledCounts(block)).
EvalBlock chosen(const Block& block, const std::vector<std::size_t>& row) {
    EvalBlock made = defaults(block);
    std::size_t next = 0;
    for (const Parameter& parameter : block.parameters) {
        if (const Candidates values = compiledCandidates(parameter); !values.empty()) {
            made.values[parameter.id] = values[row[next++]];
        }
    }
    for (const AccuracyChoice& choice : block.accuracy) {
        made.accuracy[choice.id] = choice.values[row[next++]].id;
    }
    return made;
}

/// Returns as few rows as contain every choice; pairs of them are left to the filler's own sweep.
std::vector<std::vector<std::size_t>> everyChoiceOnce(const std::vector<std::size_t>& counts) {
    const std::size_t maxCount =
        counts.empty() ? 1 : *std::max_element(counts.begin(), counts.end());
    std::vector<std::vector<std::size_t>> rows(maxCount);
    for (std::size_t i = 0; i < maxCount; ++i) {
        for (const std::size_t count : counts) {
            rows[i].push_back(i % count);
        }
    }
    return rows;
}

std::vector<EvalBlock> fillers(const Catalog& catalog, const Block& block) {
    std::vector<EvalBlock> all;
    if (block.slots.empty()) {
        return all;
    }
    if (block.slots.front().defaultBlock.empty()) {
        all.emplace_back(); // the slot may stay empty
    }
    for (const Block* filler : catalog.ofKind(block.slots.front().kind)) {
        for (const auto& row : everyChoiceOnce(compiledCounts(*filler))) {
            all.push_back(chosen(*filler, row));
        }
    }
    return all;
}

/// Returns the edge-case values that need no other program, with the parameter's own value first.
Candidates candidates(const Parameter& parameter, const Value& own) {
    Candidates values{own};
    if (infoOf(parameter.type).isTable) {
        return values; // a drawing has one table
    }
    for (const Value& value : edgeCaseValues(parameter)) {
        const bool otherProgram = compiledState(parameter, value) != compiledState(parameter, own);
        if (!otherProgram && value != own) {
            values.push_back(value);
        }
    }
    return values;
}

/// Names a parameter of a case's block, or of what fills its slot, and the values it takes.
struct Factor {
    EvalBlock EvalCase::*part;
    const Parameter* parameter;
    Candidates values;
};

std::vector<Factor> factorsOf(const EvalCase& variant) {
    std::vector<Factor> factors;
    for (const auto part : {&EvalCase::block, &EvalCase::slot}) {
        const EvalBlock& block = variant.*part;
        if (block.block == nullptr) {
            continue;
        }
        for (const Parameter& parameter : block.block->parameters) {
            if (componentCount(parameter.type) > 0) {
                factors.push_back(
                    {part, &parameter, candidates(parameter, block.values.at(parameter.id))});
            }
        }
    }
    return factors;
}

/// Returns a random value that a slider reaches.
double sliderValue(const Parameter& parameter, std::mt19937& random) {
    const double low = parameter.softMin;
    const double high = parameter.softMax;
    const bool log = parameter.scale == Scale::Log && low > 0.0;
    std::uniform_real_distribution<double> along(log ? std::log(low) : low,
                                                 log ? std::log(high) : high);
    const double x = along(random);
    return std::clamp(log ? std::exp(x) : x, parameter.min, parameter.max);
}

Value ordinaryValue(const Factor& factor, std::mt19937& random) {
    const auto next = [&] { return sliderValue(*factor.parameter, random); };
    const ParameterTypeInfo& info = infoOf(factor.parameter->type);
    return info.hasRange ? info.ordinary(*factor.parameter, next)
                         : factor.values[random() % factor.values.size()];
}

void addChoices(std::string& text, const EvalBlock& block) {
    const auto add = [&text](std::string_view id, std::string_view value) {
        text += fmt::format("{}{}={}", text.empty() ? "" : ", ", id, value);
    };
    for (const Parameter& parameter : block.block->parameters) {
        const auto found = block.values.find(parameter.id);
        if (parameter.compiled == Compiled::No || parameter.compiled == Compiled::WhenEqual ||
            found == block.values.end()) {
            continue;
        }
        const std::size_t state = compiledState(parameter, found->second);
        add(parameter.id, parameter.compiled == Compiled::Yes
                              ? infoOf(parameter.type).stateWord(parameter, state)
                              : std::string_view(state == 0 ? "0" : "not 0"));
    }
    for (const auto& [id, level] : block.accuracy) {
        add(id, level);
    }
}

/// Returns a block with values and with those of the material's levels that it knows.
EvalBlock valued(const Block& block, const BlockValues& values, const AccuracyLevels& levels) {
    EvalBlock made = defaults(block);
    for (const auto& [id, level] : levels) {
        if (block.accuracyChoice(id) != nullptr) {
            made.accuracy.emplace(id, level);
        }
    }
    for (const Parameter& parameter : block.parameters) {
        if (const auto found = values.parameters.find(parameter.id);
            found != values.parameters.end()) {
            made.values[parameter.id] = roundedToFloat(conformed(parameter, found->second));
        }
    }
    return made;
}

EvalCase caseOf(EvalBlock block, const BlockFunction& function) {
    EvalCase made;
    made.subject = *subjectOf(function);
    made.block = std::move(block);
    made.called = &function;
    return made;
}

/// Adds one function of the block with each of its programs. Only a function of directions has
/// slots.
void addVariants(std::vector<EvalCase>& variants, const Catalog& catalog, const Block& block,
                 const BlockFunction& function) {
    std::vector<std::size_t> counts = compiledCounts(block);
    const std::vector<EvalBlock> slots = subjectOf(function) == EvalCase::Subject::Model
                                             ? fillers(catalog, block)
                                             : std::vector<EvalBlock>();
    if (!slots.empty()) {
        counts.push_back(slots.size());
    }
    for (const auto& row : pairwiseRows(counts)) {
        EvalCase& variant = variants.emplace_back(caseOf(chosen(block, row), function));
        if (!slots.empty()) {
            variant.slot = slots[row.back()];
        }
    }
}

} // namespace

std::vector<EvalCase> sweepVariants(const Catalog& catalog, const Block& block) {
    std::vector<EvalCase> variants;
    for (const BlockFunction* function : evaluatedFunctions(block)) {
        addVariants(variants, catalog, block, *function);
    }
    return variants;
}

Result<EvalCase> sweepVariant(const Catalog& catalog, const Material& material) {
    const Block* model = catalog.find(kinds::models, material.model.id);
    if (model == nullptr) {
        return failure(fmt::format("there is no model \"{}\"", material.model.id));
    }
    EvalCase variant;
    variant.block = valued(*model, material.model, material.accuracy);
    if (!model->slots.empty()) {
        const Slot& slot = model->slots.front();
        const BlockValues* part = material.part(slot.kind);
        const std::string id = part != nullptr ? part->id : slot.defaultBlock;
        const Block* filler = catalog.find(slot.kind, id);
        if (filler == nullptr && !id.empty()) {
            return failure(fmt::format("there is no {} block \"{}\"", slot.kind, id));
        }
        if (filler != nullptr) {
            variant.slot =
                valued(*filler, part != nullptr ? *part : BlockValues(), material.accuracy);
        }
    }
    // A file that cannot be read shows magenta or grey, which is nothing to measure.
    if (const auto read = readMeasuredOf(material, catalog); !read) {
        return tl::unexpected(read.error());
    }
    return variant;
}

std::vector<EvalCase> blendVariants(const Catalog& catalog, const Material& material) {
    const Block* model = catalog.find(kinds::models, material.model.id);
    const BlockValues* part = material.part(kinds::fresnel);
    const Block* block = part != nullptr ? catalog.find(kinds::fresnel, part->id) : nullptr;
    if (block == nullptr || (model != nullptr && model->slot(block->kind) != nullptr)) {
        return {};
    }
    std::vector<EvalCase> variants;
    for (const BlockFunction* function : evaluatedFunctions(*block)) {
        variants.push_back(caseOf(valued(*block, *part, material.accuracy), *function));
    }
    return variants;
}

std::vector<EvalCase> sweepRows(const EvalCase& variant) {
    const std::vector<Factor> factors = factorsOf(variant);
    std::vector<std::size_t> counts;
    for (const Factor& factor : factors) {
        counts.push_back(factor.values.size());
    }
    std::vector<EvalCase> cases;
    for (const auto& row : pairwiseRows(counts)) {
        EvalCase& next = cases.emplace_back(variant);
        for (std::size_t i = 0; i < factors.size(); ++i) {
            (next.*factors[i].part).values[factors[i].parameter->id] = factors[i].values[row[i]];
        }
    }
    return cases;
}

std::vector<EvalCase> ordinaryRows(const EvalCase& variant, std::size_t count) {
    std::mt19937 random(20251121);
    const std::vector<Factor> factors = factorsOf(variant);
    std::vector<EvalCase> cases(count, variant);
    for (EvalCase& next : cases) {
        for (const Factor& factor : factors) {
            if (factor.values.size() > 1) {
                (next.*factor.part).values[factor.parameter->id] = ordinaryValue(factor, random);
            }
        }
    }
    return cases;
}

std::string variantText(const EvalCase& variant) {
    std::string text;
    addChoices(text, variant.block);
    if (variant.slot.block != nullptr) {
        text +=
            (text.empty() ? "" : ", ") + variant.slot.block->kind + '=' + variant.slot.block->id;
        addChoices(text, variant.slot);
    }
    return text;
}

} // namespace patina
