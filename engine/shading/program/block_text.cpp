// SPDX-License-Identifier: GPL-3.0-or-later
#include "shading/program/block_text.h"

#include <algorithm>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "catalog/suggestion.h"
#include "catalog/table_source.h"
#include "shading/program/entry_text.h"
#include "shading/glsl/glsl_declarations.h"
#include "shading/glsl/tokens.h"

namespace patina {
namespace {

Error errorAt(const Block& block, const GlslToken& place, std::string problem,
              std::string expected) {
    return {block.shaderFile.string(), place.line, place.column, std::move(problem),
            std::move(expected)};
}

bool isConditional(const GlslToken& token) {
    return directiveName(token).starts_with("if");
}

/// Reports conditionals without an end, and #else, #elif and #endif without an #if.
Errors conditionalMistakes(const Block& block, const GlslTokens& tokens) {
    Errors errors;
    std::vector<GlslToken> open;
    for (const GlslToken& token : tokens) {
        const std::string_view name = directiveName(token);
        if (isConditional(token)) {
            open.push_back(token);
        } else if (open.empty() && (name == "else" || name == "elif" || name == "endif")) {
            errors.push_back(errorAt(block, token, fmt::format("#{} without an #if", name), {}));
        } else if (name == "endif") {
            open.pop_back();
        }
    }
    for (const GlslToken& token : open) {
        errors.push_back(errorAt(block, token, fmt::format("#{} has no end", directiveName(token)),
                                 "#endif before the end of the file"));
    }
    return errors;
}

/// Reports directives that the program has once, before everything else; Patina adds the line
/// numbers.
Errors foreignDirectives(const Block& block, const GlslTokens& tokens) {
    Errors errors;
    for (const GlslToken& token : tokens) {
        const std::string_view name = directiveName(token);
        if (name == "version" || name == "extension" || name == "line") {
            errors.push_back(errorAt(block, token,
                                     fmt::format("#{} is not for the file of a block", name),
                                     "GLSL 4.10 without it"));
        }
    }
    return errors;
}

/// Reports braces without a partner; not where conditionals may choose between them.
Errors braceMistakes(const Block& block, const GlslTokens& tokens) {
    std::vector<GlslToken> open;
    if (std::any_of(tokens.begin(), tokens.end(), isConditional)) {
        return {};
    }
    for (const GlslToken& token : tokens) {
        if (token.text == "{") {
            open.push_back(token);
        } else if (token.text == "}" && open.empty()) {
            return {errorAt(block, token, "} without a {", {})};
        } else if (token.text == "}") {
            open.pop_back();
        }
    }
    return open.empty() ? Errors{}
                        : Errors{errorAt(block, open.back(), "{ has no end",
                                         "} before the end of the file")};
}

/// Reports a last declaration without an end: it would continue in the text that follows the file.
Errors endMistakes(const Block& block, const GlslTokens& tokens) {
    const auto last = std::find_if_not(tokens.rbegin(), tokens.rend(),
                                       [](const GlslToken& token) { return token.isDirective(); });
    if (last == tokens.rend() || last->text == "}" || last->text == ";") {
        return {};
    }
    return {errorAt(block, *last, "the last declaration has no end",
                    "; or } before the end of the file")};
}

/// Is a function that calls of a block need, which is searched among those its file defines.
class Wanted {
  public:
    Wanted(const Block& block, const BlockFunction& call)
        : call_(call), struct_(structName(block)),
          name_(functionName(block) + std::string(call.suffix)) {
        if (!call.argument.empty()) {
            arguments_.emplace_back(call.argument);
        }
        arguments_.push_back(struct_);
    }

    std::string signature() const {
        const std::string first =
            call_.argument.empty() ? "" : fmt::format("{} {}, ", call_.argument, call_.name);
        return fmt::format("{}({}{} p)", name_, first, struct_);
    }

    bool is(const GlslFunction& function) const {
        return function.name.text == name_ && function.result == call_.result && takes(function);
    }

    /// Returns the function that was probably meant: one with the same or a similar name, else one
    /// with the same arguments; null where there is none.
    const GlslFunction* meant(const std::vector<GlslFunction>& functions) const {
        std::vector<std::string> names;
        for (const GlslFunction& function : functions) {
            names.emplace_back(function.name.text);
        }
        const std::string near = nearest(name_, names);
        const auto found =
            std::find_if(functions.begin(), functions.end(), [&](const GlslFunction& function) {
                return near.empty() ? takes(function) : function.name.text == near;
            });
        return found == functions.end() ? nullptr : &*found;
    }

    std::string expected(const GlslFunction* instead) const {
        const std::string whole = fmt::format("{} {}", call_.result, signature());
        return instead == nullptr || instead->name.text == name_
                   ? whole
                   : fmt::format("{}, where {} stands", whole, instead->name.text);
    }

  private:
    bool takes(const GlslFunction& function) const {
        return std::ranges::equal(function.arguments, arguments_,
                                  [](const GlslVariable& given, const std::string& type) {
                                      return given.type == type && !given.isOut;
                                  });
    }

    BlockFunction call_;
    std::string struct_;
    std::string name_;
    std::vector<std::string> arguments_; ///< are the arguments' types
};

/// Returns what the names of the entry functions of tables add to the block's function name.
std::vector<std::string> entrySuffixes(const Block& block) {
    std::vector<std::string> suffixes;
    for (const BlockTable& table : block.tables) {
        suffixes.push_back(entryFunction(block, table).substr(functionName(block).size()));
    }
    return suffixes;
}

Errors functionMistakes(const Block& block, const GlslTokens& tokens) {
    std::vector<GlslFunction> others = functionsIn(tokens);
    std::vector<Wanted> missing;
    const auto find = [&](const BlockFunction& function) {
        const Wanted wanted(block, function);
        const auto isIt = [&wanted](const GlslFunction& other) { return wanted.is(other); };
        if (std::erase_if(others, isIt) == 0) {
            missing.push_back(wanted);
        }
    };
    if (const BlockKind* kind = findKind(block.kind)) {
        std::ranges::for_each(kind->functions, find);
    }
    for (const std::string& stage : block.picture.stages) {
        find({stage, "vec4", "PicturePoint", "at"});
    }
    const auto suffixes = entrySuffixes(block);
    for (const std::string& suffix : suffixes) {
        find({suffix, "vec3", "vec2", "x"});
    }
    Errors errors;
    for (const Wanted& wanted : missing) {
        const GlslFunction* meant = wanted.meant(others);
        errors.push_back(errorAt(block, meant == nullptr ? GlslToken() : meant->name,
                                 "there is no function " + wanted.signature(),
                                 wanted.expected(meant)));
    }
    return errors;
}

} // namespace

Errors blockTextMistakes(const Block& block, std::string_view glsl) {
    const GlslTokens tokens = glslTokens(glsl);
    Errors errors = foreignDirectives(block, tokens);
    for (const auto& mistakesIn : {conditionalMistakes, braceMistakes, endMistakes}) {
        const Errors more = mistakesIn(block, tokens);
        errors.insert(errors.end(), more.begin(), more.end());
    }
    if (errors.empty()) {
        errors = functionMistakes(block, tokens);
    }
    if (errors.empty()) {
        errors = entryMistakes(block, tokens);
    }
    sortByPlace(errors);
    return errors;
}

} // namespace patina
