// SPDX-License-Identifier: GPL-3.0-or-later
#include "docks/prediction_text.h"

#include <QCoreApplication>

#include "text/as_text.h"
#include "text/display_number.h"

namespace patina {
namespace {

class Prediction {
    Q_DECLARE_TR_FUNCTIONS(Prediction)
};

const StageStatistics* stageOf(const Result<FamilyStatistics>& statistics,
                               const GpuFamily& family) {
    if (!statistics) {
        return nullptr;
    }
    const auto found = statistics->find(family.id);
    return found == statistics->end() ? nullptr : &found->second.fragment;
}

QString cardText(const StageStatistics& stage, const GpuFamily& family, const GraphicsCard& card) {
    return Prediction::tr("%1: %2 ms at 1080p")
        .arg(asText(card.name),
             digitsText(predictedMilliseconds(stage.cycles, fullHdPixels, family, card)));
}

QString stageText(const StageStatistics& stage, const GpuFamily& family) {
    if (family.isMali) {
        return Prediction::tr("Predicted for %1: %2 work registers")
            .arg(asText(family.label))
            .arg(stage.vectorRegisters);
    }
    return Prediction::tr("Predicted for %1: %2 instructions, %3 vector registers, %4 waves on a "
                          "SIMD unit")
        .arg(asText(family.label))
        .arg(stage.instructions)
        .arg(stage.vectorRegisters)
        .arg(stage.waves);
}

QString loopsText(const StageStatistics& stage, const GpuFamily& family) {
    return family.isMali ? Prediction::tr("It has loops, of which each instruction counts once")
                         : Prediction::tr("Loops: %1, each taken to run 8 times").arg(stage.loops);
}

} // namespace

QString predictedCyclesText(const Result<FamilyStatistics>& statistics, const GpuFamily& family) {
    const StageStatistics* stage = stageOf(statistics, family);
    return stage != nullptr ? numberLocale().toString(stage->cycles, 'f', 0) : QStringLiteral("–");
}

double predictedCycles(const Result<FamilyStatistics>& statistics, const GpuFamily& family) {
    const StageStatistics* stage = stageOf(statistics, family);
    return stage != nullptr ? stage->cycles : -1.0;
}

QString predictionNote(const Result<FamilyStatistics>& statistics, const GpuFamily& family) {
    if (!statistics) {
        return asText(statistics.error().text());
    }
    const StageStatistics* stage = stageOf(statistics, family);
    if (stage == nullptr) {
        return {};
    }
    QStringList lines{stageText(*stage, family)};
    if (stage->spilledRegisters > 0) {
        lines += Prediction::tr("%1 registers did not fit").arg(stage->spilledRegisters);
    }
    if (stage->loops > 0) {
        lines += loopsText(*stage, family);
    }
    if (stage->countedRounds > 0.0) {
        lines += Prediction::tr("Loops that run for each pixel as often as it needs: %1 rounds on "
                                "the mean of 256 pairs of directions, counted")
                     .arg(stage->countedRounds, 0, 'f', 0);
    }
    for (const GraphicsCard& card : family.cards) {
        lines += cardText(*stage, family, card);
    }
    return (lines << Prediction::tr("Left out: %1").arg(leftOutOfPrediction)).join('\n');
}

QString predictionHint(const GpuFamily& family) {
    const QString cycles =
        family.isMali ? Prediction::tr("Cycles of a core for 64 pixels on %1, predicted by "
                                       "malioc without such a device. Left out: %2")
                      : Prediction::tr("Cycles of a SIMD unit for 64 pixels on %1, "
                                       "predicted by Mesa's compiler without such a card. "
                                       "Left out: %2");
    return cycles.arg(asText(family.label), QString::fromUtf8(leftOutOfPrediction));
}

} // namespace patina
