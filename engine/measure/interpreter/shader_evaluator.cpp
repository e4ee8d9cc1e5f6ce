// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/interpreter/shader_evaluator.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "measure/interpreter/shader_builtins.h"

namespace patina {
namespace {

using NodeKind = ShaderExpression::Kind;
using BaseType = ShaderType::Base;

/// Limits what one case may take; nothing that is drawn for each pixel comes near it.
constexpr std::size_t maxStepsOfCase = 200000;
constexpr int maxCallDepth = 64;
constexpr std::size_t stackNumbers = 1u << 16;

/// Copies the few numbers of a value.
void copied(const double* from, std::size_t count, double* to) {
    for (std::size_t i = 0; i < count; ++i) {
        to[i] = from[i];
    }
}

} // namespace

/// Is room for the value of an expression, above the numbers of the function that runs.
class ShaderEvaluator::Room {
  public:
    Room(ShaderEvaluator& evaluator, std::size_t size)
        : top_(evaluator.top_), before_(evaluator.top_) {
        if (top_ + size <= evaluator.stack_.size()) {
            numbers_ = evaluator.stack_.data() + top_;
            top_ += size;
        } else {
            many_.resize(size);
            numbers_ = many_.data();
        }
    }
    ~Room() { top_ = before_; }
    Room(const Room&) = delete;
    Room& operator=(const Room&) = delete;

    double* data() { return numbers_; }

  private:
    std::size_t& top_;
    std::size_t before_;
    double* numbers_ = nullptr;
    std::vector<double> many_;
};

double roundedToHalf(double x) {
    constexpr int digits = 11;
    constexpr int minExponent = -13; // of frexp(): below it digits are lost
    constexpr double largest = 65504.0;
    if (!std::isfinite(x) || x == 0.0) {
        return x;
    }
    int exponent = 0;
    std::frexp(x, &exponent);
    const double step = std::ldexp(1.0, std::max(exponent, minExponent) - digits);
    const double rounded = std::nearbyint(x / step) * step;
    return std::abs(rounded) > largest ? std::copysign(std::numeric_limits<double>::infinity(), x)
                                       : rounded;
}

bool ObservedValues::isConstant(std::size_t size) const {
    for (std::size_t i = 0; i < size; ++i) {
        if (!(min[i] == max[i])) {
            return false;
        }
    }
    return count > 0;
}

ShaderEvaluator::ShaderEvaluator(const ShaderSyntax& syntax, ShaderPrecision precision)
    : syntax_(syntax), precision_(precision), constants_(syntax.constantNumbers),
      stack_(stackNumbers) {
    for (const ShaderConstant& constant : syntax.constants) {
        evaluate(constant.value, constants_.data() + constant.place);
    }
}

void ShaderEvaluator::observe(std::vector<ObservedValues>* values) {
    observed_ = values;
    if (values != nullptr) {
        values->resize(syntax_.expressions.size());
    }
}

void ShaderEvaluator::call(int function, std::span<const double> arguments,
                           std::span<const double> data, std::span<double> result) {
    const ParsedFunction& called = syntax_.functions[static_cast<std::size_t>(function)];
    data_ = data;
    steps_ = 0;
    isEndless_ = false;
    depth_ = 0;
    base_ = 0;
    top_ = called.frame;
    std::ranges::copy(arguments, stack_.begin());
    std::vector<double> whole(called.resultSize);
    result_ = whole.data();
    run(called.body);
    for (std::size_t i = 0; i < result.size(); ++i) {
        result[i] =
            isEndless_ || i >= whole.size() ? std::numeric_limits<double>::quiet_NaN() : whole[i];
    }
}

ShaderEvaluator::Flow ShaderEvaluator::run(int index) {
    const ShaderStatement& statement = syntax_.statements[static_cast<std::size_t>(index)];
    switch (statement.kind) {
    case ShaderStatement::Kind::Group:
        for (const int next : statement.statements) {
            if (const Flow flow = run(next); flow != Flow::Next) {
                return flow;
            }
        }
        return Flow::Next;
    case ShaderStatement::Kind::Expression: {
        Room ignored(*this, at(statement.expression).size);
        evaluate(statement.expression, ignored.data());
        return Flow::Next;
    }
    case ShaderStatement::Kind::If:
        if (truth(statement.expression)) {
            return run(statement.statements[0]);
        }
        return statement.statements.size() > 1 ? run(statement.statements[1]) : Flow::Next;
    case ShaderStatement::Kind::Loop:
        return loop(statement);
    case ShaderStatement::Kind::Return:
        if (statement.expression >= 0) {
            evaluate(statement.expression, result_);
        }
        return Flow::Return;
    case ShaderStatement::Kind::Break:
        return Flow::Break;
    default:
        return Flow::Continue;
    }
}

ShaderEvaluator::Flow ShaderEvaluator::loop(const ShaderStatement& statement) {
    Room ignored(*this, 16);
    while (!isEndless_ && (statement.expression < 0 || truth(statement.expression))) {
        isEndless_ = ++steps_ > maxStepsOfCase;
        const Flow flow = run(statement.statements.front());
        if (flow == Flow::Break || isEndless_) {
            break;
        }
        if (flow == Flow::Return) {
            return flow;
        }
        if (statement.step >= 0) {
            evaluate(statement.step, ignored.data());
        }
    }
    return isEndless_ ? Flow::Return : Flow::Next;
}

bool ShaderEvaluator::truth(int index) {
    double value = 0.0;
    evaluate(index, &value);
    return value != 0.0;
}

void ShaderEvaluator::evaluate(int index, double* out) {
    const ShaderExpression& expression = at(index);
    compute(expression, out);
    if (isHalved(expression)) {
        std::transform(out, out + expression.size, out, roundedToHalf);
    }
    if (observed_ == nullptr || expression.size > 4) {
        return;
    }
    ObservedValues& seen = (*observed_)[static_cast<std::size_t>(index)];
    for (std::size_t i = 0; i < expression.size; ++i) {
        seen.min[i] = seen.count == 0 ? out[i] : std::min(seen.min[i], out[i]);
        seen.max[i] = seen.count == 0 ? out[i] : std::max(seen.max[i], out[i]);
    }
    ++seen.count;
}

bool ShaderEvaluator::isHalved(const ShaderExpression& expression) const {
    return halved_ != nullptr && expression.type.isFloat() &&
           (*halved_)[static_cast<std::size_t>(&expression - syntax_.expressions.data())];
}

void ShaderEvaluator::compute(const ShaderExpression& expression, double* out) {
    switch (expression.kind) {
    case NodeKind::Literal:
        *out = expression.type.base == BaseType::Float ? rounded(expression.number)
                                                       : expression.number;
        return;
    case NodeKind::Local:
        copied(frame() + expression.place, expression.size, out);
        return;
    case NodeKind::Global:
        copied(constants_.data() + expression.place, expression.size, out);
        return;
    case NodeKind::Field:
        return field(expression, out);
    case NodeKind::Swizzle:
        return swizzle(expression, out);
    case NodeKind::Index:
        return element(expression, out);
    case NodeKind::Unary:
        return unary(expression, out);
    case NodeKind::Binary:
        return binary(expression, out);
    case NodeKind::Choice:
        return evaluate(expression.operands[truth(expression.operands[0]) ? 1 : 2], out);
    case NodeKind::Call:
        return callFunction(expression, out);
    case NodeKind::Builtin:
        return builtin(expression, out);
    case NodeKind::Construct:
        return construct(expression, out);
    case NodeKind::Assign:
        return assign(expression, out);
    case NodeKind::Step: {
        double* const place = placeOf(expression.operands[0]);
        if (place == nullptr) {
            return;
        }
        const double before = *place;
        *place += expression.sign == "++" ? 1.0 : -1.0;
        *out = expression.isPrefix ? *place : before;
        return;
    }
    }
}

/// Returns where the numbers of a variable, or of a part of one, are; null where it is none.
double* ShaderEvaluator::placeOf(int index) {
    const ShaderExpression& expression = at(index);
    if (expression.kind == NodeKind::Local) {
        return frame() + expression.place;
    }
    if (expression.kind == NodeKind::Field) {
        double* const whole = placeOf(expression.operands[0]);
        return whole == nullptr ? nullptr : whole + expression.place;
    }
    if (expression.kind == NodeKind::Swizzle && expression.size == 1) {
        double* const whole = placeOf(expression.operands[0]);
        return whole == nullptr ? nullptr : whole + expression.components[0];
    }
    if (expression.kind == NodeKind::Index) {
        double* const whole = placeOf(expression.operands[0]);
        double place = 0.0;
        evaluate(expression.operands[1], &place);
        const std::size_t count = at(expression.operands[0]).size / expression.size;
        const bool isInside = place >= 0.0 && place < static_cast<double>(count);
        return whole == nullptr || !isInside
                   ? nullptr
                   : whole + static_cast<std::size_t>(place) * expression.size;
    }
    return nullptr;
}

void ShaderEvaluator::field(const ShaderExpression& expression, double* out) {
    const ShaderExpression& of = at(expression.operands[0]);
    if (of.kind == NodeKind::Local || of.kind == NodeKind::Field) {
        if (const double* whole = placeOf(expression.operands[0])) {
            copied(whole + expression.place, expression.size, out);
            return;
        }
    }
    Room whole(*this, of.size);
    evaluate(expression.operands[0], whole.data());
    copied(whole.data() + expression.place, expression.size, out);
}

void ShaderEvaluator::swizzle(const ShaderExpression& expression, double* out) {
    std::array<double, 16> whole{};
    evaluate(expression.operands[0], whole.data());
    for (std::size_t i = 0; i < expression.size; ++i) {
        out[i] = whole[static_cast<std::size_t>(expression.components[i])];
    }
}

void ShaderEvaluator::element(const ShaderExpression& expression, double* out) {
    const std::size_t all = at(expression.operands[0]).size;
    Room whole(*this, all);
    evaluate(expression.operands[0], whole.data());
    double place = 0.0;
    evaluate(expression.operands[1], &place);
    const double count = static_cast<double>(all / expression.size);
    const double inside = std::isnan(place) ? 0.0 : std::clamp(place, 0.0, count - 1.0);
    std::copy_n(whole.data() + static_cast<std::size_t>(inside) * expression.size, expression.size,
                out);
}

void ShaderEvaluator::unary(const ShaderExpression& expression, double* out) {
    evaluate(expression.operands[0], out);
    const char sign = expression.sign.front();
    for (std::size_t i = 0; i < expression.size; ++i) {
        if (sign == '-') {
            out[i] = -out[i];
        } else if (sign == '!') {
            out[i] = out[i] == 0.0 ? 1.0 : 0.0;
        }
    }
}

double ShaderEvaluator::combined(char sign, BaseType base, double a, double b) const {
    switch (sign) {
    case '+':
        return rounded(a + b);
    case '-':
        return rounded(a - b);
    case '*':
        return rounded(a * b);
    case '%':
        return b == 0.0 ? 0.0 : std::fmod(a, b);
    default:
        return base == BaseType::Int ? (b == 0.0 ? 0.0 : std::trunc(a / b)) : rounded(a / b);
    }
}

void ShaderEvaluator::product(const ShaderExpression& left, const ShaderExpression& right,
                              const double* a, const double* b, double* out) const {
    const auto rows = static_cast<std::size_t>(left.type.columns > 1 ? left.type.rows : 1);
    const auto inner =
        static_cast<std::size_t>(left.type.columns > 1 ? left.type.columns : left.type.rows);
    const auto columns = static_cast<std::size_t>(right.type.columns);
    for (std::size_t column = 0; column < columns; ++column) {
        for (std::size_t row = 0; row < rows; ++row) {
            double sum = 0.0;
            for (std::size_t k = 0; k < inner; ++k) {
                sum += a[k * rows + row] * b[column * inner + k];
            }
            out[column * rows + row] = rounded(sum);
        }
    }
}

/// Returns the value of an operand where it already stands: that of a variable or a constant, while
/// nothing watches what is evaluated. Null: it has to be computed.
const double* ShaderEvaluator::standing(const ShaderExpression& operand) {
    if (observed_ != nullptr || halved_ != nullptr) {
        return nullptr;
    }
    switch (operand.kind) {
    case NodeKind::Local:
        return frame() + operand.place;
    case NodeKind::Global:
        return constants_.data() + operand.place;
    case NodeKind::Field: {
        const double* const whole = standing(at(operand.operands.front()));
        return whole == nullptr ? nullptr : whole + operand.place;
    }
    default:
        return nullptr;
    }
}

void ShaderEvaluator::binary(const ShaderExpression& expression, double* out) {
    const char sign = expression.sign.front();
    if (sign == '&' || sign == '|') {
        const bool left = truth(expression.operands[0]);
        const bool isDecided = left == (sign == '|');
        *out = (isDecided ? left : truth(expression.operands[1])) ? 1.0 : 0.0;
        return;
    }
    const ShaderExpression& left = at(expression.operands[0]);
    const ShaderExpression& right = at(expression.operands[1]);
    Room room(*this, left.size + right.size);
    const double* b = standing(right);
    const double* a = b == nullptr ? nullptr : standing(left); // what is computed may change it
    if (a == nullptr) {
        evaluate(expression.operands[0], room.data());
        a = room.data();
    }
    if (b == nullptr) {
        evaluate(expression.operands[1], room.data() + left.size);
        b = room.data() + left.size;
    }
    const bool isEqual = expression.sign.size() > 1; // as the second of <= is
    switch (sign) {
    case '=':
    case '!': {
        const bool isSame = std::equal(a, a + left.size, b, b + right.size);
        *out = isSame == (sign == '=') ? 1.0 : 0.0;
        return;
    }
    case '<':
        *out = (isEqual ? *a <= *b : *a < *b) ? 1.0 : 0.0;
        return;
    case '>':
        *out = (isEqual ? *a >= *b : *a > *b) ? 1.0 : 0.0;
        return;
    case '^':
        *out = (*a != 0.0) != (*b != 0.0) ? 1.0 : 0.0;
        return;
    default:
        break;
    }
    if (sign == '*' && left.size > 1 && right.size > 1 &&
        (left.type.columns > 1 || right.type.columns > 1)) {
        product(left, right, a, b, out);
        return;
    }
    for (std::size_t i = 0; i < expression.size; ++i) {
        out[i] = combined(sign, expression.type.base, a[left.size == 1 ? 0 : i],
                          b[right.size == 1 ? 0 : i]);
    }
}

void ShaderEvaluator::builtin(const ShaderExpression& expression, double* out) {
    const ShaderBuiltin& builtin = *expression.builtin;
    if (builtin.form != ShaderBuiltin::Form::Numbers &&
        builtin.form != ShaderBuiltin::Form::Compared) {
        return vectorBuiltin(expression, out);
    }
    constexpr std::size_t perOperand = 4;
    Room room(*this, 3 * perOperand);
    std::array<const double*, 3> values{room.data(), room.data(), room.data()};
    std::array<std::size_t, 3> steps{}; // is 0 where one number serves all components
    for (std::size_t k = 0; k < expression.operands.size(); ++k) {
        evaluate(expression.operands[k], room.data() + perOperand * k);
        values[k] = room.data() + perOperand * k;
        steps[k] = at(expression.operands[k]).size > 1 ? 1 : 0;
    }
    for (std::size_t i = 0; i < expression.size; ++i) {
        const double a = values[0][i * steps[0]];
        const double b = values[1][i * steps[1]];
        const double c = values[2][i * steps[2]];
        out[i] = rounded(builtin.one != nullptr   ? builtin.one(a)
                         : builtin.two != nullptr ? builtin.two(a, b)
                                                  : builtin.three(a, b, c));
    }
}

void ShaderEvaluator::vectorBuiltin(const ShaderExpression& expression, double* out) {
    using Form = ShaderBuiltin::Form;
    std::array<double, 4> a{};
    std::array<double, 4> b{};
    evaluate(expression.operands[0], a.data());
    if (expression.operands.size() > 1) {
        evaluate(expression.operands[1], b.data());
    }
    const auto dot = [](const std::array<double, 4>& x, const std::array<double, 4>& y) {
        return x[0] * y[0] + x[1] * y[1] + x[2] * y[2] + x[3] * y[3];
    };
    const std::size_t size = at(expression.operands[0]).size;
    switch (expression.builtin->form) {
    case Form::Length:
        *out = rounded(std::sqrt(dot(a, a)));
        return;
    case Form::Dot:
        *out = rounded(dot(a, b));
        return;
    case Form::Distance:
        for (std::size_t i = 0; i < 4; ++i) {
            a[i] -= b[i];
        }
        *out = rounded(std::sqrt(dot(a, a)));
        return;
    case Form::Normalize:
        for (std::size_t i = 0; i < size; ++i) {
            out[i] = rounded(a[i] / std::sqrt(dot(a, a)));
        }
        return;
    case Form::Cross:
        for (std::size_t i = 0; i < 3; ++i) {
            const std::size_t j = (i + 1) % 3;
            const std::size_t k = (i + 2) % 3;
            out[i] = rounded(a[j] * b[k] - a[k] * b[j]);
        }
        return;
    case Form::Reflect:
        for (std::size_t i = 0; i < size; ++i) {
            out[i] = rounded(a[i] - 2.0 * dot(a, b) * b[i]);
        }
        return;
    case Form::Any:
        *out = std::any_of(a.begin(), a.end(), [](double x) { return x != 0.0; }) ? 1.0 : 0.0;
        return;
    case Form::All:
        *out = std::all_of(a.begin(), a.begin() + static_cast<std::ptrdiff_t>(size),
                           [](double x) { return x != 0.0; })
                   ? 1.0
                   : 0.0;
        return;
    case Form::Inverted:
        for (std::size_t i = 0; i < size; ++i) {
            out[i] = a[i] == 0.0 ? 1.0 : 0.0;
        }
        return;
    default: // the case's own data
        for (std::size_t i = 0; i < 4; ++i) {
            const std::size_t place = 4 * static_cast<std::size_t>(std::max(a[0], 0.0)) + i;
            out[i] = place < data_.size() ? data_[place] : 0.0;
        }
    }
}

void ShaderEvaluator::construct(const ShaderExpression& expression, double* out) {
    std::size_t filled = 0;
    const bool isFloat = expression.type.base == BaseType::Float;
    for (const int operand : expression.operands) {
        const std::size_t size = at(operand).size;
        Room room(*this, size);
        evaluate(operand, room.data());
        for (std::size_t i = 0; i < size && filled < expression.size; ++i) {
            const double x = room.data()[i];
            out[filled++] = expression.type.base == BaseType::Bool  ? (x != 0.0 ? 1.0 : 0.0)
                            : expression.type.base == BaseType::Int ? std::trunc(x)
                            : isFloat                               ? rounded(x)
                                                                    : x;
        }
    }
    if (filled == 1 && expression.size > 1) {
        const double only = out[0];
        const auto rows = static_cast<std::size_t>(expression.type.rows);
        for (std::size_t i = 0; i < expression.size; ++i) {
            const bool isDiagonal = i / rows == i % rows;
            out[i] = expression.type.columns > 1 && !isDiagonal ? 0.0 : only;
        }
    }
}

void ShaderEvaluator::assign(const ShaderExpression& expression, double* out) {
    const ShaderExpression& target = at(expression.operands[0]);
    const ShaderExpression& source = at(expression.operands[1]);
    Room room(*this, std::max(source.size, target.size));
    evaluate(expression.operands[1], room.data());
    if (source.size == 1) {
        std::fill_n(room.data(), target.size, room.data()[0]);
    }
    const char sign = expression.sign.front(); // of the operator before the =, where there is one
    const bool isSpread = target.kind == NodeKind::Swizzle && target.size > 1;
    double* const place = placeOf(isSpread ? target.operands[0] : expression.operands[0]);
    if (place == nullptr) {
        return;
    }
    for (std::size_t i = 0; i < target.size; ++i) {
        double& number = place[isSpread ? static_cast<std::size_t>(target.components[i]) : i];
        number =
            sign == '=' ? room.data()[i] : combined(sign, target.type.base, number, room.data()[i]);
        if (isHalved(expression)) {
            number = roundedToHalf(number);
        }
        out[i] = number;
    }
}

void ShaderEvaluator::callFunction(const ShaderExpression& expression, double* out) {
    const ParsedFunction& called = syntax_.functions[static_cast<std::size_t>(expression.function)];
    isEndless_ = isEndless_ || ++steps_ > maxStepsOfCase || depth_ >= maxCallDepth ||
                 top_ + called.frame + 64 > stack_.size();
    if (isEndless_ || called.body < 0) {
        std::fill_n(out, expression.size, 0.0);
        return;
    }
    const std::size_t callee = top_;
    const std::size_t caller = base_;
    top_ += called.frame;
    for (std::size_t i = 0; i < called.arguments.size(); ++i) {
        const ShaderVariable& argument = called.arguments[i];
        if (!argument.isOut) {
            evaluate(expression.operands[i], stack_.data() + callee + argument.place);
        }
    }
    double* const outer = result_;
    base_ = callee;
    result_ = out;
    ++depth_;
    run(called.body);
    --depth_;
    result_ = outer;
    base_ = caller;
    for (std::size_t i = 0; i < called.arguments.size(); ++i) {
        const ShaderVariable& argument = called.arguments[i];
        double* const place = argument.isOut ? placeOf(expression.operands[i]) : nullptr;
        if (place != nullptr) {
            copied(stack_.data() + callee + argument.place, argument.size, place);
        }
    }
    top_ = callee;
}

} // namespace patina
