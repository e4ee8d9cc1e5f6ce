// SPDX-License-Identifier: GPL-3.0-or-later
// The pages of docs/concepts: each of their pictures is made again by one script, and each page is
// found from the README.
#include <filesystem>
#include <regex>
#include <set>

#include <gtest/gtest.h>

#include "source_tree.h"

namespace patina::tests::concepts_test {
namespace {

namespace fs = std::filesystem;

const fs::path concepts = projectRoot() / "docs/concepts";

/// Returns what the pages link to that has one of the endings, as paths from their folder.
std::set<std::string> linksTo(const std::string& endings) {
    const std::regex link(R"(\]\(([^)#:]+\.()" + endings + R"())(#[^)]*)?\))");
    std::set<std::string> all;
    for (const SourceFile& page : filesUnder({"docs/concepts"}, {".md"})) {
        for (std::sregex_iterator it(page.text.begin(), page.text.end(), link), end; it != end;
             ++it) {
            all.insert((*it)[1]);
        }
    }
    return all;
}

std::set<std::string> filesWith(std::initializer_list<std::string_view> endings) {
    std::set<std::string> names;
    for (const SourceFile& file : filesUnder({"docs/concepts"}, endings)) {
        names.insert(file.name());
    }
    return names;
}

TEST(Concepts, Links_LeadToFiles) {
    for (const std::string& link : linksTo("md|png|svg")) {
        EXPECT_TRUE(fs::exists(concepts / link)) << link;
    }
}

TEST(Concepts, Pictures_AreMadeByTheScriptAndStandOnAPage) {
    const std::string script = readText(concepts / "pictures");
    const std::set<std::string> shown = linksTo("png|svg");
    const std::set<std::string> pictures = filesWith({".png", ".svg"});
    EXPECT_FALSE(pictures.empty());
    for (const std::string& picture : pictures) {
        EXPECT_NE(script.find("$here/" + picture), std::string::npos) << picture;
        EXPECT_TRUE(shown.contains(picture)) << picture;
    }
}

TEST(Concepts, Pages_AreFoundFromTheReadme) {
    const std::string readme = readText(projectRoot() / "README.md");
    for (const std::string& page : filesWith({".md"})) {
        EXPECT_NE(readme.find("docs/concepts/" + page), std::string::npos) << page;
    }
}

} // namespace
} // namespace patina::tests::concepts_test
