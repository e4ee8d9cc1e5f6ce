// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/approximation/cheap_moves.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "measure/interpreter/shader_builtins.h"

namespace patina {
namespace {

using NodeKind = ShaderExpression::Kind;

/// Is the largest difference between two values of a term that a number may stand for.
constexpr double maxSpread = 0.8;

constexpr std::size_t maxQuoted = 100;

/// Adds an expression and its operands to those that must stay, because they are written to.
void keepWhole(const ObservedShader& shader, int index, std::set<int>& kept) {
    kept.insert(index);
    for (const int operand : shader.at(index).operands) {
        keepWhole(shader, operand, kept);
    }
}

std::set<int> writtenTo(const ObservedShader& shader) {
    std::set<int> kept;
    for (const ShaderExpression& expression : shader.syntax.expressions) {
        if (expression.kind == NodeKind::Assign || expression.kind == NodeKind::Step) {
            keepWhole(shader, expression.operands.front(), kept);
        }
        if (expression.kind != NodeKind::Call) {
            continue;
        }
        const auto called = static_cast<std::size_t>(expression.function);
        const auto& arguments = shader.syntax.functions[called].arguments;
        for (std::size_t i = 0; i < arguments.size(); ++i) {
            if (arguments[i].isOut) {
                keepWhole(shader, expression.operands[i], kept);
            }
        }
    }
    return kept;
}

/// Returns the text of an operand; empty where a macro made it.
std::string textOf(const ObservedShader& shader, int index) {
    return std::string(shader.syntax.textOf(shader.at(index)));
}

bool isCompound(const ShaderExpression& expression) {
    return expression.kind == NodeKind::Binary || expression.kind == NodeKind::Unary ||
           expression.kind == NodeKind::Choice || expression.kind == NodeKind::Assign;
}

/// Returns an operand for a replacement that keeps it; empty where a macro made it.
std::string keptOf(const ObservedShader& shader, int index) {
    const ShaderExpression& expression = shader.at(index);
    return expression.first < expression.last ? keptPart(expression.first, expression.last)
                                              : std::string();
}

/// Returns an operand for a replacement where it may stand beside any operator.
std::string grouped(const ObservedShader& shader, int index) {
    const std::string text = keptOf(shader, index);
    return isCompound(shader.at(index)) && !text.empty() ? '(' + text + ')' : text;
}

/// Collects moves that replace one expression.
class Replacements {
  public:
    explicit Replacements(const ObservedShader& shader) : shader_(shader) {}

    void add(int index, std::string replacement, std::string words, std::string helper = {}) {
        const ShaderExpression& expression = shader_.at(index);
        if (replacement.empty()) {
            return;
        }
        const bool isCall = expression.type.base == ShaderType::Base::Void;
        moves_.push_back({{{expression.first, expression.last,
                            isCall ? std::move(replacement) : '(' + replacement + ')',
                            std::move(helper), expression.owner}},
                          std::move(words)});
    }

    std::vector<CheapMove> take() { return std::move(moves_); }

  private:
    const ObservedShader& shader_;
    std::vector<CheapMove> moves_;
};

/// Replaces an expression by one of its operands.
void addOperand(Replacements& moves, const ObservedShader& shader, int index, std::size_t which,
                const std::string& words) {
    const ShaderExpression& expression = shader.at(index);
    const int operand = expression.operands[which];
    if (shader.at(operand).type == expression.type && expression.type.isFloat()) {
        moves.add(index, keptOf(shader, operand), words);
    }
}

/// Returns an operand's code as it stands in words.
std::string quoted(const ObservedShader& shader, int index) {
    return '`' + shortCode(textOf(shader, index)) + '`';
}

void addDrops(Replacements& moves, const ObservedShader& shader, int index) {
    const ShaderExpression& expression = shader.at(index);
    const auto operand = [&](std::size_t which) {
        return quoted(shader, expression.operands[which]);
    };
    const auto keep = [&](std::size_t kept, const std::string& words) {
        addOperand(moves, shader, index, kept, words);
    };
    if (expression.kind == NodeKind::Binary) {
        if (expression.sign == "+") {
            keep(0, fmt::format("{} alone, without {} added", operand(0), operand(1)));
            keep(1, fmt::format("{} alone, without {} added", operand(1), operand(0)));
        } else if (expression.sign == "-") {
            keep(0, fmt::format("{} alone, without {} taken off", operand(0), operand(1)));
        } else if (expression.sign == "*") {
            keep(0, fmt::format("{} alone, without the factor {}", operand(0), operand(1)));
            keep(1, fmt::format("{} alone, without the factor {}", operand(1), operand(0)));
        } else if (expression.sign == "/") {
            keep(0, fmt::format("{} alone, not divided by {}", operand(0), operand(1)));
        }
    } else if (expression.kind == NodeKind::Builtin) {
        const std::string_view name = expression.builtin->name;
        if (name == "max" || name == "min") {
            const char* bound = name == "max" ? "lower" : "upper";
            keep(0, fmt::format("{} without its {} bound {}", operand(0), bound, operand(1)));
            keep(1, fmt::format("{} without its {} bound {}", operand(1), bound, operand(0)));
        } else if (name == "clamp") {
            keep(0, fmt::format("{} without its bounds {} and {}", operand(0), operand(1),
                                operand(2)));
        } else if (name == "mix") {
            keep(0, fmt::format("{} alone, without a share of {}", operand(0), operand(1)));
            keep(1, fmt::format("{} alone, without a share of {}", operand(1), operand(0)));
        }
    } else if (expression.kind == NodeKind::Choice && shader.isFree(expression.operands[0])) {
        keep(1, fmt::format("{} also where {} does not hold", operand(1), operand(0)));
        keep(2, fmt::format("{} also where {} holds", operand(2), operand(0)));
    }
}

/// Says where the text of a statement's expressions begins and ends.
struct TextRange {
    std::size_t first = std::string::npos;
    std::size_t last = 0;

    bool holds(const ShaderEdit& edit) const { return first <= edit.first && edit.last <= last; }
};

void addTo(TextRange& range, const ObservedShader& shader, int statement) {
    const ShaderStatement& each = shader.syntax.statements[static_cast<std::size_t>(statement)];
    if (each.expression >= 0 &&
        shader.at(each.expression).first < shader.at(each.expression).last) {
        range.first = std::min(range.first, shader.at(each.expression).first);
        range.last = std::max(range.last, shader.at(each.expression).last);
    }
    for (const int inner : each.statements) {
        addTo(range, shader, inner);
    }
}

bool isLeft(const ObservedShader& shader, int statement) {
    const ShaderStatement& each = shader.syntax.statements[static_cast<std::size_t>(statement)];
    return each.kind == ShaderStatement::Kind::Return ||
           std::ranges::any_of(each.statements,
                               [&shader](int inner) { return isLeft(shader, inner); });
}

/// Adds a swap with another text in the place of a condition.
void addUnder(std::vector<CheapMove>& moves, const CheapMove& swap, const ObservedShader& shader,
              int condition, bool isAlways) {
    const ShaderExpression& asked = shader.at(condition);
    moves.push_back(swap);
    moves.back().edits.insert(
        moves.back().edits.begin(),
        {asked.first, asked.last, isAlways ? "(true)" : "(false)", {}, asked.owner});
    moves.back().words +=
        fmt::format(", as if {} {} held", quoted(shader, condition), isAlways ? "always" : "never");
}

/// Does not ask a condition that keeps a power or a root from what it cannot take: what is swapped
/// for it may take that. The swap stands in the branch, or behind one that leaves the function.
void addUnasked(std::vector<CheapMove>& moves, const ObservedShader& shader,
                const std::vector<int>& changeable) {
    const std::vector<CheapMove> swaps = moves;
    for (const ShaderStatement& statement : shader.syntax.statements) {
        const int condition = statement.expression;
        const bool isBranch = statement.kind == ShaderStatement::Kind::If &&
                              std::ranges::find(changeable, condition) != changeable.end() &&
                              shader.isFree(condition);
        if (!isBranch) {
            continue;
        }
        TextRange body;
        addTo(body, shader, statement.statements.front());
        const bool isLast = isLeft(shader, statement.statements.front());
        for (const CheapMove& swap : swaps) {
            const ShaderEdit& edit = swap.edits.front();
            const bool isBehind = isLast && edit.function == shader.at(condition).owner &&
                                  edit.first >= shader.at(condition).last;
            if (body.holds(edit)) {
                addUnder(moves, swap, shader, condition, true);
            } else if (isBehind) {
                addUnder(moves, swap, shader, condition, false);
            }
        }
    }
}

/// Takes a branch in every case, or in none.
void addBranches(Replacements& moves, const ObservedShader& shader,
                 const std::vector<int>& changeable) {
    for (const ShaderStatement& statement : shader.syntax.statements) {
        const int condition = statement.expression;
        if (statement.kind == ShaderStatement::Kind::If &&
            std::ranges::find(changeable, condition) != changeable.end() &&
            shader.isFree(condition)) {
            moves.add(condition, "true",
                      fmt::format("as if {} always held", quoted(shader, condition)));
            moves.add(condition, "false",
                      fmt::format("as if {} never held", quoted(shader, condition)));
        }
    }
}

void addConstant(Replacements& moves, const ObservedShader& shader, int index) {
    const ShaderExpression& expression = shader.at(index);
    const ObservedValues& seen = shader.valuesOf(index);
    const bool isTerm = expression.kind == NodeKind::Call || expression.kind == NodeKind::Builtin ||
                        expression.kind == NodeKind::Binary;
    const double spread = seen.max[0] - seen.min[0];
    if (!isTerm || !expression.type.isNumber() || !(spread > 0.0) || !(spread < maxSpread)) {
        return;
    }
    const double middle = 0.5 * (seen.min[0] + seen.max[0]);
    moves.add(index,
              fmt::format("{:.3g}", middle).find_first_of(".e") == std::string::npos
                  ? fmt::format("{:.3g}.0", middle)
                  : fmt::format("{:.3g}", middle),
              fmt::format("the number {:.3g} in place of {}", middle, quoted(shader, index)));
}

// --- known swaps

/// Puts another function in the place of a library's; both have the same arguments.
struct FunctionSwap {
    std::string_view callee;
    std::size_t arguments;
    std::string_view helper; ///< is the name of the function that takes its place
    std::string_view code;
    std::string_view words;
};

constexpr FunctionSwap functionSwaps[] = {
    {"pow1m", 3, "rationalPower1m",
     "float rationalPower1m(float d, float c, float e) {\n"
     "    return c > 0.0 ? c / (c + e * d) : 0.0;\n}\n",
     "power by Schlick's fraction"},
    {"pow1m", 3, "gaussianPower1m",
     "float gaussianPower1m(float d, float c, float e) {\n"
     "    return c > 0.0 ? exp2(-1.44269504 * e * d) : 0.0;\n}\n",
     "power by an exponential of 1 - cos"},
    {"pow1m", 3, "plainPower",
     "float plainPower(float d, float c, float e) {\n"
     "    return c > 0.0 ? pow(c, e) : 0.0;\n}\n",
     "power of the rounded cosine"},
    {"pow1m", 3, "firstPower1m",
     "float firstPower1m(float d, float c, float e) {\n"
     "    return c > 0.0 ? exp2(-2.88539008 * e * d / (1.0 + c)) : 0.0;\n}\n",
     "power by the first term of its logarithm"},
    {"powSC", 3, "rationalPowerSC",
     "float rationalPowerSC(float s2, float c2, float e) {\n"
     "    return c2 > 0.0 ? c2 / (c2 + 0.5 * e * s2) : 0.0;\n}\n",
     "power by Schlick's fraction"},
    {"powSC", 3, "gaussianPowerSC",
     "float gaussianPowerSC(float s2, float c2, float e) {\n"
     "    return c2 > 0.0 ? exp2(-0.72134752 * e * s2 / (s2 + c2)) : 0.0;\n}\n",
     "power by an exponential of the squared sine"},
    {"powSC", 3, "firstPowerSC",
     "float firstPowerSC(float s2, float c2, float e) {\n"
     "    return c2 > 0.0 ? exp2(-1.44269504 * e * s2 / (s2 + 2.0 * c2)) : 0.0;\n}\n",
     "power by the first term of its logarithm"},
    {"minusLnCosBySin2", 2, "firstLnCosBySin2",
     "float firstLnCosBySin2(float s2, float c2) {\n"
     "    return 1.0 / (s2 + 2.0 * c2);\n}\n",
     "logarithm of a cosine by its first term"},
    {"upperVersine", 1, "roundedUpperVersine",
     "float roundedUpperVersine(Directions d) {\n"
     "    return max(1.0 - d.nh, 0.0);\n}\n",
     "1 - n.h from the rounded cosine"},
    {"halfVersine", 1, "roundedHalfVersine",
     "float roundedHalfVersine(Directions d) {\n"
     "    return clamp(1.0 - d.nh, 0.0, 1.0);\n}\n",
     "1 - n.h from the rounded cosine"},
    {"ggxUnmasked", 3, "lineUnmasked",
     "float lineUnmasked(float c, float s2, float alpha) {\n"
     "    return c + 0.5 * alpha * (1.0 - c);\n}\n",
     "masking by Schlick's line"},
    {"beckmannUnmasked", 3, "lineUnmaskedSlope",
     "float lineUnmaskedSlope(float c, float s2, float alpha) {\n"
     "    return c + 0.797884561 * alpha * (1.0 - c);\n}\n",
     "masking by Schlick's line"},
    {"beckmannUnmasked", 3, "rationalUnmasked",
     "float rationalUnmasked(float c, float s2, float alpha) {\n"
     "    float width = alpha * sqrt(s2);\n"
     "    float a = c / max(width, 1e-30);\n"
     "    return a < 1.6 ? width * (1.0 + a * (2.276 + a * 2.577)) / (3.535 + 2.181 * a) : c;\n}\n",
     "masking by Walter's fraction"},
    {"dielectricReflectances", 5, "schlickReflectances",
     "void schlickReflectances(Incidence i, float etaI, float etaT, OUT(float) Rs, OUT(float) Rp) "
     "{\n"
     "    float f0 = (etaT - etaI) * (etaT - etaI) / ((etaT + etaI) * (etaT + etaI));\n"
     "    float v = i.versine;\n"
     "    if (etaT < etaI) {\n"
     "        float g2 = etaT * etaT - etaI * etaI * (1.0 - i.c * i.c);\n"
     "        v = 1.0 - min(sqrt(max(g2, 0.0)) / etaT, 1.0);\n"
     "    }\n"
     "    float v2 = v * v;\n"
     "    Rs = f0 > 0.0 ? f0 + (1.0 - f0) * v2 * v2 * v : 0.0;\n"
     "    Rp = Rs;\n}\n",
     "Fresnel's reflectance by Schlick's fifth power"},
    {"conductorReflectances", 6, "schlickMetalReflectances",
     "void schlickMetalReflectances(Incidence i, float etaI, float eta, float k, OUT(float) Rs,\n"
     "                              OUT(float) Rp) {\n"
     "    float n = eta / etaI;\n"
     "    float k2 = k * k / (etaI * etaI);\n"
     "    float v2 = i.versine * i.versine;\n"
     "    float rise = 4.0 * n * v2 * v2 * i.versine;\n"
     "    Rs = ((n - 1.0) * (n - 1.0) + k2 + rise) / ((n + 1.0) * (n + 1.0) + k2);\n"
     "    Rp = Rs;\n}\n",
     "Fresnel's reflectance by Schlick's fifth power"},
    {"blinnF0Reflectance", 2, "schlickF0Reflectance",
     "float schlickF0Reflectance(Incidence i, float f0) {\n"
     "    float v2 = i.versine * i.versine;\n"
     "    return f0 > 0.0 ? f0 + (1.0 - f0) * v2 * v2 * i.versine : 0.0;\n}\n",
     "Fresnel's reflectance by Schlick's fifth power"},
};

/// Replaces a builtin function of single numbers by one of ours.
constexpr FunctionSwap builtinSwaps[] = {
    {"pow", 2, "rationalPower",
     "float rationalPower(float x, float e) {\n"
     "    return x / max(x + e * (1.0 - x), 1e-30);\n}\n",
     "power by Schlick's fraction"},
    {"pow", 2, "sixteenthPower",
     "float sixteenthPower(float x, float e) {\n"
     "    float t = max(1.0 - 0.0625 * e * (1.0 - x), 0.0);\n"
     "    t *= t;\n    t *= t;\n    t *= t;\n    return t * t;\n}\n",
     "power by four squares"},
    {"pow", 2, "fourthPower",
     "float fourthPower(float x, float e) {\n"
     "    float t = max(1.0 - 0.25 * e * (1.0 - x), 0.0);\n"
     "    t *= t;\n    return t * t;\n}\n",
     "power by two squares"},
    {"pow", 2, "gaussianOfPower",
     "float gaussianOfPower(float x, float e) {\n"
     "    return exp2(-1.44269504 * e * (1.0 - x));\n}\n",
     "power by an exponential of 1 - x"},
    {"acos", 1, "cubicAcos",
     "float cubicAcos(float x) {\n"
     "    float a = min(abs(x), 1.0);\n"
     "    float r = sqrt(1.0 - a) * (1.5707288 + a * (-0.2121144 + a * (0.074261 - a * "
     "0.0187293)));\n"
     "    return x < 0.0 ? 3.14159265 - r : r;\n}\n",
     "arc cosine by a root and a polynomial of degree 3"},
    {"acos", 1, "linearAcos",
     "float linearAcos(float x) {\n"
     "    float a = min(abs(x), 1.0);\n"
     "    float r = sqrt(1.0 - a) * (1.5707963 - 0.156583 * a);\n"
     "    return x < 0.0 ? 3.14159265 - r : r;\n}\n",
     "arc cosine by a root and a line"},
    {"asin", 1, "cubicAsin",
     "float cubicAsin(float x) {\n"
     "    float a = min(abs(x), 1.0);\n"
     "    float r = 1.57079633 - sqrt(1.0 - a) * (1.5707288 + a * (-0.2121144 + a * (0.074261 - a "
     "* 0.0187293)));\n"
     "    return x < 0.0 ? -r : r;\n}\n",
     "arc sine by a root and a polynomial of degree 3"},
    {"exp", 1, "sixteenthExp",
     "float sixteenthExp(float x) {\n"
     "    float t = max(1.0 + 0.0625 * x, 0.0);\n"
     "    t *= t;\n    t *= t;\n    t *= t;\n    return t * t;\n}\n",
     "exponential by four squares"},
    {"sqrt", 1, "rootByInverse",
     "float rootByInverse(float x) {\n"
     "    return x * inversesqrt(max(x, 1e-30));\n}\n",
     "root by an inverse root"},
};

std::string callText(const ObservedShader& shader, const ShaderExpression& expression,
                     std::string_view name) {
    std::string text(name);
    text += '(';
    for (std::size_t i = 0; i < expression.operands.size(); ++i) {
        const std::string argument = keptOf(shader, expression.operands[i]);
        if (argument.empty()) {
            return {};
        }
        text += (i > 0 ? ", " : "") + argument;
    }
    return text + ')';
}

/// Says what is swapped, as "power by Schlick's fraction, in place of `pow(x, 5.0)`".
std::string swapWords(const ObservedShader& shader, int index, const FunctionSwap& swap) {
    return fmt::format("{}, in place of {}", swap.words, quoted(shader, index));
}

void addFunctionSwaps(Replacements& moves, const ObservedShader& shader, int index) {
    const ShaderExpression& expression = shader.at(index);
    if (expression.kind == NodeKind::Call) {
        for (const FunctionSwap& swap : functionSwaps) {
            if (expression.sign == swap.callee && expression.operands.size() == swap.arguments) {
                moves.add(index, callText(shader, expression, swap.helper),
                          swapWords(shader, index, swap), std::string(swap.code));
            }
        }
    }
    if (expression.kind == NodeKind::Builtin && expression.type.isNumber()) {
        for (const FunctionSwap& swap : builtinSwaps) {
            if (expression.sign == swap.callee && expression.operands.size() == swap.arguments) {
                moves.add(index, callText(shader, expression, swap.helper),
                          swapWords(shader, index, swap), std::string(swap.code));
            }
        }
    }
}

/// Returns the whole number next to the exponent that an expression always was; 0 where that is not
/// small.
int wholeExponent(const ObservedShader& shader, int index) {
    const ObservedValues& seen = shader.valuesOf(index);
    const double e = std::round(seen.min[0]);
    return seen.isConstant(1) && e >= 2.0 && e <= 64.0 ? static_cast<int>(e) : 0;
}

/// Returns a function that multiplies x with itself.
std::string powerFunction(const std::string& name, std::string_view type, int exponent) {
    std::string code = fmt::format("{} {}({} x) {{\n", type, name, type);
    std::string last = "x";
    std::string result = exponent % 2 == 1 ? "x" : "";
    for (int square = 2; square <= exponent; square *= 2) {
        const std::string next = fmt::format("x{}", square);
        code += fmt::format("    {} {} = {} * {};\n", type, next, last, last);
        last = next;
        if ((exponent & square) != 0) {
            result += (result.empty() ? "" : " * ") + next;
        }
    }
    return code + fmt::format("    return {};\n}}\n", result);
}

void addWholePower(Replacements& moves, const ObservedShader& shader, int index) {
    const ShaderExpression& expression = shader.at(index);
    if (expression.kind != NodeKind::Builtin || expression.sign != "pow" ||
        !expression.type.isNumber()) {
        return;
    }
    if (const int exponent = wholeExponent(shader, expression.operands[1]); exponent != 0) {
        const std::string name = fmt::format("toThe{}", exponent);
        const std::string base = keptOf(shader, expression.operands[0]);
        moves.add(
            index, base.empty() ? "" : fmt::format("{}({})", name, base),
            fmt::format("{} by products, as the power of {}", quoted(shader, index), exponent),
            powerFunction(name, "float", exponent));
    }
}

bool isDivision(const ShaderExpression& expression) {
    return expression.kind == NodeKind::Binary && expression.sign == "/" &&
           expression.type.isFloat();
}

bool isRoot(const ShaderExpression& expression) {
    return expression.kind == NodeKind::Builtin && expression.sign == "sqrt";
}

/// Makes one division of several, and products of roots one root.
void addDivisionSwaps(Replacements& moves, const ObservedShader& shader, int index) {
    const ShaderExpression& expression = shader.at(index);
    if (expression.kind != NodeKind::Binary || !expression.type.isNumber()) {
        return;
    }
    const ShaderExpression& left = shader.at(expression.operands[0]);
    const ShaderExpression& right = shader.at(expression.operands[1]);
    const auto text = [&shader](const ShaderExpression& of, std::size_t which) {
        return grouped(shader, of.operands[which]);
    };
    if (isDivision(expression) && isDivision(left) && left.type.isNumber()) {
        moves.add(index,
                  fmt::format("{} / ({} * {})", text(left, 0), text(left, 1), text(expression, 1)),
                  fmt::format("two divisions made one, in {}", quoted(shader, index)));
    }
    if (expression.sign == "*" && isDivision(left) && isDivision(right) && left.type.isNumber() &&
        right.type.isNumber()) {
        moves.add(index,
                  fmt::format("{} * {} / ({} * {})", text(left, 0), text(right, 0), text(left, 1),
                              text(right, 1)),
                  fmt::format("two divisions made one, in {}", quoted(shader, index)));
    }
    if (isDivision(expression) && isRoot(right)) {
        moves.add(
            index,
            fmt::format("{} * inversesqrt({})", text(expression, 0),
                        keptOf(shader, right.operands[0])),
            fmt::format("division by a root made an inverse root, in {}", quoted(shader, index)));
    }
    if (expression.sign == "*" && isRoot(left) && isRoot(right)) {
        moves.add(index, fmt::format("sqrt({} * {})", text(left, 0), text(right, 0)),
                  fmt::format("two roots made one, in {}", quoted(shader, index)));
    }
}

// --- folded values

bool readsVariable(const ObservedShader& shader, int index) {
    const ShaderExpression& expression = shader.at(index);
    for (const int operand : expression.operands) {
        if (readsVariable(shader, operand)) {
            return true;
        }
    }
    return expression.kind == NodeKind::Local;
}

bool isFolded(const ObservedShader& shader, int index) {
    const ShaderExpression& expression = shader.at(index);
    const bool isWriting = expression.kind == NodeKind::Assign || expression.kind == NodeKind::Step;
    const bool isFitting = expression.type.isFloat() && expression.type.columns == 1 &&
                           expression.first < expression.last && !isWriting;
    if (!isFitting || !shader.valuesOf(index).isConstant(expression.size) ||
        !readsVariable(shader, index)) {
        return false;
    }
    for (std::size_t i = 0; i < expression.size; ++i) {
        if (!std::isfinite(shader.valuesOf(index).min[i])) {
            return false;
        }
    }
    return true;
}

std::string foldedText(const ObservedShader& shader, int index) {
    const ShaderExpression& expression = shader.at(index);
    std::string text;
    for (std::size_t i = 0; i < expression.size; ++i) {
        text += (i > 0 ? ", " : "") + floatText(shader.valuesOf(index).min[i]);
    }
    return expression.size == 1 ? (text.starts_with('-') ? '(' + text + ')' : text)
                                : fmt::format("vec{}({})", expression.size, text);
}

} // namespace

std::string shortCode(std::string_view code) {
    std::string line;
    for (const char c : code) {
        const bool isSpace = c == ' ' || c == '\n' || c == '\t' || c == '\r';
        if (!isSpace || (!line.empty() && line.back() != ' ')) {
            line += isSpace ? ' ' : c;
        }
    }
    if (line.find("#line") != std::string::npos) {
        line = line.substr(0, line.find("#line"));
    }
    if (line.size() > maxQuoted) { // beginnings are often the same
        line = line.substr(0, maxQuoted / 2) + " ... " + line.substr(line.size() - maxQuoted / 2);
    }
    return line;
}

std::vector<int> changeableExpressions(const ObservedShader& shader) {
    const std::set<int> kept = writtenTo(shader);
    std::vector<int> all;
    for (std::size_t i = 0; i < shader.syntax.expressions.size(); ++i) {
        const ShaderExpression& expression = shader.syntax.expressions[i];
        const auto index = static_cast<int>(i);
        const bool isTold = expression.size > 4 || shader.valuesOf(index).count > 0;
        if (expression.first < expression.last && isTold && !kept.contains(index) &&
            shader.functions.contains(expression.owner)) {
            all.push_back(index);
        }
    }
    return all;
}

std::vector<CheapMove> droppedTerms(const ObservedShader& shader) {
    Replacements moves(shader);
    const std::vector<int> changeable = changeableExpressions(shader);
    addBranches(moves, shader, changeable);
    for (const int index : changeable) {
        addDrops(moves, shader, index);
        addConstant(moves, shader, index);
    }
    return moves.take();
}

std::vector<CheapMove> knownSwaps(const ObservedShader& shader) {
    Replacements swaps(shader);
    const std::vector<int> changeable = changeableExpressions(shader);
    for (const int index : changeable) {
        addFunctionSwaps(swaps, shader, index);
        addWholePower(swaps, shader, index);
        addDivisionSwaps(swaps, shader, index);
    }
    std::vector<CheapMove> moves = swaps.take();
    addUnasked(moves, shader, changeable);
    return moves;
}

std::vector<CheapMove> foldedValues(const ObservedShader& shader) {
    std::set<int> inside; // operands of what is folded already
    std::vector<int> folded;
    const std::vector<int> all = changeableExpressions(shader);
    for (auto it = all.rbegin(); it != all.rend(); ++it) { // operands come before what they make
        if (!inside.contains(*it) && isFolded(shader, *it)) {
            folded.push_back(*it);
        }
        if (inside.contains(*it) || isFolded(shader, *it)) { // what is in it is folded with it
            for (const int operand : shader.at(*it).operands) {
                inside.insert(operand);
            }
        }
    }
    CheapMove move{{}, "what depends on the values alone computed beforehand, as numbers", true};
    for (const int index : folded) {
        const ShaderExpression& expression = shader.at(index);
        move.edits.push_back(
            {expression.first, expression.last, foldedText(shader, index), {}, expression.owner});
    }
    return move.edits.empty() ? std::vector<CheapMove>() : std::vector<CheapMove>{move};
}

} // namespace patina
