// SPDX-License-Identifier: GPL-3.0-or-later
// Texts of shaders that are evaluated on the CPU.
#include <cmath>
#include <string>

#include <gtest/gtest.h>

#include "measure/interpreter/shader_evaluator.h"
#include "measure/interpreter/shader_parser.h"

namespace patina::tests::shader_evaluator_test {
namespace {

double valueOf(const std::string& text, double x) {
    const ShaderSource source{text, {"generated"}, {}};
    const auto syntax = parsedShader(source, "f");
    EXPECT_TRUE(syntax) << syntax.error().text();
    double y = NAN;
    if (syntax) {
        ShaderEvaluator(*syntax, ShaderPrecision::Double)
            .call(syntax->functionNamed("f"), {&x, 1}, {}, {&y, 1});
    }
    return y;
}

TEST(ShaderArrays, ConstantArrays_AreReadByIndex) {
    EXPECT_EQ(valueOf("const float weights[3] = float[3](1.0, 2.0, 4.0);\n"
                      "const vec2[2] places = vec2[](vec2(1.0, 10.0), vec2(100.0));\n"
                      "float f(float x) {\n    return weights[int(x)] + places[1].y"
                      " + places[0].y;\n}\n",
                      2.0),
              114.0);
}

TEST(ShaderArrays, LocalArrays_AreFilledAndSummed) {
    EXPECT_EQ(valueOf("float f(float x) {\n    float[2] a = float[](x, 2.0 * x);\n"
                      "    float sum = 0.0;\n    for (int i = 0; i < 2; ++i) {\n"
                      "        sum += a[i];\n    }\n    a[0] = 1.0;\n    return sum + a[0];\n}\n",
                      3.0),
              10.0);
}

} // namespace
} // namespace patina::tests::shader_evaluator_test
