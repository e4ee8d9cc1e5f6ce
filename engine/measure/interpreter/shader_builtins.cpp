// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/interpreter/shader_builtins.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace patina {
namespace {

using Form = ShaderBuiltin::Form;

double signOf(double x) {
    return x > 0.0 ? 1.0 : x < 0.0 ? -1.0 : 0.0;
}

double fractionOf(double x) {
    return x - std::floor(x);
}

double inverseRoot(double x) {
    return 1.0 / std::sqrt(x);
}

double roundedEven(double x) {
    return std::nearbyint(x);
}

double radiansOf(double x) {
    return x * std::numbers::pi / 180.0;
}

double degreesOf(double x) {
    return x * 180.0 / std::numbers::pi;
}

double smaller(double a, double b) {
    return b < a ? b : a;
}

double larger(double a, double b) {
    return a < b ? b : a;
}

double remainderOf(double x, double y) {
    return x - y * std::floor(x / y);
}

double stepAt(double edge, double x) {
    return x < edge ? 0.0 : 1.0;
}

double clamped(double x, double low, double high) {
    return smaller(larger(x, low), high);
}

double mixed(double a, double b, double t) {
    return a * (1.0 - t) + b * t;
}

double smoothed(double low, double high, double x) {
    const double t = clamped((x - low) / (high - low), 0.0, 1.0);
    return t * t * (3.0 - 2.0 * t);
}

double fused(double a, double b, double c) {
    return a * b + c;
}

constexpr ShaderBuiltin number(std::string_view name, double (*of)(double)) {
    return {name, 1, Form::Numbers, of, nullptr, nullptr};
}

constexpr ShaderBuiltin number(std::string_view name, double (*of)(double, double)) {
    return {name, 2, Form::Numbers, nullptr, of, nullptr};
}

constexpr ShaderBuiltin number(std::string_view name, double (*of)(double, double, double)) {
    return {name, 3, Form::Numbers, nullptr, nullptr, of};
}

double lessOf(double a, double b) {
    return a < b ? 1.0 : 0.0;
}

double lessEqualOf(double a, double b) {
    return a <= b ? 1.0 : 0.0;
}

double greaterOf(double a, double b) {
    return a > b ? 1.0 : 0.0;
}

double greaterEqualOf(double a, double b) {
    return a >= b ? 1.0 : 0.0;
}

constexpr ShaderBuiltin comparison(std::string_view name, double (*of)(double, double)) {
    return {name, 2, Form::Compared, nullptr, of, nullptr};
}

using Single = double (*)(double);
using Double = double (*)(double, double);

const ShaderBuiltin builtins[] = {
    number("sin", Single(std::sin)),
    number("cos", Single(std::cos)),
    number("tan", Single(std::tan)),
    number("asin", Single(std::asin)),
    number("acos", Single(std::acos)),
    number("atan", Single(std::atan)),
    number("atan", Double(std::atan2)),
    number("exp", Single(std::exp)),
    number("exp2", Single(std::exp2)),
    number("log", Single(std::log)),
    number("log2", Single(std::log2)),
    number("sqrt", Single(std::sqrt)),
    number("inversesqrt", inverseRoot),
    number("abs", Single(std::fabs)),
    number("sign", signOf),
    number("floor", Single(std::floor)),
    number("ceil", Single(std::ceil)),
    number("trunc", Single(std::trunc)),
    number("round", roundedEven),
    number("roundEven", roundedEven),
    number("fract", fractionOf),
    number("radians", radiansOf),
    number("degrees", degreesOf),
    number("sinh", Single(std::sinh)),
    number("cosh", Single(std::cosh)),
    number("tanh", Single(std::tanh)),
    number("pow", Double(std::pow)),
    number("min", smaller),
    number("max", larger),
    number("mod", remainderOf),
    number("step", stepAt),
    number("clamp", clamped),
    number("mix", mixed),
    number("smoothstep", smoothed),
    number("fma", fused),
    comparison("lessThan", lessOf),
    comparison("lessThanEqual", lessEqualOf),
    comparison("greaterThan", greaterOf),
    comparison("greaterThanEqual", greaterEqualOf),
    {"length", 1, Form::Length},
    {"dot", 2, Form::Dot},
    {"distance", 2, Form::Distance},
    {"normalize", 1, Form::Normalize},
    {"cross", 2, Form::Cross},
    {"reflect", 2, Form::Reflect},
    {"any", 1, Form::Any},
    {"all", 1, Form::All},
    {"not", 1, Form::Inverted},
    {"caseData", 1, Form::CaseData},
};

} // namespace

const ShaderBuiltin* findShaderBuiltin(std::string_view name, std::size_t arguments) {
    const auto found = std::ranges::find_if(builtins, [&](const ShaderBuiltin& builtin) {
        return builtin.name == name && builtin.arguments == arguments;
    });
    return found == std::end(builtins) ? nullptr : &*found;
}

} // namespace patina
