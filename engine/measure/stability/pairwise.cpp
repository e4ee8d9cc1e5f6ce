// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/stability/pairwise.h"

#include <algorithm>

namespace patina {
namespace {

using Row = std::vector<std::size_t>;

/// Knows which pairs of choices have not met yet.
class OpenPairs {
  public:
    explicit OpenPairs(std::span<const std::size_t> counts) {
        for (const std::size_t count : counts) {
            starts_.push_back(choices_);
            choices_ += count;
        }
        open_.assign(choices_ * choices_, false);
        for (std::size_t i = 0; i < counts.size(); ++i) {
            for (std::size_t j = i + 1; j < counts.size(); ++j) {
                openAll(i, counts[i], j, counts[j]);
            }
        }
    }

    bool any() const { return left_ > 0; }

    bool isOpen(std::size_t i, std::size_t a, std::size_t j, std::size_t b) const {
        return open_[place(i, a, j, b)];
    }

    void close(std::size_t i, std::size_t a, std::size_t j, std::size_t b) {
        const std::size_t at = place(i, a, j, b);
        left_ -= open_[at] ? 1 : 0;
        open_[at] = false;
    }

    /// Puts the first pair that has not met into the row.
    void placeFirst(Row& row, std::vector<bool>& chosen, std::span<const std::size_t> counts) {
        while (!open_[first_]) {
            ++first_;
        }
        put(first_ / choices_, row, chosen, counts);
        put(first_ % choices_, row, chosen, counts);
    }

  private:
    void openAll(std::size_t i, std::size_t countI, std::size_t j, std::size_t countJ) {
        for (std::size_t a = 0; a < countI; ++a) {
            for (std::size_t b = 0; b < countJ; ++b) {
                open_[place(i, a, j, b)] = true;
            }
        }
        left_ += countI * countJ;
    }

    void put(std::size_t choice, Row& row, std::vector<bool>& chosen,
             std::span<const std::size_t> counts) const {
        std::size_t factor = counts.size() - 1;
        while (starts_[factor] > choice) {
            --factor;
        }
        row[factor] = choice - starts_[factor];
        chosen[factor] = true;
    }

    std::size_t place(std::size_t i, std::size_t a, std::size_t j, std::size_t b) const {
        const std::size_t first = starts_[i] + a;
        const std::size_t second = starts_[j] + b;
        return std::min(first, second) * choices_ + std::max(first, second);
    }

    std::vector<std::size_t> starts_;
    std::size_t choices_ = 0;
    std::vector<bool> open_;
    std::size_t left_ = 0;
    std::size_t first_ = 0;
};

/// Returns the choice of factor i that meets the most new partners among the factors already
/// chosen. `turn` makes ties go to different choices in different rows.
std::size_t bestChoice(const OpenPairs& open, const Row& row, const std::vector<bool>& chosen,
                       std::size_t i, std::size_t count, std::size_t turn) {
    std::size_t best = turn % count;
    std::size_t maxMet = 0;
    for (std::size_t k = 0; k < count; ++k) {
        const std::size_t a = (turn + k) % count;
        std::size_t met = 0;
        for (std::size_t j = 0; j < row.size(); ++j) {
            met += chosen[j] && j != i && open.isOpen(i, a, j, row[j]) ? 1U : 0U;
        }
        if (met > maxMet) {
            maxMet = met;
            best = a;
        }
    }
    return best;
}

void closeRow(OpenPairs& open, const Row& row) {
    for (std::size_t i = 0; i < row.size(); ++i) {
        for (std::size_t j = i + 1; j < row.size(); ++j) {
            open.close(i, row[i], j, row[j]);
        }
    }
}

} // namespace

// Each row begins with a pair that has not met and chooses the other factors greedily, as in Cohen,
// Dalal, Fredman and Patton, The AETG System, IEEE TSE 23(7), 1997, with one candidate per row.
std::vector<Row> pairwiseRows(std::span<const std::size_t> counts) {
    std::vector<Row> rows{Row(counts.size(), 0)};
    OpenPairs open(counts);
    closeRow(open, rows.front());
    if (counts.size() == 1) {
        for (std::size_t a = 1; a < counts.front(); ++a) {
            rows.push_back({a});
        }
    }
    while (open.any()) {
        Row row(counts.size(), 0);
        std::vector<bool> chosen(counts.size(), false);
        open.placeFirst(row, chosen, counts);
        for (std::size_t i = 0; i < counts.size(); ++i) {
            if (!chosen[i]) {
                row[i] = bestChoice(open, row, chosen, i, counts[i], rows.size());
                chosen[i] = true;
            }
        }
        closeRow(open, row);
        rows.push_back(std::move(row));
    }
    return rows;
}

} // namespace patina
