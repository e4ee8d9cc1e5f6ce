// SPDX-License-Identifier: GPL-3.0-or-later
// What holds for every file: a licence, a size that reads well, no test that is switched off.
#include <algorithm>
#include <array>
#include <map>
#include <regex>
#include <string>
#include <string_view>

#include <gtest/gtest.h>

#include "source_tree.h"

namespace patina::tests::files_test {
namespace {

std::vector<SourceFile> everyFile() {
    return filesUnder(
        {".ci", "app", "docs", "engine", "packaging", "presets", "schemas", "shaders", "tests"});
}

/// A path pattern of .reuse/dep5 as a regular expression: * crosses folders.
std::regex globExpression(const std::string& glob) {
    std::string expression;
    for (const char c : glob) {
        if (c == '*') {
            expression += ".*";
        } else if (std::string_view(".+()[]").find(c) != std::string_view::npos) {
            expression += std::string("\\") + c;
        } else {
            expression += c;
        }
    }
    return std::regex(expression);
}

struct LicenceRule {
    std::regex path;
    std::string licence;
};

/// The rules of .reuse/dep5 for files that cannot hold a comment.
std::vector<LicenceRule> licenceRules() {
    const std::string text = readText(projectRoot() / ".reuse/dep5");
    static const std::regex paragraph(R"-(Files: ([^\n]*)\nCopyright: [^\n]*\nLicense: (\S+))-");
    std::vector<LicenceRule> rules;
    for (std::sregex_iterator it(text.begin(), text.end(), paragraph), end; it != end; ++it) {
        std::istringstream paths((*it)[1]);
        for (std::string path; paths >> path;) {
            rules.push_back({globExpression(path), (*it)[2]});
        }
    }
    return rules;
}

/// The licence of a file: its own SPDX line near the top, else the last rule that matches it.
std::string licenceOf(const SourceFile& file) {
    static const std::regex line("SPDX-License-"
                                 "Identifier: ([A-Za-z0-9.-]+)");
    const std::string top = file.text.substr(0, 400);
    std::smatch match;
    if (std::regex_search(top, match, line)) {
        return match[1];
    }
    std::string licence;
    for (const LicenceRule& rule : licenceRules()) {
        if (std::regex_match(file.path, rule.path)) {
            licence = rule.licence;
        }
    }
    return licence;
}

bool isGivenAway(const SourceFile& file) {
    return file.path.starts_with("shaders/") || file.path.starts_with("presets/");
}

TEST(Licences, EveryFile_StatesTheOneOfItsFolder) {
    for (const SourceFile& file : everyFile()) {
        const std::string expected = isGivenAway(file) ? "MIT-0" : "GPL-3.0-or-later";
        EXPECT_EQ(licenceOf(file), expected) << file.path;
    }
}

TEST(Licences, Code_StatesItInTheFileItself) {
    static const std::string mark = "SPDX-License-"
                                    "Identifier: ";
    for (const SourceFile& file : everyFile()) {
        if (file.endsWith(".cpp") || file.endsWith(".h") || file.endsWith(".glsl") ||
            file.endsWith(".cmake") || file.endsWith("CMakeLists.txt")) {
            EXPECT_LT(file.text.find(mark), 80u) << file.path;
        }
    }
}

TEST(Files, Lines_HaveAtMost100Columns) {
    for (const SourceFile& file :
         filesUnder({"app", "engine", "tests"}, {".cpp", ".h", ".cmake", "CMakeLists.txt"})) {
        std::istringstream lines(file.text);
        int number = 0;
        for (std::string line; std::getline(lines, line);) {
            ++number;
            // Count characters, not the bytes after the first of a UTF-8 sequence.
            const auto columns =
                std::ranges::count_if(line, [](char c) { return (c & 0xC0) != 0x80; });
            EXPECT_LE(columns, 100) << file.path << ":" << number;
        }
    }
}

/// Two files of one name are told apart by their folder only: in a search, a tab, an error message.
TEST(Files, SourcesOfTheProgram_AreNamedApart) {
    std::map<std::string, std::string> folders;
    for (const SourceFile& file : filesUnder({"app", "engine"}, {".cpp", ".h"})) {
        if (file.name() != "main.cpp") {
            const auto& [stem, folder] = *folders.try_emplace(file.stem(), file.folder()).first;
            EXPECT_EQ(file.folder(), folder) << stem;
        }
    }
}

/// Where a test needs the files of a package that some systems do not have, it says so.
constexpr std::array<std::string_view, 2> mayMissFiles = {"tests/assets/corpus_test.cpp",
                                                          "tests/proofs/proofs_test.cpp"};

TEST(Files, Tests_AreNeverSwitchedOff) {
    static const std::regex off("DISABLED"
                                "_|GTEST"
                                "_SKIP|Q"
                                "SKIP|#if"
                                " 0");
    for (const SourceFile& file : filesUnder({"app", "engine", "tests"})) {
        std::smatch match;
        if (std::ranges::find(mayMissFiles, file.path) == mayMissFiles.end() &&
            std::regex_search(file.text, match, off)) {
            ADD_FAILURE() << file.place(std::size_t(match.position())) << ": " << match.str();
        }
    }
}

TEST(Files, Sources_HaveNoLeftOverMarks) {
    static const std::regex marks("\\b(TO"
                                  "DO|FIX"
                                  "ME|XX"
                                  "X|HA"
                                  "CK)\\b");
    for (const SourceFile& file : filesUnder({"app", "engine", "shaders", "tests", "packaging"},
                                             {".cpp", ".h", ".glsl", ".cmake", ".txt", ".sh"})) {
        std::smatch match;
        if (std::regex_search(file.text, match, marks)) {
            ADD_FAILURE() << file.place(std::size_t(match.position())) << ": " << match.str();
        }
    }
}

} // namespace
} // namespace patina::tests::files_test
