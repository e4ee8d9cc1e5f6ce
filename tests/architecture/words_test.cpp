// SPDX-License-Identifier: GPL-3.0-or-later
// Words of our own for what the field has a name for, which have been replaced by that name.
#include <regex>
#include <string>

#include <gtest/gtest.h>

#include "source_tree.h"

namespace patina::tests::words_test {
namespace {

struct ReplacedWord {
    std::string pattern; ///< of a text whose line breaks and comment marks are spaces
    std::string instead;
};

const ReplacedWord replacedWords[] = {
    {"foresee", "prewarm, plan"},
    {"right frame", "ground truth"},
    {"stand-in", "fallback, approximation"},
    {"piece work", "steps, tiles"},
    {"stepped work", "steps"},
    {"\\bLEAST_", "MIN_"},
};

/// The text with every break between two of its words as one space.
std::string flowing(const std::string& text) {
    static const std::regex breaks(R"(\s*\n\s*(//+|\*)?\s*)");
    return std::regex_replace(text, breaks, " ");
}

TEST(Words, OfOurOwn_HaveGivenWayToThoseOfTheField) {
    for (const SourceFile& file : filesUnder({"app", "docs", "engine", "shaders"},
                                             {".cpp", ".glsl", ".h", ".json", ".md"})) {
        const std::string text = flowing(file.text);
        for (const auto& [pattern, instead] : replacedWords) {
            const std::regex word(pattern, std::regex::icase);
            EXPECT_FALSE(std::regex_search(text, word))
                << file.path << ": \"" << pattern << "\" is called " << instead;
        }
    }
}

} // namespace
} // namespace patina::tests::words_test
