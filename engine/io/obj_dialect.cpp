// SPDX-License-Identifier: GPL-3.0-or-later
#include "io/obj_dialect.h"

#include <algorithm>
#include <array>
#include <cstddef>

namespace patina {
namespace {

constexpr std::string_view blanks = " \t\r";

/// Says what a line may consist of after its keyword.
struct Statement {
    std::string_view keyword;
    std::string_view characters; ///< is empty when all are allowed
    std::size_t minWords = 0;
    std::size_t maxWords = std::string_view::npos;
};
constexpr std::string_view real = "0123456789+-.eE \t\r";
constexpr std::string_view cornerText = "0123456789-/ \t\r";
constexpr std::array statements = {Statement{"v", real, 3, 3},  Statement{"f", cornerText, 3, 3},
                                   Statement{"vn", real, 3, 3}, Statement{"vt", real, 1, 3},
                                   Statement{"v", real, 6, 6}, // with a colour
                                   Statement{"usemtl", "", 0},  Statement{"mtllib", "", 0},
                                   Statement{"o", "", 0},       Statement{"g", "", 0},
                                   Statement{"s", "", 0}};

std::array<bool, 256> setOf(std::string_view characters) {
    std::array<bool, 256> set{};
    for (const char c : characters) {
        set[static_cast<unsigned char>(c)] = true;
    }
    return set;
}

bool hasOnly(std::string_view text, std::string_view characters) {
    static const std::array<bool, 256> reals = setOf(real);
    static const std::array<bool, 256> cornerSet = setOf(cornerText);
    const auto& allowed = characters.data() == real.data() ? reals : cornerSet;
    return characters.empty() || std::ranges::all_of(text, [&](char c) {
               return allowed[static_cast<unsigned char>(c)];
           });
}

std::size_t wordsIn(std::string_view text) {
    std::size_t words = 0;
    bool inside = false;
    for (const char c : text) {
        const bool blank = c == ' ' || c == '\t' || c == '\r';
        words += !blank && !inside ? 1 : 0;
        inside = !blank;
    }
    return words;
}

bool isPlainLine(std::string_view line) {
    line.remove_prefix(std::min(line.find_first_not_of(blanks), line.size()));
    if (line.empty() || line.front() == '#') {
        return true;
    }
    const std::string_view keyword = line.substr(0, line.find_first_of(blanks));
    const std::string_view rest = line.substr(keyword.size());
    return std::ranges::any_of(statements, [&](const Statement& statement) {
        if (statement.keyword != keyword || !hasOnly(rest, statement.characters)) {
            return false;
        }
        const std::size_t words = wordsIn(rest);
        return words >= statement.minWords && words <= statement.maxWords;
    });
}

/// Finds the next number that starts with its point, from `from` on.
std::size_t findBarePoint(std::string_view text, std::size_t from) {
    const auto isBare = [&](std::size_t i) {
        const bool begins = i > 0 && blanks.find(text[i - 1]) != std::string_view::npos;
        return begins && i + 1 < text.size() && text[i + 1] >= '0' && text[i + 1] <= '9';
    };
    std::size_t at = text.find('.', from);
    while (at != std::string_view::npos && !isBare(at)) {
        at = text.find('.', at + 1);
    }
    return at;
}

} // namespace

std::optional<std::string> withLeadingZeros(std::string_view text) {
    std::size_t point = findBarePoint(text, 0);
    if (point == std::string_view::npos) {
        return std::nullopt;
    }
    std::string whole;
    whole.reserve(text.size() + text.size() / 8);
    std::size_t done = 0;
    for (; point != std::string_view::npos; point = findBarePoint(text, point + 1)) {
        whole.append(text, done, point - done).append(1, '0');
        done = point;
    }
    return whole.append(text, done);
}

bool choosesMaterials(std::string_view text) {
    constexpr std::string_view word = "usemtl";
    for (std::size_t at = text.find(word); at != std::string_view::npos;
         at = text.find(word, at + 1)) {
        const std::size_t before = at == 0 ? 0 : text.find_last_not_of(blanks, at - 1);
        if (at == 0 || before == std::string_view::npos || text[before] == '\n') {
            return true;
        }
    }
    return false;
}

bool isPlainObj(std::string_view text) {
    if (text.find('\\') != std::string_view::npos || text.find('\0') != std::string_view::npos) {
        return false;
    }
    while (!text.empty()) {
        const std::size_t length = std::min(text.find('\n'), text.size());
        if (!isPlainLine(text.substr(0, length))) {
            return false;
        }
        text.remove_prefix(std::min(length + 1, text.size()));
    }
    return true;
}

} // namespace patina
