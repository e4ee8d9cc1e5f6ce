// SPDX-License-Identifier: GPL-3.0-or-later
// What a user's block defines for itself may have the name that something else in a program has.
#include "shading/glsl/private_names.h"

#include <algorithm>

#include "gpu_fixture.h"
#include "shading/program/source_builder.h"
#include "support/program.h"

namespace patina::private_names_test {
namespace {

using tests::readFile;
using tests::TemporaryFolder;
using tests::writeFile;

/// A program with the models "first" and "second", whose files begin like this.
std::string programOf(const std::string& first, const std::string& second,
                      const std::string& between = "") {
    const TemporaryFolder folder;
    SourceBuilder builder(folder.path());
    for (const auto& [id, text] : {std::pair("first", first), std::pair("second", second)}) {
        Block block;
        block.kind = "models";
        block.id = id;
        block.shipped = false;
        block.shaderFile = folder / (std::string(id) + ".glsl");
        writeFile(block.shaderFile, text + "\nvec3 " + id + "(Directions d, " + structName(block) +
                                        " p) {\n    return vec3(1.0);\n}\n");
        builder.addBlock(block);
        builder.add(id == std::string("first") ? between : "");
    }
    const auto source = builder.finish();
    return source ? source->text : text(source.error());
}

bool has(const std::string& text, const std::string& part) {
    return text.find(part) != std::string::npos;
}

const std::string square = "float sq(float x) {\n    return x * x;\n}";

TEST(PrivateNames, HelperOfTwoBlocks_BelongsToEach) {
    const std::string program = programOf(square, square);
    EXPECT_TRUE(has(program, "#define sq sqOfFirst\n")) << program;
    EXPECT_TRUE(has(program, "#define sq sqOfSecond\n")) << program;
    EXPECT_EQ(std::ranges::count(program, '#'), 8) << program; // with four #line, two #undef
}

TEST(PrivateNames, HelperOfOneBlock_KeepsItsName) {
    EXPECT_FALSE(has(programOf(square, ""), "#define"));
}

TEST(PrivateNames, ConstantsAndStructs_BelongToTheirBlockToo) {
    const std::string text = "const float LEAST = 1.0;\nstruct Cone {\n    float a;\n};";
    const std::string program = programOf(text, text);
    EXPECT_TRUE(has(program, "#define LEAST LEASTOfSecond\n")) << program;
    EXPECT_TRUE(has(program, "#define Cone ConeOfSecond\n")) << program;
}

TEST(PrivateNames, NameInsideOfAFunction_IsNoClash) {
    EXPECT_FALSE(has(programOf(square, "float cube(float x) {\n    float sq = x * x;\n"
                                       "    return sq * x;\n}"),
                     "#define"));
}

TEST(PrivateNames, Macro_EndsWithItsBlock) {
    const std::string program = programOf("#define HALF 0.5", "#define HALF 0.25");
    const std::size_t end = program.find("#undef HALF");
    EXPECT_LT(program.find("#define HALF 0.5"), end) << program;
    EXPECT_LT(end, program.find("#define HALF 0.25")) << program;
}

TEST(PrivateNames, FunctionThatPatinasTextHasAfterIt_BelongsToTheBlock) {
    EXPECT_TRUE(has(programOf(square, "", "float sq(float y) {\n    return y * y;\n}\n"),
                    "#define sq sqOfFirst\n"));
}

TEST(PrivateNames, FunctionOfOtherArguments_MayStandBesideOneOfPatinas) {
    EXPECT_FALSE(has(programOf(square, "", "float sq(vec3 y) {\n    return dot(y, y);\n}\n"),
                     "#define"));
}

TEST(PrivateNames, NameOfAField_StaysBecauseTheFieldIsNotTheBlocks) {
    const std::string text = "float nl(Directions d) {\n    return d.nl;\n}";
    EXPECT_FALSE(has(programOf(text, text), "#define"));
}

TEST(PrivateNames, MacroOfPatinas_IsNotDefinedAgain) {
    EXPECT_FALSE(has(programOf(square, square, "#define sq 1\n"), "sqOf"));
}

TEST(PrivateNames, LinesOfNoFile_AreCountedAnew) {
    ShaderSource source;
    source.text = "float sq(float x);\n#line 100001 1\nfloat sq(float x);\n#line 4 0\nfloat a;\n";
    const std::size_t first = source.text.find("#line 1");
    const BlockPart part{first, source.text.find("float a"), "Mine", "mine"};
    EXPECT_EQ(withPrivateNames(source, std::array{part}).text,
              "float sq(float x);\n#define sq sqOfMine\n#line 100001 1\nfloat sq(float x);\n"
              "#line 6 0\n#undef sq\nfloat a;\n");
}

class PrivateNamesTest : public GpuTest {
  protected:
    /// A copy of the shipped spot light under another id, whose helpers keep their names.
    void addCopy(const std::string& id, const std::string& type, const std::string& constant) {
        const std::filesystem::path shipped = PATINA_SOURCE_DIR "/shaders/lights/spot";
        std::string glsl = readFile(shipped.string() + ".glsl");
        replace(glsl, "SpotLight", type);
        replace(glsl, "spotLight", std::string(1, char(std::tolower(type[0]))) + type.substr(1));
        replace(glsl, "SPOT_LIGHT", constant);
        writeFile(folder_ / "lights" / (id + ".glsl"), glsl);
        std::string json = readFile(shipped.string() + ".json");
        replace(json, "\"id\": \"spot\"", "\"id\": \"" + id + '"');
        writeFile(folder_ / "lights" / (id + ".json"), json);
    }

    static void replace(std::string& text, const std::string& what, const std::string& by) {
        for (std::size_t at = text.find(what); at != std::string::npos;
             at = text.find(what, at + by.size())) {
            text.replace(at, what.size(), by);
        }
    }

    std::shared_ptr<const Catalog> both() const {
        return std::make_shared<const Catalog>(
            loadCatalog(std::array{BlockRoot{PATINA_SOURCE_DIR "/shaders", true},
                                   BlockRoot{folder_.path(), false}}));
    }

    TemporaryFolder folder_;
};

TEST_F(PrivateNamesTest, CopiesOfAShippedLight_ShineBesideIt) {
    addCopy("gobo", "GoboLight", "GOBO_LIGHT");
    addCopy("lantern", "LanternLight", "LANTERN_LIGHT");
    catalog = both();
    ASSERT_EQ(text(catalog->errors), "");
    makeRenderer();
    Scene scene = simpleScene();
    scene.lights = {light("spot")};
    const float one = middle(capture(scene)).g;
    scene.lights = {light("spot"), light("gobo"), light("lantern")};
    const float three = middle(capture(scene)).g;
    EXPECT_EQ(text(renderer->report().messages), "");
    EXPECT_GT(one, 0.0f);
    EXPECT_NEAR(three, 3.0f * one, 1e-3f); // two steps of the half floats of a picture
}

} // namespace
} // namespace patina::private_names_test
