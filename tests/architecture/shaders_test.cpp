// SPDX-License-Identifier: GPL-3.0-or-later
// A block is a descriptor and a shader with one stem; its names follow from its folder and id.
#include <regex>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "catalog/block_kind.h"
#include "source_tree.h"

namespace patina::tests::shaders_test {
namespace {

std::string pascalCase(const std::string& id) {
    std::string name;
    bool capital = true;
    for (const char c : id) {
        if (c == '-') {
            capital = true;
            continue;
        }
        name += capital ? char(std::toupper(static_cast<unsigned char>(c))) : c;
        capital = false;
    }
    return name;
}

std::string kindOf(const SourceFile& file) {
    return std::filesystem::path(file.folder()).filename().string();
}

std::string structNameOf(const SourceFile& file) {
    const BlockKind* kind = findKind(kindOf(file));
    return pascalCase(file.stem()).append(kind == nullptr ? "" : kind->word);
}

std::vector<SourceFile> blockShaders() {
    std::vector<SourceFile> shaders;
    for (const BlockKind& kind : blockKinds()) {
        const std::string folder = "shaders/" + std::string(kind.folder);
        const std::vector<SourceFile> more = filesUnder({folder}, {".glsl"});
        shaders.insert(shaders.end(), more.begin(), more.end());
    }
    return shaders;
}

TEST(Blocks, Folders_AreKnownKinds) {
    for (const SourceFile& descriptor : blockDescriptors()) {
        EXPECT_NE(findKind(kindOf(descriptor)), nullptr) << descriptor.path;
    }
}

TEST(Blocks, Descriptor_HasAShaderBesideIt) {
    for (const SourceFile& descriptor : blockDescriptors()) {
        const auto shader = (projectRoot() / descriptor.path).replace_extension(".glsl");
        EXPECT_TRUE(std::filesystem::exists(shader)) << shader;
    }
}

TEST(Blocks, Shader_HasADescriptorBesideIt) {
    for (const SourceFile& shader : blockShaders()) {
        const auto descriptor = (projectRoot() / shader.path).replace_extension(".json");
        EXPECT_TRUE(std::filesystem::exists(descriptor)) << descriptor;
    }
}

TEST(Blocks, Shader_DefinesTheFunctionItsNameSays) {
    for (const SourceFile& shader : blockShaders()) {
        const std::string type = structNameOf(shader);
        std::string function = type;
        function[0] = char(std::tolower(static_cast<unsigned char>(function[0])));
        const std::regex definition(
            fmt::format(R"(\b{}\s*\([^)]*\b{}\s+p\s*\))", function, type));
        EXPECT_TRUE(std::regex_search(shader.text, definition)) << shader.path << ": " << function;
    }
}

TEST(Blocks, Shader_LeavesItsStructToTheGenerator) {
    for (const SourceFile& shader : blockShaders()) {
        const std::regex declaration("struct\\s+" + structNameOf(shader) + "\\b");
        EXPECT_FALSE(std::regex_search(shader.text, declaration)) << shader.path;
    }
}

} // namespace
} // namespace patina::tests::shaders_test
