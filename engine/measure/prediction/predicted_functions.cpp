// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/prediction/predicted_functions.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <map>
#include <set>
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

/// Tells whether it is a block's own function, which takes the struct of the block's values:
/// "cookTorrance(Directions d, CookTorrance p)".
bool isBlocksOwn(const GlslFunction& function) {
    std::string type(function.name.text);
    type.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(type.front())));
    return std::ranges::find(function.arguments, type, &GlslVariable::type) !=
           function.arguments.end();
}

/// Returns the names of all functions that blocks consist of.
std::set<std::string_view> functionsOfBlocks(std::string_view code,
                                             const std::vector<GlslFunction>& functions) {
    std::multimap<std::string_view, Body> bodies; // names may be overloaded
    std::vector<std::string_view> open;
    for (const GlslFunction& function : functions) {
        const auto name = static_cast<std::size_t>(function.name.text.data() - code.data());
        bodies.emplace(function.name.text, bodyOf(code, name));
        if (isBlocksOwn(function)) {
            open.push_back(function.name.text);
        }
    }
    std::set<std::string_view> found;
    while (!open.empty()) {
        const std::string_view name = open.back();
        open.pop_back();
        if (!found.insert(name).second) {
            continue;
        }
        const auto [begin, end] = bodies.equal_range(name);
        for (auto each = begin; each != end; ++each) {
            const Body& body = each->second;
            const std::string_view text = code.substr(body.first, body.last - body.first);
            const GlslTokens tokens = glslTokens(text);
            for (std::size_t i = 0; i + 1 < tokens.size(); ++i) {
                const auto called = bodies.find(tokens[i].text);
                if (called != bodies.end() && tokens[i + 1].text == "(") {
                    open.push_back(called->first);
                }
            }
        }
    }
    return found;
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
        if (function.isOfBlock && saving && saving->registers > 0 &&
            saving->registers >= registers) {
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
    const std::vector<GlslFunction> functions = functionsIn(glslTokens(code));
    const std::set<std::string_view> ofBlocks = functionsOfBlocks(code, functions);
    for (const GlslFunction& function : functions) {
        const auto name = static_cast<std::size_t>(function.name.text.data() - code.data());
        const Body body = bodyOf(code, name);
        const bool isOfNumbers =
            std::ranges::find(numberTypes, function.result) != numberTypes.end();
        if (!isOfNumbers || body.last == 0) {
            continue;
        }
        texts.push_back({program.vertex, textWithout(program.fragment, body, function.result)});
        predicted.functions.push_back({std::string(function.name.text), function.name.line,
                                       FamilyStatistics(), ofBlocks.contains(function.name.text)});
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
