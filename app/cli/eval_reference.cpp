// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/eval_reference.h"

#include <algorithm>

#include <fmt/format.h>

namespace patina {
namespace {

std::vector<double> numbers(const glm::dvec3& v) {
    return {v.x, v.y, v.z};
}

/// Whether the compiled code reads its values where the catalogue of today puts them.
bool matches(const reference::Block& code, const Block& block) {
    const ParameterLayout layout = layoutOf(block);
    return layout.floats == code.size &&
           std::equal(layout.fields.begin(), layout.fields.end(), code.fields.begin(),
                      code.fields.end(),
                      [](const ParameterField& field, const reference::Field& compiled) {
                          return field.name == compiled.name && field.offset == compiled.offset &&
                                 field.components == compiled.components;
                      });
}

Result<const reference::Block*> compiled(const Block& block) {
    const reference::Block* code = reference::findBlock(block.kind, block.id);
    if (code == nullptr || !matches(*code, block)) {
        return failure(fmt::format("{} was {} this program was built", block.id,
                                   code == nullptr ? "not there when" : "changed since"),
                       R"("precision": "gpu", or a new build)");
    }
    return code;
}

Result<std::vector<double>> evaluatedModel(const EvalCase& request, const reference::Block& code,
                                           reference::Parameters parameters) {
    std::vector<double> slotParameters;
    reference::FresnelFunction fresnel;
    if (request.slot.block != nullptr) {
        const auto slot = compiled(*request.slot.block);
        if (!slot) {
            return tl::unexpected(slot.error());
        }
        slotParameters = request.slot.packedValues();
        fresnel = reference::fresnelFunction(**slot, slotParameters);
    }
    const auto geometry = reference::geometry(request.n, request.t, request.l, request.v);
    return numbers(reference::shade(code, geometry, parameters, fresnel));
}

std::vector<double> evaluatedLight(const reference::Illumination& light) {
    std::vector<double> values = numbers(light.l);
    const std::vector<double> radiance = numbers(light.radiance);
    values.insert(values.end(), radiance.begin(), radiance.end());
    return values;
}

} // namespace

Result<const reference::Function*> findEvalFunction(const EvalCase& request) {
    const reference::Function* function = reference::findFunction(request.function);
    if (function == nullptr) {
        return failure(
            fmt::format("there is no function \"{}\" in the shader library", request.function));
    }
    if (function->arguments != request.arguments.size()) {
        return failure(
            fmt::format("{} arguments for {}", request.arguments.size(), function->signature),
            fmt::format("{} numbers", function->arguments));
    }
    return function;
}

Result<std::vector<double>> evaluatedInDouble(const EvalCase& request) {
    if (request.subject == EvalCase::Subject::Function) {
        return findEvalFunction(request).map([&](const reference::Function* function) {
            std::vector<double> results(function->results);
            function->call(request.arguments.data(), results.data());
            return results;
        });
    }
    const auto code = compiled(*request.block.block);
    if (!code) {
        return tl::unexpected(code.error());
    }
    const std::vector<double> parameters = request.block.packedValues();
    switch (request.subject) {
    case EvalCase::Subject::Model:
        return evaluatedModel(request, **code, parameters);
    case EvalCase::Subject::Fresnel:
        return numbers((*code)->fresnel(std::clamp(request.number, 0.0, 1.0),
                                        1.0 - std::clamp(request.number, 0.0, 1.0), parameters));
    case EvalCase::Subject::Light:
        return evaluatedLight((*code)->light(request.l, parameters));
    default:
        return std::vector{(*code)->fog(request.number, parameters)};
    }
}

} // namespace patina
