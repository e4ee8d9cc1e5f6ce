// SPDX-License-Identifier: GPL-3.0-or-later
#include "glsl_rules.h"

#include <gtest/gtest.h>

#include "source_tree.h"

namespace patina::tests::glsl_rules_test {
namespace {

std::set<std::string> libraryFunctions() {
    std::set<std::string> names;
    for (const SourceFile& file : filesUnder({"shaders/lib"}, {".glsl"})) {
        for (const std::string& name : glslFunctions(withoutComments(file.text))) {
            names.insert(name);
        }
    }
    return names;
}

TEST(GlslRules, ShippedShaders_KeepThem) {
    const auto library = libraryFunctions();
    for (const SourceFile& file : filesUnder({"shaders"}, {".glsl"})) {
        if (file.folder().find("passes") != std::string::npos) {
            continue;
        }
        for (const GlslFinding& finding : GlslRules(file.text, library).findings()) {
            ADD_FAILURE() << file.path << ':' << finding.line << ": " << finding.rule;
        }
    }
}

TEST(GlslRules, LibraryFunctions_HaveNamesOfTheirOwn) {
    std::map<std::string, std::string> places;
    for (const SourceFile& file : filesUnder({"shaders/lib"}, {".glsl"})) {
        for (const std::string& name : glslFunctions(withoutComments(file.text))) {
            const auto [place, isNew] = places.emplace(name, file.path);
            EXPECT_TRUE(isNew) << name << " is in " << place->second << " and in " << file.path;
        }
    }
}

TEST(GlslRules, LibraryFunctions_AreFound) {
    const auto library = libraryFunctions();
    EXPECT_TRUE(library.contains("directions"));
    EXPECT_TRUE(library.contains("angXY")); // has OUT parameters
}

/// A shader text in which exactly one line is wrong.
struct BadSample {
    const char* name;
    const char* rule;
    int line;
    const char* text;
};

void PrintTo(const BadSample& sample, std::ostream* out) {
    *out << sample.name;
}

class BadGlsl : public testing::TestWithParam<BadSample> {};

TEST_P(BadGlsl, ItsLine_IsFound) {
    const BadSample& sample = GetParam();
    const auto findings = GlslRules(sample.text, {"sqr", "ggxD"}).findings();
    ASSERT_EQ(findings.size(), 1u) << (findings.empty() ? "nothing" : findings.back().rule);
    EXPECT_EQ(findings.front().line, sample.line);
    EXPECT_NE(findings.front().rule.find(sample.rule), std::string::npos) << findings.front().rule;
}

const BadSample badSamples[] = {
    {"IntegerArgument", "whole number", 2, "float f(float x) {\n    return max(x, 0);\n}\n"},
    {"IntegerFactor", "whole number", 3, "\nfloat f(float x) {\n    return 2 * x;\n}\n"},
    {"IntegerInAnExpression", "whole number", 2, "float f(float x) {\n    return x - 1;\n}\n"},
    {"Swizzle", "swizzle", 2, "vec3 f(vec3 x) {\n    vec3 y = x.zyx;\n    return y;\n}\n"},
    {"ColourSwizzle", "swizzle", 2, "float f(vec3 x) {\n    return dot(x.rg, vec2(1.0));\n}\n"},
    {"ArrayConstructor", "array constructor", 2,
     "float f(int i) {\n    float a[2] = float[2](0.0, 1.0); return a[i];\n}\n"},
    {"ExclusiveOr", "^^", 2, "bool f(bool a, bool b) {\n    return a ^^ b;\n}\n"},
    {"StructConstructor", "struct constructor", 3,
     "#include \"lib/incidence.glsl\"\nIncidence f(float c) {\n    return Incidence(c, 1.0 - c);\n"
     "}\n"},
    {"OutQualifier", "out parameter", 1, "void f(out float x) {\n    x = 1.0;\n}\n"},
    {"InOutQualifier", "out parameter", 1, "void f(inout vec3 x) {\n    x = -x;\n}\n"},
    {"LocalLikeALibraryFunction", "named like the function ggxD", 2,
     "float f(float a) {\n    float ggxD = a;\n    return a;\n}\n"},
    {"LocalLikeABuiltInFunction", "named like the function distance", 1,
     "float f(float distance) {\n    return 1.0;\n}\n"},
    {"LocalLikeItsOwnFunction", "named like the function f", 2,
     "float f(float a) {\n    float f = a;\n    return a;\n}\n"},
    {"Uniform", "global of the pass", 1, "uniform float strength;\n"},
    {"Derivative", "global of the pass", 2, "float f(float x) {\n    return dFdx(x);\n}\n"},
    {"DoubleType", "read differently", 1, "float f(double x) {\n    return 1.0;\n}\n"},
    {"OtherInclude", "outside lib", 1, "#include \"models/phong.glsl\"\n"},
    {"Macro", "preprocessor", 1, "#define HALF 0.5\n"},
    {"SnakeCase", "camelCase", 2, "\nfloat ggx_d(float x) {\n    return x;\n}\n"},
    {"Overload", "two functions", 1,
     "float f(float x) {\n    return x;\n}\nfloat f(vec3 x) {\n    return x.x;\n}\n"},
};

INSTANTIATE_TEST_SUITE_P(Samples, BadGlsl, testing::ValuesIn(badSamples),
                         [](const auto& tested) { return std::string(tested.param.name); });

TEST(GlslRules, CountingAndIndexing_AreFree) {
    const char* text = "// 2 * x and x.xyz in a comment\n"
                       "float f(vec3 x, OUT(float) y) {\n"
                       "    int last = 2;\n"
                       "    float sum = 1e-30 + 1.5e+3;\n"
                       "    for (int i = 0; i < 3; ++i) {\n"
                       "        sum += x[i];\n"
                       "    }\n"
                       "    y = x[2] + x[last];\n"
                       "    return sum;\n"
                       "}\n";
    const auto findings = GlslRules(text, {}).findings();
    EXPECT_TRUE(findings.empty()) << findings.front().line << ": " << findings.front().rule;
}

} // namespace
} // namespace patina::tests::glsl_rules_test
