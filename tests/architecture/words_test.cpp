// SPDX-License-Identifier: GPL-3.0-or-later
// Words of our own for what the field has a name for, which have been replaced by that name.
#include <cctype>
#include <regex>
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
    {"foresight", "prewarming"},
    {"foreseen", "prewarmed, planned"},
    {"materialprint", "hash"},
    {"fingerprint", "hash"},
    {"right frame", "ground truth"},
    {"rightframe", "ground truth"},
    {"lackedprograms", "missing programs"},
    {"lackof", "what is missing"},
    {"lets through", "is transparent"},
    {"letsthrough", "is transparent"},
    {"letting through", "is transparent"},
    {"lettingthrough", "is transparent"},
    {"shinesthrough", "is transparent"},
    {"sound normal", "valid normal"},
    {"soundnormal", "valid normal"},
    {"hard place", "edge-case direction"},
    {"hard direction", "edge-case direction"},
    {"hard value", "edge-case value"},
    {"hardplace", "edge-case direction"},
    {"hardvalue", "edge-case value"},
    {"shadow hole", "alpha-tested caster"},
    {"showsscenebent", "shows the scene refracted"},
    {"looksbehind", "needs the scene's color"},
    {"stand-in", "fallback, approximation"},
    {"asastandin", "as a fallback"},
    {"effecthold", "frozen effects"},
    {"held effect", "frozen effect"},
    {"heldeffect", "frozen effect"},
    {"errorstandard", "baseline"},
    {"outlook", "sky ray"},
    {"lookedat", "preview"},
    {"laidover", "overlaid"},
    {"framebands", "row tiles"},
    {"frame bands", "row tiles"},
    {"long piece", "step budget"},
    {"longpiece", "step budget"},
    {"piece work", "steps, tiles"},
    {"piecework", "steps, tiles"},
    {"stepped work", "steps"},
    {"steppedwork", "steps"},
    {"slicedcapture", "incremental capture"},
    {"sliced capture", "incremental capture"},
    {"EnvironmentWay", "method"},
    {"issound", "is valid, is clean"},
    {"waytext", "setting, method"},
    {"wayname", "setting, method"},
    {"LEAST_", "MIN_"},
    {"MOST_", "MAX_"},
    {"FEWEST_", "MIN_"},
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
    for (const SourceFile& file : filesUnder({"app", "docs", "engine", "shaders", "tests"},
                                             {".cpp", ".glsl", ".h", ".json", ".md"})) {
        if (file.path.ends_with("words_test.cpp")) {
            continue; // it lists them
        }
        const std::string text = flowing(file.text);
        const std::string lower = lowerCase(text);
        for (const auto& [word, instead] : replacedWords) {
            const bool isThere = word == lowerCase(word) ? lower.find(word) != std::string::npos
                                                         : text.find(word) != std::string::npos;
            EXPECT_FALSE(isThere) << file.path << ": \"" << word << "\" is called " << instead;
        }
    }
}

TEST(Words, BoundsOfNumbers_AreCalledMinAndMax) {
    static const std::regex bound(R"(\b(most|least|fewest)[A-Z]\w*|\b(const|constexpr|int|float|)"
                                  R"(double|size_t|GLint|auto) (most|least|fewest)\b)");
    for (const SourceFile& file : filesUnder({"app", "engine"}, {".cpp", ".glsl", ".h"})) {
        std::smatch found;
        EXPECT_FALSE(std::regex_search(file.text, found, bound))
            << file.path << ": " << found.str();
    }
}

} // namespace
} // namespace patina::tests::words_test
