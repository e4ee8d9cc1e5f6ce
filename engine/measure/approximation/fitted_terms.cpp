// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/approximation/fitted_terms.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <map>
#include <memory>
#include <numbers>
#include <optional>
#include <tuple>
#include <utility>

#include <fmt/format.h>

#include "measure/interpreter/shader_parser.h"

namespace patina {
namespace {

using NodeKind = ShaderExpression::Kind;

/// Is the degree of the polynomial that stands for a term while Sollya works.
constexpr int interpolationDegree = 20;
/// Is how far that may be off, as a share of the term's range. What bends, as a root at 0, is
/// followed less well than its polynomials are off; what jumps is not followed.
constexpr double maxResidual = 0.03;
constexpr std::size_t maxTerms = 20;
constexpr int minDegree = 0;
constexpr int maxDegree = 6;

/// Holds the leaves of an expression that vary, and what it is made of besides.
struct Leaves {
    std::map<std::string, int> varying; ///< maps a text to one expression that has it
    bool isPure = true;
    bool isCostly = false; ///< has a call or a division
};

bool isLeaf(const ShaderExpression& expression) {
    return expression.kind == NodeKind::Local || expression.kind == NodeKind::Field ||
           expression.kind == NodeKind::Swizzle || expression.kind == NodeKind::Index;
}

void collect(const ObservedShader& shader, int index, Leaves& leaves) {
    const ShaderExpression& expression = shader.at(index);
    if (isLeaf(expression)) {
        const bool isConstant = expression.size <= 4 && expression.type.isNumber() &&
                                shader.valuesOf(index).isConstant(1);
        const std::string text(shader.syntax.textOf(expression));
        leaves.isPure = leaves.isPure && !text.empty();
        if (!isConstant) {
            leaves.varying.emplace(text, index);
        }
        return;
    }
    leaves.isPure = leaves.isPure && expression.kind != NodeKind::Assign &&
                    expression.kind != NodeKind::Step && expression.first < expression.last;
    leaves.isCostly = leaves.isCostly || expression.kind == NodeKind::Call ||
                      expression.kind == NodeKind::Builtin || expression.sign == "/";
    for (const int operand : expression.operands) {
        collect(shader, operand, leaves);
    }
}

/// Replaces each of the constant leaves of an expression, and the variable, in its text.
class TermText {
  public:
    TermText(const ObservedShader& shader, int variable) : shader_(shader), variable_(variable) {
        if (variable >= 0) {
            variableText_ = shader.syntax.textOf(shader.at(variable));
        }
    }

    std::string of(int index) {
        edits_.clear();
        gather(index);
        std::ranges::sort(edits_, {}, &ShaderEdit::first);
        const ShaderExpression& whole = shader_.at(index);
        return editedPart(shader_.syntax.text, whole.first, whole.last, edits_);
    }

  private:
    void gather(int index) {
        const ShaderExpression& expression = shader_.at(index);
        const bool isIt =
            index == variable_ ||
            (isLeaf(expression) && shader_.syntax.textOf(expression) == variableText_);
        if (isIt) {
            edits_.push_back({expression.first, expression.last, "fittedAt", {}, -1});
        } else if (isLeaf(expression)) {
            edits_.push_back({expression.first,
                              expression.last,
                              '(' + floatText(shader_.valuesOf(index).min[0]) + ')',
                              {},
                              -1});
        } else {
            for (const int operand : expression.operands) {
                gather(operand);
            }
        }
    }

    const ObservedShader& shader_;
    int variable_;
    std::string_view variableText_;
    std::vector<ShaderEdit> edits_;
};

/// Evaluates a term in double precision, by the shader's own text.
class TermFunction {
  public:
    static std::optional<TermFunction> of(const ShaderSource& source, const std::string& text) {
        TermFunction made;
        made.source_ = std::make_unique<ShaderSource>(source);
        made.source_->text +=
            fmt::format("\nfloat fittedTerm(float fittedAt) {{\n    return {};\n}}\n", text);
        auto syntax = parsedShader(*made.source_, "fittedTerm");
        if (!syntax) {
            return std::nullopt;
        }
        made.syntax_ = std::make_unique<ShaderSyntax>(std::move(*syntax));
        made.function_ = made.syntax_->functionNamed("fittedTerm");
        made.evaluator_ = std::make_unique<ShaderEvaluator>(*made.syntax_, ShaderPrecision::Double);
        return made;
    }

    double at(double x) {
        double y = 0.0;
        evaluator_->call(function_, {&x, 1}, {}, {&y, 1});
        return y;
    }

  private:
    std::unique_ptr<ShaderSource> source_;
    std::unique_ptr<ShaderSyntax> syntax_;
    std::unique_ptr<ShaderEvaluator> evaluator_;
    int function_ = -1;
};

/// Is the polynomial through a function's values at Chebyshev's nodes, in powers of t = -1 .. 1.
class Interpolant {
  public:
    Interpolant(const std::function<double(double)>& f, double low, double high)
        : middle_(0.5 * (low + high)), half_(0.5 * (high - low)) {
        constexpr int n = interpolationDegree + 1;
        std::vector<double> values;
        for (int k = 0; k < n; ++k) {
            values.push_back(f(middle_ + half_ * std::cos(std::numbers::pi * (k + 0.5) / n)));
        }
        std::vector<double> before{1.0};       // T0 in powers of t
        std::vector<double> current{0.0, 1.0}; // T1
        powers_.assign(n, 0.0);
        for (int j = 0; j < n; ++j) {
            double c = 0.0;
            for (int k = 0; k < n; ++k) {
                c += values[static_cast<std::size_t>(k)] *
                     std::cos(std::numbers::pi * j * (k + 0.5) / n) * (j == 0 ? 1.0 : 2.0) / n;
            }
            const std::vector<double>& T = j == 0 ? before : current;
            for (std::size_t i = 0; i < T.size(); ++i) {
                powers_[i] += c * T[i];
            }
            if (j > 0) {
                std::vector<double> next(current.size() + 1, 0.0);
                for (std::size_t i = 0; i < current.size(); ++i) {
                    next[i + 1] += 2.0 * current[i];
                }
                for (std::size_t i = 0; i < before.size(); ++i) {
                    next[i] -= before[i];
                }
                before = std::move(current);
                current = std::move(next);
            }
        }
    }

    double at(double x) const {
        const double t = (x - middle_) / half_;
        double y = 0.0;
        for (auto it = powers_.rbegin(); it != powers_.rend(); ++it) {
            y = y * t + *it;
        }
        return y;
    }

    /// Returns the expression of Sollya in x = 0 .. 1.
    std::string text() const {
        std::string y;
        for (auto it = powers_.rbegin(); it != powers_.rend(); ++it) {
            y = y.empty() ? fmt::format("({:.17g})", *it)
                          : fmt::format("(({:.17g}) + (2 * x - 1) * {})", *it, y);
        }
        return y;
    }

  private:
    double middle_;
    double half_;
    std::vector<double> powers_;
};

/// Returns 0 .. 1 for a range that is nearly that, whose polynomials need not be moved to it.
std::pair<double, double> roundedRange(double low, double high) {
    const bool isNearly = low >= 0.0 && low < 0.06 && high > 0.94 && high < 1.0 + 1e-6;
    return isNearly ? std::pair(0.0, 1.0) : std::pair(low, high);
}

/// Follows a term by a polynomial; nothing where none does.
std::optional<OneVariableTerm> followed(const ShaderSource& source, const ObservedShader& shader,
                                        int index, int variable) {
    const ObservedValues& range = shader.valuesOf(variable);
    const ShaderExpression& number = shader.at(variable);
    OneVariableTerm term;
    term.expression = index;
    term.variable = keptPart(number.first, number.last);
    std::tie(term.low, term.high) = roundedRange(range.min[0], range.max[0]);
    const bool hasRange = std::isfinite(term.low) && std::isfinite(term.high) &&
                          term.high - term.low > 1e-6 && term.high - term.low < 1e4;
    auto function =
        hasRange ? TermFunction::of(source, TermText(shader, variable).of(index)) : std::nullopt;
    if (!function) {
        return std::nullopt;
    }
    term.isProportional = term.low == 0.0 && std::abs(function->at(0.0)) < 1e-12;
    const auto factor = [&term, &function](double x) {
        return term.isProportional ? function->at(x) / x : function->at(x);
    };
    const Interpolant near(factor, term.low, term.high);
    term.min = std::numeric_limits<double>::infinity();
    double max = -term.min;
    constexpr int samples = 401;
    for (int i = 0; i < samples; ++i) {
        const double x = term.low + (term.high - term.low) * i / (samples - 1);
        const double y = function->at(x);
        if (!std::isfinite(y)) {
            return std::nullopt;
        }
        term.min = std::min(term.min, y);
        max = std::max(max, y);
        const double got = term.isProportional ? x * near.at(x) : near.at(x);
        term.residual = std::max(term.residual, std::abs(y - got));
    }
    if (!(term.residual <= maxResidual * std::max(max - term.min, 1e-9))) {
        return std::nullopt;
    }
    term.function = near.text();
    return term;
}

/// Returns the argument of a call that alone varies; -1 where there is none.
int varyingArgument(const ObservedShader& shader, const ShaderExpression& call) {
    int found = -1;
    for (const int operand : call.operands) {
        const ShaderExpression& argument = shader.at(operand);
        if (!argument.type.isNumber()) {
            return -1;
        }
        if (argument.kind == NodeKind::Literal || shader.valuesOf(operand).isConstant(1)) {
            continue;
        }
        if (found >= 0) {
            return -1;
        }
        found = operand;
    }
    return found;
}

/// Returns how far a polynomial is from the term at most.
double farthestOf(const OneVariableTerm& term, const FittedPolynomial& polynomial) {
    return (term.isProportional ? term.high : 1.0) * polynomial.bound + term.residual;
}

/// Returns the function. GPUs cut to 0 .. 1 for nothing as they compute.
std::string polynomialCode(const std::string& name, const OneVariableTerm& term,
                           const FittedPolynomial& polynomial) {
    std::string y;
    const std::vector<double>& coefficients = polynomial.coefficients;
    for (auto it = coefficients.rbegin(); it != coefficients.rend(); ++it) {
        y = y.empty() ? floatText(*it) : fmt::format("{} + t * ({})", floatText(*it), y);
    }
    if (term.isProportional) {
        y = coefficients.size() == 1 ? fmt::format("{} * x", y) : fmt::format("x * ({})", y);
    }
    if (term.min >= 0.0 && term.min <= farthestOf(term, polynomial)) {
        y = fmt::format("max({}, 0.0)", y);
    }
    if (coefficients.size() == 1) {
        return fmt::format("float {}(float x) {{\n    return {};\n}}\n", name, y);
    }
    const double scale = 1.0 / (term.high - term.low);
    const std::string place =
        scale == 1.0 && term.low == 0.0
            ? "x"
            : fmt::format("{} * x + {}", floatText(scale), floatText(-term.low * scale));
    return fmt::format("float {}(float x) {{\n    float t = clamp({}, 0.0, 1.0);\n"
                       "    return {};\n}}\n",
                       name, place, y);
}

/// Says what a polynomial does, with its proved bound: of the term, or of the term over its number.
std::string polynomialWords(const ObservedShader& shader, const OneVariableTerm& term,
                            const FittedPolynomial& polynomial, int degree) {
    return fmt::format("`{}` by a polynomial of degree {}, at most {:.2g} off",
                       shortCode(shader.syntax.textOf(shader.at(term.expression))),
                       degree + (term.isProportional ? 1 : 0), farthestOf(term, polynomial));
}

} // namespace

std::vector<OneVariableTerm> oneVariableTerms(const ShaderSource& source,
                                              const ObservedShader& shader) {
    std::vector<OneVariableTerm> terms;
    for (const int index : changeableExpressions(shader)) {
        const ShaderExpression& expression = shader.at(index);
        const bool isTerm = expression.type.isNumber() && !isLeaf(expression) &&
                            expression.kind != NodeKind::Literal &&
                            expression.kind != NodeKind::Assign &&
                            !shader.valuesOf(index).isConstant(1);
        if (!isTerm || terms.size() >= maxTerms) {
            continue;
        }
        Leaves leaves;
        collect(shader, index, leaves);
        int variable = -1;
        if (leaves.isPure && leaves.isCostly && leaves.varying.size() == 1) {
            variable = leaves.varying.begin()->second;
        } else if (expression.kind == NodeKind::Call || expression.kind == NodeKind::Builtin) {
            variable = varyingArgument(shader, expression);
        }
        if (variable >= 0 && shader.at(variable).type.isNumber()) {
            if (auto term = followed(source, shader, index, variable)) {
                terms.push_back(std::move(*term));
            }
        }
    }
    return terms;
}

Result<std::vector<CheapMove>> polynomialMoves(const ObservedShader& shader,
                                               std::span<const OneVariableTerm> terms,
                                               double seconds,
                                               const std::function<bool()>& isStopped) {
    std::vector<PolynomialWish> wishes;
    for (const OneVariableTerm& term : terms) {
        for (int degree = minDegree; degree <= maxDegree; ++degree) {
            wishes.push_back({term.function, 0.0, 1.0, degree});
        }
    }
    const auto fitted = fittedPolynomials(wishes, seconds, isStopped);
    if (!fitted) {
        return tl::unexpected(fitted.error());
    }
    constexpr auto degrees = static_cast<std::size_t>(maxDegree - minDegree + 1);
    std::vector<CheapMove> moves;
    for (std::size_t i = 0; i < fitted->size(); ++i) {
        if (!(*fitted)[i]) {
            continue;
        }
        const OneVariableTerm& term = terms[i / degrees];
        const ShaderExpression& expression = shader.at(term.expression);
        const FittedPolynomial& polynomial = *(*fitted)[i];
        const std::string name = fmt::format("polynomial{}", i + 1);
        moves.push_back(
            {{{expression.first, expression.last, fmt::format("{}({})", name, term.variable),
               polynomialCode(name, term, polynomial), expression.owner}},
             polynomialWords(shader, term, polynomial, wishes[i].degree)});
    }
    return moves;
}

} // namespace patina
