// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/suggestion.h"

#include <algorithm>
#include <numeric>
#include <utility>
#include <vector>

namespace patina {
namespace {

/// Levenshtein's distance (1966): the fewest letters to add, drop or change.
std::size_t distance(std::string_view a, std::string_view b) {
    std::vector<std::size_t> row(b.size() + 1);
    std::iota(row.begin(), row.end(), std::size_t{0});
    for (std::size_t i = 0; i < a.size(); ++i) {
        std::size_t diagonal = std::exchange(row[0], i + 1);
        for (std::size_t j = 0; j < b.size(); ++j) {
            const std::size_t changed = diagonal + (a[i] == b[j] ? 0 : 1);
            diagonal = row[j + 1];
            row[j + 1] = std::min({changed, row[j] + 1, row[j + 1] + 1});
        }
    }
    return row.back();
}

std::string joined(std::span<const std::string> words) {
    std::string out;
    for (const std::string& word : words) {
        out += (out.empty() ? "" : ", ") + word;
    }
    return out;
}

} // namespace

std::string nearest(std::string_view word, std::span<const std::string> candidates) {
    std::string best;
    std::size_t bestDistance = std::min<std::size_t>(word.size(), 64) / 3 + 1;
    for (const std::string& candidate : candidates) {
        const std::size_t d = distance(word.substr(0, 64), candidate);
        if (d < bestDistance) {
            best = candidate;
            bestDistance = d;
        }
    }
    return best;
}

std::string oneOf(std::string_view word, std::span<const std::string> candidates) {
    if (candidates.empty()) {
        return "nothing here";
    }
    const std::string meant = nearest(word, candidates);
    const std::string all = "one of " + joined(candidates);
    return meant.empty() ? all : "'" + meant + "', or " + all;
}

} // namespace patina
