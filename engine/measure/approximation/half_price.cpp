// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/approximation/half_price.h"

#include "measure/approximation/half_text.h"
#include "measure/approximation/shader_price.h"

namespace patina {
namespace {

using Lines = std::vector<std::size_t>;

/// Prices sets of lines on a family.
class LinePrices {
  public:
    LinePrices(const EvalCase& subject, const HalfReport& report, const GpuFamily& family,
               const std::function<bool()>& isStopped)
        : report_(report), isStopped_(isStopped),
          price_(subject, report.text->source(), report.text->syntax(), family) {}

    /// Returns nothing where the family's compiler does not tell.
    std::vector<std::optional<double>> of(const std::vector<Lines>& sets) {
        std::vector<std::vector<ShaderEdit>> ways;
        for (const Lines& lines : sets) {
            ways.push_back(lines.empty()
                               ? std::vector<ShaderEdit>()
                               : halfEdits(*report_.text, report_.halvedBy(lines), vulkanHalf));
        }
        auto prices = price_.of(ways, isStopped_);
        return price_.note().empty() ? prices : std::vector<std::optional<double>>(sets.size());
    }

    const std::string& note() const { return price_.note(); }

  private:
    const HalfReport& report_;
    const std::function<bool()>& isStopped_;
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
                    const std::function<bool()>& isStopped) {
    LinePrices prices(subject, report, family, isStopped);
    HalfPrice found;
    found.family = &family;
    const auto first = prices.of({{}, report.together});
    found.note = prices.note();
    found.inFloat = first[0];
    found.together = first[1];
    found.cheapest = found.inFloat;
    Lines lines = report.together;
    std::optional<double> cost = found.together;
    while (cost && found.cheapest && !isStopped()) {
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
