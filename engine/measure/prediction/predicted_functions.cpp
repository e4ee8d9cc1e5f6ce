// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/prediction/predicted_functions.h"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "shading/glsl/glsl_declarations.h"

namespace patina {
namespace {

constexpr std::array<std::string_view, 4> numberTypes{"float", "vec2", "vec3", "vec4"};

/// Is where a function's braces stand in a text.
struct Body {
    std::size_t first = 0; ///< is the offset behind the opening one
    std::size_t last = 0;  ///< is that of the closing one
};

Body bodyOf(std::string_view code, std::size_t name) {
    Body body;
    int open = 0;
    for (std::size_t i = std::min(code.find('{', name), code.size()); i < code.size(); ++i) {
        open += code[i] == '{' ? 1 : code[i] == '}' ? -1 : 0;
        if (open == 1 && body.first == 0) {
            body.first = i + 1;
        }
        if (open == 0) {
            body.last = i;
            break;
        }
    }
    return body;
}

/// Returns the text with a number, which the compiler knows, in place of a function's body.
std::string textWithout(const std::string& text, const Body& body, std::string_view result) {
    return text.substr(0, body.first) + fmt::format(" return {}(0.5); ", result) +
           text.substr(body.last);
}

const StageStatistics* stageOf(const Result<FamilyStatistics>& statistics,
                               const std::string& family) {
    const bool isThere = statistics && statistics->contains(family);
    return isThere ? &statistics->at(family).fragment : nullptr;
}

} // namespace

std::optional<PredictedFunctions::Saving>
PredictedFunctions::savingOf(const PredictedFunction& function, const std::string& family) const {
    const StageStatistics* all = stageOf(whole, family);
    const StageStatistics* rest = stageOf(function.without, family);
    if (all == nullptr || rest == nullptr) {
        return std::nullopt;
    }
    return Saving{all->instructions - rest->instructions,
                  all->vectorRegisters - rest->vectorRegisters, all->cycles - rest->cycles};
}

const PredictedFunction* PredictedFunctions::widest(const std::string& family) const {
    const PredictedFunction* most = nullptr;
    int registers = 0;
    for (const PredictedFunction& function : functions) {
        const auto saving = savingOf(function, family);
        if (saving && saving->registers > registers) {
            registers = saving->registers;
            most = &function;
        }
    }
    return most;
}

Result<PredictedFunctions> predictedFunctions(const ProgramText& program,
                                              std::span<const GpuFamily* const> families,
                                              const FamilyCompilerOptions& options) {
    const std::string code = withoutComments(program.fragment);
    std::vector<ProgramText> texts{program};
    PredictedFunctions predicted;
    for (const GlslFunction& function : functionsIn(glslTokens(code))) {
        const auto name = static_cast<std::size_t>(function.name.text.data() - code.data());
        const Body body = bodyOf(code, name);
        const bool isOfNumbers =
            std::ranges::find(numberTypes, function.result) != numberTypes.end();
        if (!isOfNumbers || body.last == 0) {
            continue;
        }
        texts.push_back({program.vertex, textWithout(program.fragment, body, function.result)});
        predicted.functions.push_back(
            {std::string(function.name.text), function.name.line, FamilyStatistics()});
    }
    auto compiled = compileForFamilies(families, std::move(texts), options);
    if (!compiled) {
        return tl::unexpected(compiled.error());
    }
    predicted.driver = std::move(compiled->driver);
    predicted.whole = std::move(compiled->programs.front());
    for (std::size_t i = 0; i < predicted.functions.size(); ++i) {
        predicted.functions[i].without = std::move(compiled->programs[i + 1]);
    }
    return predicted;
}

} // namespace patina
