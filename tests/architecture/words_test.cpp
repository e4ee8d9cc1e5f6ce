// SPDX-License-Identifier: GPL-3.0-or-later
// Words of our own for what the field has a name for, which have been replaced by that name.
#include <cctype>
#include <sstream>
#include <string>

#include <gtest/gtest.h>

#include "source_tree.h"

namespace patina::tests::words_test {
namespace {

struct ReplacedWord {
    std::string word; ///< in any case, unless it has capitals
    std::string instead;
};

const ReplacedWord replacedWords[] = {
    {"foresee", "prewarm, plan"},
    {"right frame", "ground truth"},
    {"stand-in", "fallback, approximation"},
    {"piece work", "steps, tiles"},
    {"stepped work", "steps"},
    {"LEAST_", "MIN_"},
};

/// The words of a text with one space before each, without the marks of comments.
std::string flowing(const std::string& text) {
    std::string words;
    std::istringstream stream(text);
    for (std::string word; stream >> word;) {
        if (word != "//" && word != "///") {
            words += ' ' + word;
        }
    }
    return words;
}

std::string lowerCase(std::string text) {
    for (char& letter : text) {
        letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
    }
    return text;
}

TEST(Words, OfOurOwn_HaveGivenWayToThoseOfTheField) {
    for (const SourceFile& file : filesUnder({"app", "docs", "engine", "shaders"},
                                             {".cpp", ".glsl", ".h", ".json", ".md"})) {
        const std::string text = flowing(file.text);
        const std::string lower = lowerCase(text);
        for (const auto& [word, instead] : replacedWords) {
            const bool isThere = word == lowerCase(word) ? lower.find(word) != std::string::npos
                                                         : text.find(word) != std::string::npos;
            EXPECT_FALSE(isThere) << file.path << ": \"" << word << "\" is called " << instead;
        }
    }
}

} // namespace
} // namespace patina::tests::words_test
