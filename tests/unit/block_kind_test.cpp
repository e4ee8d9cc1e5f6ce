// SPDX-License-Identifier: GPL-3.0-or-later
#include <array>
#include <fstream>
#include <set>
#include <sstream>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "catalog/kind_checks.h"

namespace patina::tests::block_kind_test {
namespace {

std::string textOf(const std::string& file) {
    std::ifstream stream(std::string(PATINA_SOURCE_DIR) + '/' + file);
    std::ostringstream text;
    text << stream.rdbuf();
    return text.str();
}

TEST(BlockKinds, Words_AreUnique) {
    std::set<std::string_view> folders;
    std::set<std::string_view> singulars;
    for (const BlockKind& kind : blockKinds()) {
        EXPECT_TRUE(folders.insert(kind.folder).second) << kind.folder;
        EXPECT_TRUE(singulars.insert(kind.singular).second) << kind.singular;
    }
}

TEST(BlockKinds, PartsOfAnOwner_AreThoseItMayDoWithout) {
    for (const auto& [owner, kind] :
         {std::pair(BlockOwner::Scene, kinds::fog), std::pair(BlockOwner::Scene, kinds::tone),
          std::pair(BlockOwner::Light, kinds::shadows),
          std::pair(BlockOwner::Material, kinds::fresnel)}) {
        const auto parts = partKinds(owner);
        EXPECT_NE(std::ranges::find(parts, kind), parts.end()) << kind;
    }
    for (const BlockOwner owner : {BlockOwner::Scene, BlockOwner::Light, BlockOwner::Material}) {
        for (const std::string_view kind : {kinds::models, kinds::lights}) {
            const auto parts = partKinds(owner);
            EXPECT_EQ(std::ranges::find(parts, kind), parts.end()) << kind;
        }
    }
}

TEST(BlockKinds, SecondFunctionOfDirections_IsRefusedByItsName) {
    constexpr BlockFunction own{"", "vec3", "Directions", "d"};
    constexpr BlockFunction tail{"Tail", "vec3", "Directions", "d"};
    constexpr BlockFunction tint{"Tint", "vec3"};
    constexpr std::array sound{own, tint};
    constexpr std::array broken{own, tail};
    BlockKind kind = blockKinds().front();
    kind.functions = sound;
    EXPECT_EQ(kindMistake(kind), "");
    kind.functions = broken;
    EXPECT_NE(kindMistake(kind).find("\"Tail\" of Directions"), std::string::npos);
}

TEST(BlockKinds, ArgumentThatIsCalledAsAKind_IsRefusedByItsName) {
    static constexpr std::array fields{ArgumentField{.key = "light"}};
    static constexpr std::array taking{BlockFunction{"", "float", "float", "x", false, fields}};
    BlockKind kind = blockKinds().front();
    kind.functions = taking;
    EXPECT_NE(kindMistake(kind).find("argument \"light\""), std::string::npos);
    for (const BlockKind& shipped : blockKinds()) {
        EXPECT_EQ(kindMistake(shipped), "");
    }
}

/// Other programs check files by the schemas alone, which name the parts or let others be.
TEST(BlockKinds, Parts_AreLetBeByTheSchemas) {
    for (const auto& [owner, schema] :
         {std::pair(BlockOwner::Material, "schemas/preset.schema.json"),
          std::pair(BlockOwner::Scene, "schemas/scene.schema.json")}) {
        const auto file = nlohmann::json::parse(textOf(schema));
        const bool takesOthers = file.value("additionalProperties", nlohmann::json(true)) != false;
        for (const std::string_view kind : partKinds(owner)) {
            EXPECT_TRUE(takesOthers || file.at("properties").contains(kind))
                << schema << ": " << kind;
        }
    }
}

/// The guide's table of signatures has a row for each function of each kind.
TEST(BlockKinds, Functions_StandInTheGuide) {
    const std::string guide = textOf("docs/design/blocks.md");
    for (const BlockKind& kind : blockKinds()) {
        for (const BlockFunction& function : kind.functions) {
            const std::string argument =
                function.argument.empty()
                    ? std::string()
                    : fmt::format("{} {}, ", function.argument, function.name);
            const std::string start = fmt::format("| {} | `{} ", kind.folder, function.result);
            const std::string end = fmt::format("{}({}", function.suffix, argument);
            bool isThere = false;
            for (auto at = guide.find(start); at != guide.npos; at = guide.find(start, at + 1)) {
                const std::string row = guide.substr(at, guide.find('\n', at) - at);
                isThere = isThere || row.find(end) != row.npos;
            }
            EXPECT_TRUE(isThere) << kind.folder << ": " << function.suffix;
        }
    }
}

/// Tells whether a table has a row whose first two cells name a kind and a role.
bool hasRoleRow(const std::string& guide, std::string_view kind, std::string_view role) {
    std::istringstream lines(guide);
    for (std::string line; std::getline(lines, line);) {
        const auto first = line.find(" | ");
        if (!line.starts_with("| ") || first == line.npos) {
            continue;
        }
        const auto second = line.find(" | ", first + 3);
        if (line.substr(0, first).find(kind) != line.npos &&
            line.substr(first, second - first).find(fmt::format("`{}`", role)) != line.npos) {
            return true;
        }
    }
    return false;
}

TEST(BlockKinds, Roles_StandInTheGuide) {
    const std::string guide = textOf("docs/design/blocks.md");
    for (const BlockKind& kind : blockKinds()) {
        for (const ParameterRole& role : kind.roles) {
            EXPECT_TRUE(hasRoleRow(guide, kind.folder, role.word))
                << kind.folder << ": " << role.word;
        }
    }
}

} // namespace
} // namespace patina::tests::block_kind_test
