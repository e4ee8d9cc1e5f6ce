// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/approximation/half_price.h"

#include <algorithm>
#include <bit>
#include <iterator>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include "measure/approximation/half_text.h"
#include "measure/approximation/shader_price.h"

namespace patina {
namespace {

using Lines = std::vector<std::size_t>;

/// Returns how many rounds halve a number of lines down to one.
std::size_t halvings(std::size_t lines) {
    return static_cast<std::size_t>(std::bit_width(lines));
}

/// Prices sets of lines on a family, each of them once.
class LinePrices {
  public:
    LinePrices(const EvalCase& subject, const HalfReport& report, const GpuFamily& family,
               const HalfProgress& progress)
        : report_(report), progress_(progress),
          price_(subject, report.text->source(), report.text->syntax(), family) {}

    /// Prices those of the sets that are not priced yet.
    void price(const std::vector<Lines>& sets) {
        std::set<Lines> open;
        std::ranges::copy_if(sets, std::inserter(open, open.end()),
                             [this](const Lines& lines) { return !costs_.contains(lines); });
        std::vector<std::vector<ShaderEdit>> ways;
        for (const Lines& lines : open) {
            ways.push_back(lines.empty()
                               ? std::vector<ShaderEdit>()
                               : halfEdits(*report_.text, report_.halvedBy(lines), vulkanHalf));
        }
        const auto prices = price_.of(ways, [this] { return isEnded(); });
        std::size_t next = 0;
        for (const Lines& lines : open) {
            costs_[lines] = price_.note().empty() ? prices[next] : std::nullopt;
            ++next;
        }
    }

    /// Returns nothing where the family's compiler does not tell, or the set was not priced.
    std::optional<double> of(const Lines& lines) const {
        const auto found = costs_.find(lines);
        return found == costs_.end() ? std::nullopt : found->second;
    }

    /// Returns the set of those priced that costs least, of these with the fewest lines.
    const Lines& cheapest() const {
        const auto rank = [](const auto& each) {
            return std::pair(each.second.value_or(endless), each.first.size());
        };
        return std::ranges::min_element(costs_, {}, rank)->first;
    }

    /// Tells how much of all is priced, where each round of halvedSets() leaves one line out.
    bool isEnded() const {
        const std::size_t lines = report_.together.size();
        const double maxSets = 2.0 + double(lines) * double(4 + halvings(lines));
        return !progress_(std::min(double(costs_.size()) / maxSets, 1.0));
    }

    const std::string& note() const { return price_.note(); }

  private:
    static constexpr double endless = std::numeric_limits<double>::infinity();

    const HalfReport& report_;
    const HalfProgress& progress_;
    std::map<Lines, std::optional<double>> costs_;
    ShaderPrice price_;
};

/// Returns a half of the lines, a quarter and so on to each by itself, and all but these: four sets
/// for each line at most.
std::vector<Lines> halvedSets(const Lines& lines) {
    std::vector<Lines> sets;
    for (std::size_t size = (lines.size() + 1) / 2; size > 0;
         size = size > 1 ? (size + 1) / 2 : 0) {
        for (std::size_t first = 0; first < lines.size(); first += size) {
            const auto begin = lines.begin() + std::ptrdiff_t(first);
            const auto end = lines.begin() + std::ptrdiff_t(std::min(first + size, lines.size()));
            sets.emplace_back(begin, end);
            sets.emplace_back(lines.begin(), begin);
            sets.back().insert(sets.back().end(), end, lines.end());
        }
    }
    return sets;
}

/// Returns the sets that have one line less.
std::vector<Lines> setsWithoutOne(const Lines& lines) {
    std::vector<Lines> sets;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        sets.push_back(lines);
        sets.back().erase(sets.back().begin() + std::ptrdiff_t(i));
    }
    return sets;
}

} // namespace

HalfPrice halfPrice(const EvalCase& subject, const HalfReport& report, const GpuFamily& family,
                    const HalfProgress& progress) {
    LinePrices prices(subject, report, family, progress);
    prices.price({{}, report.together});
    HalfPrice found;
    found.family = &family;
    found.note = prices.note();
    found.inFloat = prices.of({});
    found.together = prices.of(report.together);
    if (found.inFloat && found.together) {
        prices.price(halvedSets(report.together));
        for (std::size_t round = 0; round < halvings(report.together.size()); ++round) {
            const Lines before = prices.cheapest();
            if (before.empty() || prices.isEnded()) {
                break;
            }
            prices.price(setsWithoutOne(before));
            if (prices.cheapest() == before) {
                break;
            }
        }
    }
    found.lines = prices.cheapest();
    found.cheapest = prices.of(found.lines);
    found.error = report.errorOf(report.halvedBy(found.lines));
    return found;
}

} // namespace patina
