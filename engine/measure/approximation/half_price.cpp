// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/approximation/half_price.h"

#include <algorithm>

#include "measure/approximation/half_text.h"
#include "measure/approximation/shader_price.h"

namespace patina {
namespace {

using Lines = std::vector<std::size_t>;

/// Prices sets of lines on a family.
class LinePrices {
  public:
    LinePrices(const EvalCase& subject, const HalfReport& report, const GpuFamily& family,
               const HalfProgress& progress)
        : report_(report), progress_(progress),
          price_(subject, report.text->source(), report.text->syntax(), family) {}

    /// Returns nothing where the family's compiler does not tell.
    std::vector<std::optional<double>> of(const std::vector<Lines>& sets) {
        std::vector<std::vector<ShaderEdit>> ways;
        for (const Lines& lines : sets) {
            ways.push_back(lines.empty()
                               ? std::vector<ShaderEdit>()
                               : halfEdits(*report_.text, report_.halvedBy(lines), vulkanHalf));
        }
        auto prices = price_.of(ways, [this] { return isEnded(); });
        priced_ += sets.size();
        return price_.note().empty() ? prices : std::vector<std::optional<double>>(sets.size());
    }

    /// Tells how much of all is priced, as if lines were left out one after the other to the last.
    bool isEnded() const {
        const double lines = double(report_.together.size());
        return !progress_(std::min(double(priced_) / (2.0 + lines * (lines + 1.0) / 2.0), 1.0));
    }

    const std::string& note() const { return price_.note(); }

  private:
    const HalfReport& report_;
    const HalfProgress& progress_;
    std::size_t priced_ = 0;
    ShaderPrice price_;
};

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
    HalfPrice found;
    found.family = &family;
    const auto first = prices.of({{}, report.together});
    found.note = prices.note();
    found.inFloat = first[0];
    found.together = first[1];
    found.cheapest = found.inFloat;
    Lines lines = report.together;
    std::optional<double> cost = found.together;
    while (cost && found.cheapest && !prices.isEnded()) {
        if (*cost < *found.cheapest) {
            found.cheapest = cost;
            found.lines = lines;
        }
        const std::vector<Lines> fewer = setsWithoutOne(lines);
        const auto costs =
            lines.size() > 1 ? prices.of(fewer) : std::vector<std::optional<double>>();
        cost.reset();
        for (std::size_t i = 0; i < costs.size(); ++i) {
            if (costs[i] && (!cost || *costs[i] < *cost)) {
                cost = costs[i];
                lines = fewer[i];
            }
        }
    }
    found.error = report.errorOf(report.halvedBy(found.lines));
    return found;
}

} // namespace patina
