// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/approximation/half_text.h"

#include <algorithm>
#include <optional>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "measure/interpreter/shader_builtins.h"

namespace patina {
namespace {

using Kind = ShaderExpression::Kind;

constexpr std::string_view versionLine = "#version 410 core";

bool isVector(const ShaderType& type) {
    return type.isFloat() && type.columns == 1;
}

std::string halfName(const ShaderType& type) {
    return type.rows == 1 ? "float16_t" : fmt::format("f16vec{}", type.rows);
}

std::string floatName(const ShaderType& type) {
    return type.rows == 1 ? "float" : fmt::format("vec{}", type.rows);
}

/// Is a variable of a function: the function and its place there.
using VariableKey = std::pair<int, std::size_t>;

/// Is a word of a text.
struct Word {
    std::size_t first = 0;
    std::size_t last = 0;
};

/// Returns the word that ends before an offset, with spaces between.
Word wordBefore(std::string_view text, std::size_t offset) {
    const auto isOfWord = [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
               c == '_';
    };
    std::size_t last = offset;
    while (last > 0 && text[last - 1] == ' ') {
        --last;
    }
    std::size_t first = last;
    while (first > 0 && isOfWord(text[first - 1])) {
        --first;
    }
    return {first, last};
}

class HalfWriter {
  public:
    HalfWriter(const MeasuredText& text, const std::vector<bool>& halved,
               const HalfDialect& dialect)
        : text_(text), syntax_(text.syntax()), halved_(halved), dialect_(dialect) {
        findVariables();
    }

    std::vector<ShaderEdit> edits() {
        addVersion();
        std::vector<bool> isPart(syntax_.expressions.size());
        for (const ShaderExpression& each : syntax_.expressions) {
            for (const int operand : each.operands) {
                isPart[static_cast<std::size_t>(operand)] = true;
            }
        }
        for (std::size_t i = 0; i < syntax_.expressions.size(); ++i) {
            const ShaderExpression& each = syntax_.expressions[i];
            if (!isPart[i] && text_.ownFunctions().contains(each.owner)) {
                addEdits(static_cast<int>(i));
            }
        }
        std::ranges::sort(edits_, {}, &ShaderEdit::first);
        return std::move(edits_);
    }

  private:
    const ShaderExpression& at(int index) const {
        return syntax_.expressions[static_cast<std::size_t>(index)];
    }

    bool isHalved(int index) const {
        return halved_[static_cast<std::size_t>(index)] && isVector(at(index).type);
    }

    /// Tells of an assignment that gives a new variable its value.
    static bool isDeclaration(const ShaderExpression& assign) {
        return assign.kind == Kind::Assign && assign.first == assign.last;
    }

    static VariableKey keyOf(const ShaderExpression& local) { return {local.owner, local.place}; }

    bool isHalfVariable(const ShaderExpression& local) const {
        return local.kind == Kind::Local && variables_.contains(keyOf(local));
    }

    /// Finds the variables that only marked expressions give values.
    void findVariables() {
        std::set<VariableKey> others;
        for (std::size_t i = 0; i < syntax_.expressions.size(); ++i) {
            const ShaderExpression& each = syntax_.expressions[i];
            if (each.kind == Kind::Assign) {
                const ShaderExpression& target = at(each.operands[0]);
                const bool isKept = target.kind == Kind::Local && isVector(target.type) &&
                                    text_.ownFunctions().contains(each.owner) &&
                                    isHalfAssignment(static_cast<int>(i));
                if (isKept && isDeclaration(each)) {
                    variables_.insert(keyOf(target));
                } else if (!isKept) {
                    addVariablesOf(each.operands[0], others);
                }
            } else if (each.kind == Kind::Step) {
                addVariablesOf(each.operands[0], others);
            } else if (each.kind == Kind::Call) {
                addOutArguments(each, others);
            }
        }
        for (const VariableKey& other : others) {
            variables_.erase(other);
        }
    }

    bool isHalfAssignment(int index) const {
        const ShaderExpression& assign = at(index);
        if (isDeclaration(assign)) {
            const Word word = wordBefore(syntax_.text, assign.first);
            return isHalved(assign.operands[1]) &&
                   syntax_.text.substr(word.first, word.last - word.first) ==
                       floatName(at(assign.operands[0]).type);
        }
        return isHalved(assign.operands[1]) && (assign.sign == "=" || isHalved(index));
    }

    void addVariablesOf(int index, std::set<VariableKey>& keys) const {
        const ShaderExpression& each = at(index);
        if (each.kind == Kind::Local) {
            keys.insert(keyOf(each));
        } else if (!each.operands.empty()) {
            addVariablesOf(each.operands[0], keys);
        }
    }

    void addOutArguments(const ShaderExpression& call, std::set<VariableKey>& keys) const {
        const auto& arguments =
            syntax_.functions[static_cast<std::size_t>(call.function)].arguments;
        for (std::size_t i = 0; i < call.operands.size(); ++i) {
            if (arguments[i].isOut) {
                addVariablesOf(call.operands[i], keys);
            }
        }
    }

    void addVersion() {
        const std::size_t first = syntax_.text.find(versionLine);
        if (first != std::string_view::npos) {
            edits_.push_back(
                {first, first + versionLine.size(),
                 fmt::format("#version 450 core\n#extension {} : require", dialect_.extension)});
        }
    }

    void addEdit(const Word& place, std::string replacement, int function) {
        if (place.first < place.last &&
            syntax_.text.substr(place.first, place.last - place.first) != replacement) {
            edits_.push_back({place.first, place.last, std::move(replacement), {}, function});
        }
    }

    /// Adds the edits of an expression that is no part of another one.
    void addEdits(int index) {
        const ShaderExpression& each = at(index);
        if (!isDeclaration(each)) {
            addEdit({each.first, each.last}, inFloat(index), each.owner);
            return;
        }
        const ShaderExpression& target = at(each.operands[0]);
        const ShaderExpression& value = at(each.operands[1]);
        const bool isHalf = isHalfVariable(target);
        if (isHalf) {
            addEdit(wordBefore(syntax_.text, each.first), halfName(target.type), each.owner);
        }
        addEdit({value.first, value.last},
                isHalf ? inHalf(each.operands[1]) : inFloat(each.operands[1]), each.owner);
    }

    /// Returns the text of an expression whose value has its own type.
    std::string inFloat(int index) const {
        const ShaderExpression& each = at(index);
        if (isHalfVariable(each)) {
            return fmt::format("{}({})", floatName(each.type), each.sign);
        }
        if (isHalved(index)) {
            if (const auto half = computed(each)) {
                return fmt::format("{}({})", floatName(each.type), *half);
            }
        }
        return withParts(each);
    }

    /// Returns the text of an expression of 16 bits.
    std::string inHalf(int index) const {
        const ShaderExpression& each = at(index);
        if (isHalfVariable(each)) {
            return std::string(each.sign);
        }
        if (isHalved(index)) {
            if (const auto half = computed(each)) {
                return *half;
            }
        }
        const ShaderType type{ShaderType::Base::Float, each.type.rows};
        return fmt::format("{}({})", halfName(type), withParts(each));
    }

    /// Returns an operation in 16 bits; nothing where it is none that is computed so.
    std::optional<std::string> computed(const ShaderExpression& each) const {
        const bool areParts = std::ranges::all_of(
            each.operands, [this](int operand) { return at(operand).first < at(operand).last; });
        if (!areParts) {
            return std::nullopt; // a macro made it
        }
        switch (each.kind) {
        case Kind::Unary:
            return fmt::format("({}{})", each.sign, inHalf(each.operands[0]));
        case Kind::Binary:
            return isArithmetic(each)
                       ? std::optional(fmt::format("({} {} {})", inHalf(each.operands[0]),
                                                   each.sign, inHalf(each.operands[1])))
                       : std::nullopt;
        case Kind::Choice:
            return fmt::format("({} ? {} : {})", inFloat(each.operands[0]),
                               inHalf(each.operands[1]), inHalf(each.operands[2]));
        case Kind::Construct:
            return fmt::format("{}({})", halfName(each.type), arguments(each, true));
        case Kind::Builtin:
            return each.builtin->form == ShaderBuiltin::Form::CaseData
                       ? std::nullopt
                       : std::optional(fmt::format("{}({}({}))", halfName(each.type), each.sign,
                                                   arguments(each, dialect_.hasFunctions)));
        default:
            return std::nullopt;
        }
    }

    bool isArithmetic(const ShaderExpression& each) const {
        const auto isOne = [this](int operand) {
            const ShaderType& type = at(operand).type;
            return isVector(type) || (type.base == ShaderType::Base::Int && type.isScalar());
        };
        return each.sign.size() == 1 &&
               std::string_view("+-*/").find(each.sign) != std::string_view::npos &&
               std::ranges::all_of(each.operands, isOne);
    }

    std::string arguments(const ShaderExpression& each, bool areHalf) const {
        std::string text;
        for (const int operand : each.operands) {
            const bool isNumber = at(operand).type.base != ShaderType::Base::Bool;
            text += (text.empty() ? "" : ", ") +
                    (areHalf && isNumber ? inHalf(operand) : inFloat(operand));
        }
        return text;
    }

    /// Returns the text of an expression as it stands, with what its parts become.
    std::string withParts(const ShaderExpression& each) const {
        std::vector<ShaderEdit> parts;
        const bool isHalfTarget = each.kind == Kind::Assign && isHalfVariable(at(each.operands[0]));
        for (std::size_t i = 0; i < each.operands.size(); ++i) {
            const ShaderExpression& part = at(each.operands[i]);
            const bool isTarget = (each.kind == Kind::Assign || each.kind == Kind::Step) && i == 0;
            if (part.first < part.last && part.first >= each.first && part.last <= each.last &&
                !isTarget) {
                parts.push_back(
                    {part.first, part.last,
                     isHalfTarget ? inHalf(each.operands[i]) : inFloat(each.operands[i])});
            }
        }
        std::ranges::sort(parts, {}, &ShaderEdit::first);
        return editedPart(syntax_.text, each.first, each.last, parts);
    }

    const MeasuredText& text_;
    const ShaderSyntax& syntax_;
    const std::vector<bool>& halved_;
    HalfDialect dialect_;
    std::set<VariableKey> variables_;
    std::vector<ShaderEdit> edits_;
};

} // namespace

std::vector<ShaderEdit> halfEdits(const MeasuredText& text, const std::vector<bool>& halved,
                                  const HalfDialect& dialect) {
    return HalfWriter(text, halved, dialect).edits();
}

} // namespace patina
