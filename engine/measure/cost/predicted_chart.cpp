// SPDX-License-Identifier: GPL-3.0-or-later
#include "measure/cost/predicted_chart.h"

#include <optional>

#include <fmt/format.h>

namespace patina {
namespace {

std::optional<double> cyclesOf(const ChosenLevels& levels, const PredictedPoints& predicted,
                               const GpuFamily& family) {
    const PredictedWay* way = predicted.find(levels);
    if (way == nullptr || !way->statistics || !way->statistics->contains(family.id)) {
        return std::nullopt;
    }
    return way->statistics->at(family.id).fragment.cycles;
}

std::string methodOf(const CostChart& chart, const PredictedPoints& predicted,
                     const CardOfFamily& card) {
    return fmt::format("predicted by the compiler of {} for a {} of {} compute units at {:.0f} "
                       "MHz, without {}; errors in a frame of {} x {} pixels",
                       predicted.driver, card.card->name, card.card->computeUnits,
                       card.card->megahertz, leftOutOfPrediction, chart.size.x, chart.size.y);
}

} // namespace

Result<CostChart> predictedChart(const CostChart& chart, const PredictedPoints& predicted,
                                 const CardOfFamily& card, glm::ivec2 size) {
    const std::optional<double> exact = cyclesOf({}, predicted, *card.family);
    if (!exact || !(*exact > 0.0)) {
        return failure(fmt::format("nothing was predicted for {}", card.text()),
                       "another measurement, with the package mesa-vulkan-drivers installed");
    }
    const double pixels = double(size.x) * double(size.y);
    CostChart made = chart;
    made.points.clear();
    for (const CostPoint& point : chart.points) {
        const std::optional<double> cycles = cyclesOf(point.levels, predicted, *card.family);
        if (!cycles) {
            continue;
        }
        CostPoint on = point;
        const double ratio = *cycles / *exact;
        const double milliseconds =
            predictedMilliseconds(*cycles, pixels, *card.family, *card.card);
        on.cost = {};
        on.cost.ratio = {ratio, ratio, ratio};
        on.cost.milliseconds = {milliseconds, milliseconds, milliseconds};
        on.cost.nanosecondsPerPixel = milliseconds * 1e6 / pixels;
        on.cost.settled = true;
        made.points.push_back(std::move(on));
    }
    made.size = size;
    made.pixels = static_cast<std::size_t>(pixels);
    made.exactMilliseconds = made.points.front().cost.milliseconds.median;
    made.emptyMilliseconds = 0.0;
    made.timer = methodOf(chart, predicted, card);
    made.predictedFor = card.text();
    return made;
}

} // namespace patina
