// SPDX-License-Identifier: GPL-3.0-or-later
// Patina's own text tools look at a stranger's file before any compiler does: they take a time that
// grows as its length does, and never more than a little of it. Each of these texts took minutes.
#include <chrono>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "catalog/descriptor.h"
#include "catalog/suggestion.h"
#include "shading/program/block_text.h"
#include "shading/glsl/shader_file.h"
#include "shading/program/source_builder.h"
#include "shading/glsl/unused_code.h"
#include "support/program.h"

namespace patina::hostile_text_test {
namespace {

using tests::TemporaryFolder;
using tests::writeFile;

constexpr double patience = 5.0; // seconds, under sanitizers too

class HostileText : public testing::Test {
  protected:
    ~HostileText() override {
        const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begun_;
        EXPECT_LT(taken.count(), patience);
    }

    static std::string repeated(const std::string& text, std::size_t times) {
        std::string all;
        for (std::size_t i = 0; i < times; ++i) {
            all += text;
        }
        return all;
    }

  private:
    std::chrono::steady_clock::time_point begun_ = std::chrono::steady_clock::now();
};

TEST_F(HostileText, BracesInOneLine_ArePruned) {
    withoutUnused({"void main() {}\nint a" + repeated("{}", 400'000) + ";\n"});
}

TEST_F(HostileText, OneNameManyTimes_IsPruned) {
    const ShaderSource source{repeated("void f();\n", 100'000) + "void main() { f(); }\n"};
    EXPECT_EQ(withoutUnused(source).text, source.text);
}

TEST_F(HostileText, DeepParentheses_AreReadOnce) {
    Block block;
    block.kind = "models";
    block.id = "deep";
    EXPECT_FALSE(blockTextMistakes(block, repeated("a b(", 250'000)).empty());
}

TEST_F(HostileText, VeryLongName_IsNobodysSlip) {
    const std::vector<std::string> names(64, std::string(1 << 20, 'x'));
    EXPECT_EQ(nearest("lambert", names), "");
}

TEST_F(HostileText, ManyMissingIncludes_AreToldAHundredTimes) {
    const TemporaryFolder folder;
    std::string text;
    for (int i = 0; i < 50'000; ++i) {
        text += "#include \"" + std::to_string(i) + "\"\n";
    }
    writeFile(folder / "many.glsl", text);
    SourceBuilder builder(folder.path());
    builder.addFile(folder / "many.glsl");
    EXPECT_EQ(builder.finish().error().size(), 100u);
}

TEST_F(HostileText, IncludesInACircle_EndEachOnce) {
    const TemporaryFolder folder;
    writeFile(folder / "a.glsl", "#include \"b.glsl\"\nint a;\n");
    writeFile(folder / "b.glsl", "#include \"a.glsl\"\nint b;\n");
    SourceBuilder builder(folder.path());
    builder.addFile(folder / "a.glsl");
    const auto source = builder.finish();
    ASSERT_TRUE(source);
    EXPECT_NE(source->text.find("int b;"), std::string::npos);
}

TEST_F(HostileText, DescriptorOfThousandsOfParameters_IsReadOrRefused) {
    std::string parameters;
    for (int i = 0; i < 3000; ++i) {
        parameters += fmt::format(R"({}{{"id": "a{}", "label": "A", "doc": "A.", "type": "bool"}})",
                                  i == 0 ? "" : ", ", i);
    }
    const TemporaryFolder folder;
    std::filesystem::create_directory(folder / "models");
    writeFile(folder / "models/many.json",
              R"({"id": "many", "version": 1, "label": "M", "summary": "M.", "parameters": [)" +
                  parameters + "]}");
    const auto schema = JsonSchema::load("descriptor");
    ASSERT_TRUE(schema);
    const auto descriptor = readDescriptor(folder / "models/many.json", *schema);
    EXPECT_TRUE(!descriptor || descriptor->block.parameters.size() == 3000);
}

TEST_F(HostileText, DescriptorOfMegabytes_IsRefused) {
    const TemporaryFolder folder;
    writeFile(folder / "large.json", "{\"doc\": \"" + std::string(1 << 20, 'x') + "\"}");
    const auto schema = JsonSchema::load("descriptor");
    ASSERT_TRUE(schema);
    const auto descriptor = readDescriptor(folder / "large.json", *schema);
    ASSERT_FALSE(descriptor);
    EXPECT_EQ(descriptor.error().front().problem, "the file is too large");
}

TEST_F(HostileText, HundredMegabytes_AreRefusedUnread) {
    const TemporaryFolder folder;
    writeFile(folder / "large.glsl", "int a;\n");
    std::filesystem::resize_file(folder / "large.glsl", std::uintmax_t(100) << 20);
    const auto text = readShaderFile(folder / "large.glsl");
    ASSERT_FALSE(text);
    EXPECT_NE(text.error().problem.find("larger than 1 MiB"), std::string::npos);
}

} // namespace
} // namespace patina::hostile_text_test
