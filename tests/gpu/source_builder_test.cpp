// SPDX-License-Identifier: GPL-3.0-or-later
#include "shading/program/source_builder.h"

#include <gtest/gtest.h>

#include "shading/glsl/compile_log.h"
#include "shading/glsl/tokens.h"
#include "support/program.h"

namespace patina::source_builder_test {
namespace {

using tests::TemporaryFolder;
using tests::writeFile;

TEST(SourceBuilder, IncludedTwice_IsInOnce) {
    const TemporaryFolder folder;
    writeFile(folder / "lib.glsl", "float one() { return 1.0; }\n");
    writeFile(folder / "a.glsl", "#include \"lib.glsl\"\nfloat a;\n");
    writeFile(folder / "b.glsl", "#include \"lib.glsl\"\nfloat b;\n");
    SourceBuilder builder(folder.path());
    builder.addFile("a.glsl");
    builder.addFile("b.glsl");
    const std::string text = builder.finish()->text;
    EXPECT_EQ(text.find("one"), text.rfind("one"));
}

TEST(SourceBuilder, LineDirective_NamesTheFilesOwnLine) {
    const TemporaryFolder folder;
    writeFile(folder / "a.glsl", "// a comment\n\nfloat a;\n");
    SourceBuilder builder(folder.path());
    builder.addFile("a.glsl");
    EXPECT_NE(builder.finish()->text.find("#line 100003 1\nfloat a;"), std::string::npos);
}

TEST(SourceBuilder, IncludeOutsideTheFolder_IsAnErrorAtItsLine) {
    const TemporaryFolder folder;
    writeFile(folder / "a.glsl", "float a;\n#include \"../secret.glsl\"\n");
    SourceBuilder builder(folder.path());
    builder.addFile("a.glsl");
    const auto source = builder.finish();
    ASSERT_FALSE(source);
    EXPECT_EQ(source.error().front().line, 2);
}

TEST(SourceBuilder, MissingInclude_IsAnErrorAtItsLine) {
    const TemporaryFolder folder;
    writeFile(folder / "a.glsl", "\n#include \"lib/none.glsl\"\n");
    SourceBuilder builder(folder.path());
    builder.addFile("a.glsl");
    const auto source = builder.finish();
    ASSERT_FALSE(source);
    EXPECT_EQ(source.error().front().line, 2);
}

TEST(WithoutComments, Lines_StayWhereTheyWere) {
    EXPECT_EQ(withoutComments("a /* b\nc */ d // e\nf"), "a     \n     d     \nf");
}

ShaderSource twoFiles() {
    ShaderSource source;
    source.files = {"generated", "lib/a.glsl", "models/b.glsl"};
    return source;
}

/// The first error of a log, as a person reads it.
std::string firstOf(const std::string& log) {
    return compileErrors(log, twoFiles()).front().text();
}

TEST(CompileErrors, MesaLog_NamesFileLineAndColumn) {
    EXPECT_EQ(firstOf("2:7(12): error: `x' undeclared\n"), "models/b.glsl:7:12: `x' undeclared");
}

TEST(CompileErrors, OverloadsThatMesaLists_AreLeftOut) {
    const Errors errors = compileErrors("2:7(12): error: no matching function for call to `max()'\n"
                                        "2:7(12): error:    float max(float, float)\n"
                                        "2:7(12): error:    vec2 max(vec2, vec2)\n",
                                        twoFiles());
    EXPECT_EQ(errors.size(), 1U);
}

/// Mesa gives 0 instead of the file's number for errors inside expressions.
TEST(CompileErrors, LostFileNumber_IsFoundInTheLine) {
    EXPECT_EQ(firstOf("0:200007(12): error: `x' undeclared\n"),
              "models/b.glsl:7:12: `x' undeclared");
}

TEST(CompileErrors, NvidiaLog_NamesFileAndLine) {
    EXPECT_EQ(firstOf("1(9) : error C1503: undefined variable \"x\"\n"),
              "lib/a.glsl:9: undefined variable \"x\"");
}

TEST(CompileErrors, AppleLog_NamesFileAndLine) {
    EXPECT_EQ(firstOf("ERROR: 2:4: Use of undeclared identifier 'x'"),
              "models/b.glsl:4: Use of undeclared identifier 'x'");
}

TEST(CompileErrors, Warnings_AreLeftOut) {
    EXPECT_EQ(compileErrors("1:1(1): warning: w\n1:2(1): error: e\n", twoFiles()).size(), 1u);
}

TEST(CompileErrors, UnknownForm_IsKeptWhole) {
    EXPECT_EQ(firstOf("  the link went wrong \n"), "the link went wrong");
}

} // namespace
} // namespace patina::source_builder_test
