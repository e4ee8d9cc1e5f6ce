// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/eval/eval_reference.h"

#include <fmt/format.h>

namespace patina {
namespace {

using Subject = EvalCase::Subject;

/// Returns a number of the answer. A model's value below 0 becomes 0, as lights are summed; a NaN
/// stays one.
double rightAnswerOf(const EvalCase& request, double x) {
    return request.subject == Subject::Model && x < 0.0 ? 0.0 : x;
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
    if (request.subject == Subject::Function) {
        return findEvalFunction(request).map([&](const reference::Function* function) {
            std::vector<double> results(function->results);
            function->call(request.arguments.data(), results.data());
            return results;
        });
    }
    const auto code = ReferenceCode::find(request);
    if (!code) {
        return tl::unexpected(code.error());
    }
    return evaluatedInDouble(request, *code);
}

std::vector<double> evaluatedInDouble(const EvalCase& request, const ReferenceCode& code) {
    const bool slotted = request.slot.block != nullptr;
    const ReferenceCase bound(code, request.block.packedValues(),
                              slotted ? request.slot.packedValues() : std::vector<double>());
    const ReferenceNumbers numbers = bound.evaluate(request);
    std::vector<double> answers;
    for (std::size_t i = 0; i < resultsOf(request); ++i) {
        answers.push_back(rightAnswerOf(request, numbers[i]));
    }
    return answers;
}

} // namespace patina
