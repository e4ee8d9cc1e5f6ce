// SPDX-License-Identifier: GPL-3.0-or-later
#include "catalog/suggestion.h"

#include <algorithm>
#include <numeric>
#include <vector>

namespace patina {
namespace {

/// Returns Damerau's distance (1964) in its restricted form: the smallest number of letters to add,
/// drop or change, or of neighbours to exchange.
std::size_t distance(std::string_view a, std::string_view b) {
    std::vector<std::vector<std::size_t>> d(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
    for (std::size_t i = 0; i <= a.size(); ++i) {
        d[i][0] = i;
    }
    std::iota(d[0].begin(), d[0].end(), std::size_t{0});
    for (std::size_t i = 1; i <= a.size(); ++i) {
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t changed = d[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
            d[i][j] = std::min({changed, d[i - 1][j] + 1, d[i][j - 1] + 1});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1]) {
                d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
            }
        }
    }
    return d[a.size()][b.size()];
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
    word = word.substr(0, 64); // nobody misspells a longer one
    std::size_t bestDistance = word.size() / 3 + 1;
    for (const std::string& candidate : candidates) {
        const std::size_t apart = word.size() < candidate.size() ? candidate.size() - word.size()
                                                                 : word.size() - candidate.size();
        if (apart >= bestDistance) {
            continue; // so many letters have to be added at least
        }
        const std::size_t d = distance(word, candidate);
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
