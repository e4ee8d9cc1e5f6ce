// SPDX-License-Identifier: GPL-3.0-or-later
// What is wrong with a block's shader is told at its own file and line, not at Patina's.
#include "shading/program/block_text.h"

#include <array>

#include <gtest/gtest.h>

#include "catalog/catalog.h"
#include "shading/glsl/compile_log.h"
#include "shading/glsl/shader_file.h"
#include "shading/program/source_builder.h"
#include "shading/glsl/tokens.h"
#include "support/program.h"

namespace patina::block_text_test {
namespace {

using tests::TemporaryFolder;
using tests::writeFile;

Block blockOf(const std::string& kind) {
    Block block;
    block.kind = kind;
    block.id = "wrap-test";
    block.shaderFile = "wrap-test.glsl";
    return block;
}

/// The mistakes in a model's shader, as a person reads them.
std::string complaints(const std::string& glsl) {
    return text(blockTextMistakes(blockOf("models"), withoutComments(glsl)));
}

const std::string good = "#include \"lib/directions.glsl\"\n"
                         "vec3 wrapTest(const in Directions d, WrapTest p) {\n"
                         "    return vec3(d.nl);\n}\n";

TEST(BlockText, WholeModel_HasNoMistake) {
    EXPECT_EQ(complaints(good), "");
}

TEST(BlockText, SlipInTheName_IsToldAtItsPlace) {
    EXPECT_EQ(complaints("\nfloat half(float x) {\n    return 0.5 * x;\n}\n"
                         "vec3 wrapTset(Directions d, WrapTest p) {\n    return vec3(d.nl);\n}\n"),
              "wrap-test.glsl:5:6: there is no function wrapTest(Directions d, WrapTest p); "
              "expected vec3 wrapTest(Directions d, WrapTest p), where wrapTset stands\n");
}

TEST(BlockText, NameOfTheBlockItWasCopiedFrom_IsToldAtItsPlace) {
    EXPECT_NE(complaints("vec3 lambert(Directions d, WrapTest p) {\n    return vec3(d.nl);\n}\n")
                  .find("where lambert stands"),
              std::string::npos);
}

TEST(BlockText, OtherArguments_AreToldAtTheFunction) {
    EXPECT_EQ(complaints("\nvec3 wrapTest(WrapTest p) {\n    return vec3(1.0);\n}\n"),
              "wrap-test.glsl:2:6: there is no function wrapTest(Directions d, WrapTest p); "
              "expected vec3 wrapTest(Directions d, WrapTest p)\n");
}

TEST(BlockText, EmptyFile_LacksTheFunction) {
    EXPECT_EQ(complaints(""),
              "wrap-test.glsl:1:1: there is no function wrapTest(Directions d, WrapTest p); "
              "expected vec3 wrapTest(Directions d, WrapTest p)\n");
}

TEST(BlockText, FunctionInARemark_DoesNotCount) {
    EXPECT_NE(complaints("// vec3 wrapTest(Directions d, WrapTest p) { return vec3(1.0); }\n"), "");
}

TEST(BlockText, PrototypeAlone_DoesNotCount) {
    EXPECT_NE(complaints("vec3 wrapTest(Directions d, WrapTest p);\n"), "");
}

TEST(BlockText, SecondFunctionOfAKind_IsMissed) {
    const std::string said =
        text(blockTextMistakes(blockOf("fog"), "float wrapTestFog(FogRay ray, WrapTestFog p) {\n"
                                               "    return 1.0;\n}\n"));
    EXPECT_EQ(said, "wrap-test.glsl:1:1: there is no function wrapTestFogColor(WrapTestFog p); "
                    "expected vec3 wrapTestFogColor(WrapTestFog p)\n");
}

TEST(BlockText, ConditionalWithoutAnEnd_IsToldWhereItBegins) {
    EXPECT_NE(complaints("\n#ifdef FINE\n" + good).find("wrap-test.glsl:2:1: #ifdef has no end"),
              std::string::npos);
}

TEST(BlockText, EndWithoutAConditional_IsTold) {
    EXPECT_NE(complaints(good + "#endif\n").find("wrap-test.glsl:5:1: #endif without an #if"),
              std::string::npos);
}

TEST(BlockText, WholeConditional_IsFine) {
    EXPECT_EQ(complaints("#ifdef A\nconst float a = 1.0;\n#else\nconst float a = 2.0;\n#endif\n" +
                         good),
              "");
}

TEST(BlockText, BracesThatAConditionalChooses_AreFine) {
    EXPECT_EQ(complaints(good + "#ifdef A\nfloat a() {\n#else\nfloat b() {\n#endif\n"
                                "    return 1.0;\n}\n"),
              "");
}

TEST(BlockText, DirectivesOfTheWholeProgram_AreRefused) {
    for (const char* directive : {"#version 330", "#  extension all : enable", "#line 7"}) {
        EXPECT_NE(complaints(std::string(directive) + "\n" + good).find("wrap-test.glsl:1:1: #"),
                  std::string::npos)
            << directive;
    }
}

TEST(BlockText, BraceWithoutAnEnd_IsToldWhereItOpens) {
    EXPECT_NE(complaints(good.substr(0, good.size() - 2)).find("wrap-test.glsl:2:50: { has no end"),
              std::string::npos);
}

TEST(BlockText, BraceThatNothingOpened_IsTold) {
    EXPECT_NE(complaints(good + "}\n").find("wrap-test.glsl:5:1: } without a {"),
              std::string::npos);
}

TEST(BlockText, DeclarationThatDoesNotEnd_IsTold) {
    EXPECT_EQ(complaints(good + "const float a = 1.0\n"),
              "wrap-test.glsl:5:19: the last declaration has no end; expected ; or } before the "
              "end of the file\n");
}

TEST(BlockText, DirectiveOverSeveralLines_IsNoCode) {
    EXPECT_EQ(complaints("#define HALF(x) \\\n    {\n" + good), "");
}

TEST(BlockText, ShippedBlocks_HaveNoMistake) {
    const std::array roots{BlockRoot{PATINA_SOURCE_DIR "/shaders", true}};
    for (const Block& block : loadCatalog(roots).blocks) {
        const std::string glsl = withoutComments(*readShaderFile(block.shaderFile));
        EXPECT_EQ(text(blockTextMistakes(block, glsl)), "");
    }
}

/// Why a file with this content is not read.
std::string refusal(const std::string& content) {
    const TemporaryFolder folder;
    writeFile(folder / "a.glsl", content);
    const Result<std::string> read = readShaderFile(folder / "a.glsl");
    return read ? "it was read" : read.error().text().substr(folder.path().string().size() + 1);
}

TEST(ShaderFile, NulByte_IsRefusedWithItsLine) {
    EXPECT_EQ(refusal(std::string("float a;\n\0float b;\n", 19)),
              "a.glsl:2:1: the shader has a NUL byte in it; expected a text in GLSL");
}

TEST(ShaderFile, LargerThanAnyShader_IsRefused) {
    EXPECT_EQ(refusal(std::string(maxShaderBytes + 1, ' ')),
              "a.glsl: the shader is larger than 1 MiB; expected a text in GLSL");
}

TEST(ShaderFile, ByteOrderMark_IsLeftOut) {
    const TemporaryFolder folder;
    writeFile(folder / "a.glsl", "\xef\xbb\xbf#define A\n");
    EXPECT_EQ(readShaderFile(folder / "a.glsl").value_or("it was refused"), "#define A\n");
}

TEST(ShaderFile, Folder_IsRefused) {
    EXPECT_FALSE(readShaderFile(PATINA_SOURCE_DIR));
}

TEST(SourceBuilder, BlockWithAMistake_IsAnErrorOfItsFile) {
    const TemporaryFolder folder;
    Block block = blockOf("models");
    block.shaderFile = folder / "wrap-test.glsl";
    writeFile(block.shaderFile, "\n");
    SourceBuilder builder(folder.path());
    builder.addBlock(block);
    const auto source = builder.finish();
    ASSERT_FALSE(source);
    EXPECT_EQ(source.error().front().file, block.shaderFile.string());
}

TEST(CompileErrors, PreprocessorOfMesa_NamesFileAndLine) {
    ShaderSource source;
    source.files = {"generated", "a.glsl", "b.glsl"};
    EXPECT_EQ(compileErrors("2:200009(1): preprocessor error: #error no\n", source).front().text(),
              "b.glsl:9:1: #error no");
}

} // namespace
} // namespace patina::block_text_test
