// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <span>
#include <vector>

#include "measure/interpreter/shader_syntax.h"

namespace patina {

/// Returns the nearest number that a float of 16 bits holds (IEEE 754 binary16: 11 digits of base
/// two, from 6e-8 with fewer digits below 6.1e-5, to 65504); beyond that it is infinite.
double roundedToHalf(double x);

/// Says how numbers are rounded between two operations.
enum class ShaderPrecision { Double, Float };

/// Holds what the values of an expression were in all cases so far; of a vector each component.
struct ObservedValues {
    std::size_t count = 0;
    std::array<double, 4> min{};
    std::array<double, 4> max{};

    bool isConstant(std::size_t size) const;
};

/// Evaluates functions of a parsed shader on the CPU. What a device rounds differently, as its
/// powers and roots, is rounded to the nearest float here; one too small for a normal float is 0,
/// as on most devices.
class ShaderEvaluator {
  public:
    /// `syntax` must outlive it.
    ShaderEvaluator(const ShaderSyntax& syntax, ShaderPrecision precision);

    /// Calls a function of the syntax with the numbers of its arguments, one after the other, and
    /// returns those of its result. They are NaN where it does not end. `data` are the vec4s of the
    /// case, which caseData() reads.
    void call(int function, std::span<const double> arguments, std::span<const double> data,
              std::span<double> result);

    /// Says that the last call was given up, after so many rounds of loops and calls.
    bool gaveUp() const { return isEndless_; }

    /// Rounds the values of these expressions, in the order of ShaderSyntax::expressions, to floats
    /// of 16 bits from now on, each operation by itself; null: no longer. It must outlive the
    /// calls.
    void halve(const std::vector<bool>* expressions) { halved_ = expressions; }

    /// Keeps the values of expressions from now on, in the order of ShaderSyntax::expressions;
    /// null: no longer.
    void observe(std::vector<ObservedValues>* values);

  private:
    enum class Flow { Next, Break, Continue, Return };
    class Room;

    double rounded(double x) const {
        if (precision_ == ShaderPrecision::Double) {
            return x;
        }
        const auto single = static_cast<float>(x);
        return std::abs(single) < std::numeric_limits<float>::min() ? 0.0 : double(single);
    }
    const ShaderExpression& at(int index) const {
        return syntax_.expressions[static_cast<std::size_t>(index)];
    }
    double* frame() { return stack_.data() + base_; }
    Flow run(int statement);
    Flow loop(const ShaderStatement& statement);
    void evaluate(int index, double* out);
    void compute(const ShaderExpression& expression, double* out);
    bool isHalved(const ShaderExpression& expression) const;
    double* placeOf(int index);
    void field(const ShaderExpression& expression, double* out);
    void swizzle(const ShaderExpression& expression, double* out);
    void element(const ShaderExpression& expression, double* out);
    void unary(const ShaderExpression& expression, double* out);
    void binary(const ShaderExpression& expression, double* out);
    void product(const ShaderExpression& left, const ShaderExpression& right, const double* a,
                 const double* b, double* out) const;
    const double* standing(const ShaderExpression& operand);
    double combined(char sign, ShaderType::Base base, double a, double b) const;
    void builtin(const ShaderExpression& expression, double* out);
    void vectorBuiltin(const ShaderExpression& expression, double* out);
    void construct(const ShaderExpression& expression, double* out);
    void assign(const ShaderExpression& expression, double* out);
    void callFunction(const ShaderExpression& expression, double* out);
    bool truth(int index);

    const ShaderSyntax& syntax_;
    ShaderPrecision precision_;
    std::vector<double> constants_;
    std::vector<double> stack_;
    std::size_t base_ = 0;
    std::size_t top_ = 0;
    int depth_ = 0;
    std::size_t steps_ = 0; ///< counts rounds of loops and calls in this case
    bool isEndless_ = false;
    double* result_ = nullptr;
    std::span<const double> data_;
    std::vector<ObservedValues>* observed_ = nullptr;
    const std::vector<bool>* halved_ = nullptr;
};

} // namespace patina
