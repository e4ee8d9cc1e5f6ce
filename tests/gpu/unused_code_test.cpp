// SPDX-License-Identifier: GPL-3.0-or-later
#include "shading/glsl/unused_code.h"

#include <cctype>
#include <map>
#include <regex>

#include "shading_scene.h"

namespace patina::unused_code_test {
namespace {

std::string kept(const std::string& text) {
    return withoutUnused({text, {"generated", "lib.glsl"}}).text;
}

TEST(UnusedCode, FunctionThatNobodyCalls_IsLeftOut) {
    EXPECT_EQ(kept("float idle() {\n    return 1.0;\n}\nvoid main() {\n}\n"),
              "void main() {\n}\n");
}

TEST(UnusedCode, FunctionCalledThroughAnother_Stays) {
    const std::string text = "float inner() { return 1.0; }\nfloat outer() { return inner(); }\n"
                             "void main() {\n    outer();\n}\n";
    EXPECT_EQ(kept(text), text);
}

TEST(UnusedCode, FunctionsThatCallOnlyEachOther_AreLeftOut) {
    EXPECT_EQ(kept("float ping();\nfloat pong() { return ping(); }\n"
                   "float ping() { return pong(); }\nvoid main() {}\n"),
              "void main() {}\n");
}

TEST(UnusedCode, EveryOverloadOfACalledFunction_Stays) {
    const std::string text = "float f(float x) { return x; }\nvec3 f(vec3 x) { return x; }\n"
                             "void main() { f(1.0); }\n";
    EXPECT_EQ(kept(text), text);
}

TEST(UnusedCode, StructsConstantsAndMacros_StayWhereTheyAreRead) {
    const std::string used = "#define SIZE WIDTH\nconst int WIDTH = 2;\nstruct Used {\n    int a;\n"
                             "};\nvoid main() {\n    Used u;\n    u.a = SIZE;\n}\n";
    EXPECT_EQ(kept("#define OTHER 1\nconst float LOST = 1.0;\nstruct Idle {\n    int b;\n};\n" +
                   used),
              used);
}

TEST(UnusedCode, InputsOutputsAndUniforms_AlwaysStay) {
    const std::string text = "#version 410 core\nlayout(std140) uniform Block {\n"
                             "    vec4 data[2];\n};\nuniform sampler2D image;\nin vec3 place;\n"
                             "out vec4 color;\nvoid main() {}\n";
    EXPECT_EQ(kept(text), text);
}

TEST(UnusedCode, LinesAfterWhatIsLeftOut_KeepTheirNumbers) {
    EXPECT_EQ(kept("#line 100001 1\nfloat idle() { return 1.0; }\nfloat used() { return 1.0; }\n"
                   "#line 5 0\nvoid main() { used(); }\n"),
              "#line 100002 1\nfloat used() { return 1.0; }\n#line 4 0\nvoid main() { used(); }\n");
}

TEST(UnusedCode, BracesThatDoNotMatch_ChangeNothing) {
    const std::string text = "float idle() {\nvoid main() {}\n";
    EXPECT_EQ(kept(text), text);
}

std::vector<std::string> wordsOf(const std::string& source) {
    std::vector<std::string> words(1);
    for (const char c : source) {
        if (std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_') {
            words.back() += c;
        } else if (!words.back().empty()) {
            words.emplace_back();
        }
    }
    return words;
}

/// Whatever is in the scene, nothing is in the program that it does not call.
class EveryModel : public ShadingTest, public testing::WithParamInterface<std::string> {};

TEST_P(EveryModel, EveryFunctionOfItsProgram_IsCalled) {
    Scene scene;
    scene.lights = {light("directional")};
    const std::string source = fragment(material(GetParam()), scene);
    std::map<std::string, int> uses;
    for (const std::string& word : wordsOf(source)) {
        ++uses[word];
    }
    const std::regex definition(R"(\n(?:float|vec2|vec3|vec4|bool|int|void|[A-Z]\w+) (\w+)\()");
    int functions = 0;
    for (std::sregex_iterator found(source.begin(), source.end(), definition), end; found != end;
         ++found) {
        const std::string name = (*found)[1];
        EXPECT_TRUE(name == "main" || uses[name] > 1) << name;
        ++functions;
    }
    EXPECT_GT(functions, 3);
}

std::vector<std::string> modelIds() {
    const Catalog catalog = loadCatalog(std::array{BlockRoot{PATINA_SOURCE_DIR "/shaders", true}});
    std::vector<std::string> ids;
    for (const Block* model : catalog.ofKind("models")) {
        ids.push_back(model->id);
    }
    return ids;
}

INSTANTIATE_TEST_SUITE_P(Models, EveryModel, testing::ValuesIn(modelIds()),
                         [](const auto& instance) {
                             return std::regex_replace(instance.param, std::regex("-"), "_");
                         });

} // namespace
} // namespace patina::unused_code_test
