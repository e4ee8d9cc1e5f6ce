// SPDX-License-Identifier: GPL-3.0-or-later
// Blocks are data: the program knows none of them by name.
#include <array>
#include <cctype>

#include <gtest/gtest.h>

#include "source_tree.h"

namespace patina::tests::block_names_test {
namespace {

/// Block ids that are also ordinary words of this trade. They may stand in a sentence or a name
/// (a point in space, the head of a list, linear light), but never as a string equal to the id.
constexpr std::array<std::string_view, 16> ordinaryWords = {
    "point",     "head",       "spot",      "linear",   "directional", "exponential",
    "empirical", "dielectric", "conductor", "constant", "hard",        "filtered",
    "soft",      "image",      "studio",    "weighted"};

/// Strings that equal an id and mean something else.
struct OtherMeaning {
    std::string_view file;
    std::string_view id;
    std::string_view why;
};
constexpr std::array<OtherMeaning, 4> otherMeanings = {
    {{"engine/catalog/", "linear", "the scale of a slider, as opposed to log"},
     {"engine/catalog/ramp", "constant", "colours that change in steps"},
     {"engine/catalog/", "image", "the word for what drives a parameter, in a message"},
     {"engine/material/texture_use", "linear", "numbers that are no sRGB codes"}}};

bool isWordCharacter(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) || c == '_' || c == '-';
}

/// Offset of `word` as a whole word, or npos.
std::size_t findWord(std::string_view text, std::string_view word) {
    for (auto at = text.find(word); at != text.npos; at = text.find(word, at + 1)) {
        const auto after = at + word.size();
        const bool begins = at == 0 || !isWordCharacter(text[at - 1]);
        if (begins && (after >= text.size() || !isWordCharacter(text[after]))) {
            return at;
        }
    }
    return text.npos;
}

bool meansSomethingElse(const SourceFile& file, std::string_view id) {
    return std::ranges::any_of(otherMeanings, [&](const OtherMeaning& other) {
        return other.id == id && file.path.starts_with(other.file);
    });
}

std::vector<SourceFile> programSources() {
    return filesUnder({"engine", "app"}, {".h", ".cpp", ".in"});
}

TEST(BlockNames, Program_HasNoStringEqualToAnId) {
    for (const SourceFile& descriptor : blockDescriptors()) {
        const std::string literal = '"' + descriptor.stem() + '"';
        for (const SourceFile& file : programSources()) {
            const auto at = file.text.find(literal);
            if (at != std::string::npos && !meansSomethingElse(file, descriptor.stem())) {
                ADD_FAILURE() << file.place(at) << ": " << literal << " is a block id";
            }
        }
    }
}

TEST(BlockNames, Program_HasNoIdThatIsNotAnOrdinaryWord) {
    for (const SourceFile& descriptor : blockDescriptors()) {
        const std::string id = descriptor.stem();
        if (std::ranges::find(ordinaryWords, id) != ordinaryWords.end()) {
            continue;
        }
        for (const SourceFile& file : programSources()) {
            const auto at = findWord(file.text, id);
            if (at != std::string::npos) {
                ADD_FAILURE() << file.place(at) << ": " << id << " is a block id";
            }
        }
    }
}

} // namespace
} // namespace patina::tests::block_names_test
