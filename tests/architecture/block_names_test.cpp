// SPDX-License-Identifier: GPL-3.0-or-later
// Blocks are data: the program looks none of them up by a literal id, and none of their parameters.
// Words of the trade that are also ids (a box, a height, a point, linear light) may stand anywhere
// else.
#include <array>
#include <cctype>
#include <set>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "shading/glsl/tokens.h"
#include "source_tree.h"

namespace patina::tests::block_names_test {
namespace {

using Ids = std::set<std::string, std::less<>>;

const Ids& blockIds() {
    static const Ids ids = [] {
        Ids found;
        for (const SourceFile& descriptor : blockDescriptors()) {
            found.insert(descriptor.stem());
        }
        return found;
    }();
    return ids;
}

const Ids& parameterIds() {
    static const Ids ids = [] {
        Ids found;
        for (const SourceFile& descriptor : blockDescriptors()) {
            const auto json = nlohmann::json::parse(descriptor.text);
            for (const nlohmann::json& parameter : json["parameters"]) {
                found.insert(parameter["id"].get<std::string>());
            }
        }
        return found;
    }();
    return ids;
}

bool isNameCharacter(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
}

std::string_view withoutSpaceAtEnd(std::string_view text) {
    while (!text.empty() && std::isspace(static_cast<unsigned char>(text.back())) != 0) {
        text.remove_suffix(1);
    }
    return text;
}

/// The identifier that the text ends with.
std::string_view lastName(std::string_view text) {
    text = withoutSpaceAtEnd(text);
    const auto begins = std::find_if_not(text.rbegin(), text.rend(), isNameCharacter);
    return text.substr(static_cast<std::size_t>(text.rend() - begins));
}

/// What is called or constructed where this is the text before an argument, from the inside out.
std::vector<std::string_view> callsAround(std::string_view before) {
    std::vector<std::string_view> names;
    int depth = 0;
    for (std::size_t at = before.size(); at > 0; --at) {
        const char c = before[at - 1];
        if (c == ')' || c == '}') {
            ++depth;
        } else if ((c == '(' || c == '{') && depth > 0) {
            --depth;
        } else if (c == '(' || c == '{') {
            const std::string_view callee = withoutSpaceAtEnd(before.substr(0, at - 1));
            if (c == '{' && callee.ends_with(')')) { // the body of a function or a branch
                break;
            }
            names.push_back(lastName(callee));
        } else if (c == ';' && depth == 0) {
            break;
        }
    }
    return names;
}

std::string lowered(std::string_view text) {
    std::string lower(text);
    std::ranges::transform(lower, lower.begin(), [](unsigned char c) { return std::tolower(c); });
    return lower;
}

bool namesABlock(std::string_view name) {
    constexpr std::array<std::string_view, 6> words{"id", "block", "model", "light", "fog", "part"};
    const std::string lower = lowered(name);
    return std::ranges::any_of(words, [&](std::string_view word) { return lower.ends_with(word); });
}

bool looksUp(std::string_view call) {
    constexpr std::array<std::string_view, 9> words{
        "find", "block", "model", "light", "fog", "part", "fresnel", "shadow", "environment"};
    const std::string lower = lowered(call);
    return std::ranges::any_of(
        words, [&](std::string_view word) { return lower.find(word) != lower.npos; });
}

/// Whether a string between these texts is compared with an id, becomes one, or is looked up.
bool isLookup(std::string_view before, std::string_view after) {
    before = withoutSpaceAtEnd(before);
    for (const std::string_view comparison : {"==", "!=", "="}) {
        if (before.ends_with(comparison)) {
            return namesABlock(lastName(before.substr(0, before.size() - comparison.size())));
        }
    }
    const auto next =
        std::ranges::find_if_not(after, [](unsigned char c) { return std::isspace(c) != 0; });
    const std::string_view rest(next, after.end());
    if (rest.starts_with("==") || rest.starts_with("!=")) {
        const std::string_view compared = rest.substr(2);
        return namesABlock(lastName(compared.substr(0, compared.find_first_of(");&|?,"))));
    }
    return before.ends_with("\"id\",") || std::ranges::any_of(callsAround(before), looksUp);
}

/// Whether a string between these texts names a parameter that is looked up, or is compared with
/// the id of one.
bool isParameterLookup(std::string_view before, std::string_view /*after*/) {
    before = withoutSpaceAtEnd(before);
    for (const std::string_view lookup :
         {"parameter(", "parameters.find(", "parameters.at(", "parameters.contains(", "parameters[",
          ".id.starts_with(", ".id.ends_with("}) {
        if (before.ends_with(lookup)) {
            return true;
        }
    }
    const bool isCompared = before.ends_with("==") || before.ends_with("!=");
    const std::string_view compared =
        isCompared ? lastName(before.substr(0, before.size() - 2)) : std::string_view();
    return compared == "id" || compared == "parameterId";
}

/// Offsets of the literals that are ids and are looked up.
template <class IsLookup>
std::vector<std::size_t> lookups(std::string_view code, const Ids& ids, IsLookup isLookup) {
    std::vector<std::size_t> found;
    for (auto at = code.find('"'); at != code.npos; at = code.find('"', at + 1)) {
        const auto end = code.find('"', at + 1);
        if (end == code.npos) {
            break;
        }
        if (ids.contains(code.substr(at + 1, end - at - 1)) &&
            isLookup(code.substr(0, at), code.substr(end + 1))) {
            found.push_back(at);
        }
        at = end;
    }
    return found;
}

std::vector<std::size_t> lookups(std::string_view code, const Ids& ids) {
    return lookups(code, ids, isLookup);
}

TEST(BlockNames, Program_LooksNoParameterUpByALiteralId) {
    ASSERT_TRUE(parameterIds().contains("crease.width"));
    for (const SourceFile& file : filesUnder({"engine", "app"}, {".h", ".cpp", ".in"})) {
        for (const std::size_t at :
             lookups(withoutComments(file.text), parameterIds(), isParameterLookup)) {
            ADD_FAILURE() << file.place(at) << ": looks a parameter up by its id, not its role: "
                          << file.text.substr(at, 40);
        }
    }
}

TEST(BlockNames, LookupsOfParameters_AreFoundHoweverTheyAreWritten) {
    const Ids ids{"index", "width"};
    for (const char* code :
         {"block.parameter(\"index\")", "values.parameters.find(\"width\")",
          "light.parameters[\"width\"] = 1.0;", "if (field.parameter->id == \"index\") {",
          "parameter.id.ends_with(\"width\")"}) {
        EXPECT_EQ(lookups(code, ids, isParameterLookup).size(), 1u) << code;
    }
    for (const char* code : {"json.at(\"index\");", "{\"width\", options.width}"}) {
        EXPECT_TRUE(lookups(code, ids, isParameterLookup).empty()) << code;
    }
}

TEST(BlockNames, Program_LooksNoBlockUpByALiteralId) {
    ASSERT_FALSE(blockIds().empty());
    for (const SourceFile& file : filesUnder({"engine", "app"}, {".h", ".cpp", ".in"})) {
        for (const std::size_t at : lookups(withoutComments(file.text), blockIds())) {
            ADD_FAILURE() << file.place(at)
                          << ": looks a block up by its id: " << file.text.substr(at, 40);
        }
    }
}

TEST(BlockNames, Lookups_AreFoundHoweverTheyAreWritten) {
    const Ids ids{"box", "phong"};
    for (const char* code :
         {"catalog.find(kinds::fog, \"box\");", "if (values.id == \"box\") {",
          "if (\"phong\" != material.model.id && x) {",
          "constexpr std::string_view fogId = \"box\";", "BlockValues{\"phong\", 1, {}};",
          "document.setModel(Side::A, \"phong\");",
          "scene.setPart(kinds::fog, named(catalog, \"box\"));", "json{{\"id\", \"box\"}};",
          "model =\n    \"phong\";"}) {
        EXPECT_EQ(lookups(code, ids).size(), 1u) << code;
    }
}

TEST(BlockNames, WordsOfTheTrade_AreNoLookups) {
    const Ids ids{"box", "height", "linear"};
    for (const char* code :
         {"if (mesh == \"box\") {", "{\"normal\", \"height\", \"opacity\"};", "scale = \"linear\";",
          "json.at(\"height\");", "const Box box; const float height = box.height; // the box"}) {
        EXPECT_TRUE(lookups(code, ids).empty()) << code;
    }
}

} // namespace
} // namespace patina::tests::block_names_test
