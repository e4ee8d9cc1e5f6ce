// SPDX-License-Identifier: GPL-3.0-or-later
// What the guide says of a new command holds for those that are there.
#include <cctype>
#include <regex>

#include <gtest/gtest.h>

#include "source_tree.h"

namespace patina::tests::recipes_test {
namespace {

/// "Check" of "void addCheck(CLI::App& program, int& status);", for each command.
std::vector<std::string> commands() {
    const std::string text = readText(projectRoot() / "app/cli/command.h");
    static const std::regex declaration(R"(void add(\w+)\(CLI::App& program, int& status\);)");
    std::vector<std::string> names;
    std::sregex_iterator it(text.begin(), text.end(), declaration);
    for (const std::sregex_iterator end; it != end; ++it) {
        names.push_back((*it)[1]);
    }
    return names;
}

std::string wordOf(std::string command) {
    command.front() = static_cast<char>(std::tolower(static_cast<unsigned char>(command.front())));
    return command;
}

TEST(Recipes, EveryCommand_IsAFileAndARowAndIsTested) {
    const std::string list = readText(projectRoot() / "app/cli/cli.cpp");
    const std::string readme = readText(projectRoot() / "README.md");
    const std::vector<SourceFile> tests = filesUnder({"tests/cli"}, {".cpp"});
    ASSERT_FALSE(commands().empty());
    for (const std::string& command : commands()) {
        const std::string word = wordOf(command);
        const std::string source = readText(projectRoot() / "app/cli" / (word + ".cpp"));
        EXPECT_NE(source.find("void add" + command + "("), std::string::npos) << word;
        EXPECT_NE(list.find("add" + command), std::string::npos) << word;
        EXPECT_NE(readme.find("\n| `patina " + word), std::string::npos) << word;
        EXPECT_TRUE(std::ranges::any_of(tests, [&](const SourceFile& test) {
            return test.text.find('"' + word + '"') != std::string::npos;
        })) << word;
    }
}

} // namespace
} // namespace patina::tests::recipes_test
