// SPDX-License-Identifier: GPL-3.0-or-later
#include "accuracy/cost_text.h"

#include <cmath>

#include <QCoreApplication>
#include <QStringList>

#include "text/as_text.h"
#include "text/display_number.h"

namespace patina {
namespace {

QString tr(const char* text) {
    return QCoreApplication::translate("CostText", text);
}

/// Holds a level that a point takes, with its choice; both point into the chart.
struct ChosenLevel {
    const Choice* choice = nullptr;
    const ChoiceLevel* level = nullptr;
};

std::vector<ChosenLevel> chosenLevels(const CostPoint& point, const CostChart& chart) {
    std::vector<ChosenLevel> taken;
    for (const Choice& choice : chart.choices) {
        const auto found = point.levels.find(choice.id);
        const ChoiceLevel* level =
            found == point.levels.end() ? nullptr : choice.level(found->second);
        if (level != nullptr) {
            taken.push_back({&choice, level});
        }
    }
    return taken;
}

QString timeLine(const ChoiceCost& cost, RatioBound bound) {
    const QString time = digitsText(cost.nanosecondsPerPixel);
    const QString ratio = digitsText(cost.ratio.median);
    switch (bound) {
    case RatioBound::AtMost:
        return tr("At most %1 ns per pixel, %2 of the exact time: too little to tell it from none")
            .arg(time, ratio);
    case RatioBound::AtLeast:
        return tr("%1 ns per pixel, at least %2 times the exact time").arg(time, ratio);
    case RatioBound::Unknown:
        return tr("At most %1 ns per pixel: too little to tell it from none").arg(time);
    default:
        break;
    }
    if (cost.runs == 0) {
        return tr("%1 ns per pixel, %2 of the exact time, predicted").arg(time, ratio);
    }
    if (!cost.isSure()) {
        return tr("%1 ns per pixel, %2 of the exact time, by too few pairs of frames to tell")
            .arg(time, ratio);
    }
    return tr("%1 ns per pixel, %2 of the exact time (%3 to %4)")
        .arg(time, ratio, digitsText(cost.ratio.lower), digitsText(cost.ratio.upper));
}

QString workText(const SweepStep& step, const CostChart& chart) {
    switch (step.work) {
    case SweepStep::Work::GroundTruthFrame:
        return tr("the ground truth");
    case SweepStep::Work::ConvergedFrame:
        return tr("a converged picture");
    case SweepStep::Work::EmptyFrame:
        return tr("an empty picture");
    default:
        return settingName({step.levels, {}, {}, {}}, chart);
    }
}

/// Writes a ratio, or a time that is as sure as the ratio, with its interval if that is known.
QString asSure(const MedianInterval& interval, const ChoiceCost& cost) {
    if (cost.runs == 0) { // it is predicted
        return digitsText(interval.median);
    }
    return cost.isSure() ? ratioText(interval)
                         : QStringLiteral("%1 ± ?").arg(digitsText(interval.median));
}

} // namespace

/// Names each level with its choice: "Half" alone does not say what is halved.
std::vector<SettingPart> settingParts(const CostPoint& point, const CostChart& chart) {
    std::vector<SettingPart> parts;
    for (const ChosenLevel& taken : chosenLevels(point, chart)) {
        parts.push_back({asText(taken.choice->label), asText(taken.level->label)});
    }
    return parts;
}

QString settingName(const CostPoint& point, const CostChart& chart) {
    const std::vector<SettingPart> parts = settingParts(point, chart);
    return parts.empty() ? tr("Exact") : settingText(parts);
}

QString settingDescription(const CostPoint& point, const CostChart& chart) {
    QStringList lines;
    for (const ChosenLevel& taken : chosenLevels(point, chart)) {
        lines << QStringLiteral("%1: %2. %3")
                     .arg(asText(taken.choice->label), asText(taken.level->label),
                          asText(taken.level->doc));
    }
    return lines.isEmpty() ? tr("Every choice is exact.") : lines.join('\n');
}

QString ratioText(const MedianInterval& ratio) {
    if (ratio.upper - ratio.lower > 2.0 * ratio.median) {
        return QStringLiteral("%1 ± ?").arg(digitsText(ratio.median));
    }
    return QStringLiteral("%1 ± %2").arg(digitsText(ratio.median),
                                         likeText(0.5 * (ratio.upper - ratio.lower), ratio.median));
}

QString costRatioText(const ChoiceCost& cost, RatioBound bound) {
    switch (bound) {
    case RatioBound::AtMost:
        return QStringLiteral("< %1").arg(digitsText(cost.ratio.median));
    case RatioBound::AtLeast:
        return QStringLiteral("> %1").arg(digitsText(cost.ratio.median));
    case RatioBound::Unknown:
        return QStringLiteral("–");
    default:
        return asSure(cost.ratio, cost);
    }
}

QString ratioNote(const ChoiceCost& cost, RatioBound bound) {
    const QString ratio = digitsText(cost.ratio.median);
    switch (bound) {
    case RatioBound::AtMost:
        return tr("No more than %1: its time cannot be told from none").arg(ratio);
    case RatioBound::AtLeast:
        return tr("No less than %1: the time that it counts from cannot be told from none")
            .arg(ratio);
    case RatioBound::Unknown:
        return tr("Neither its time nor the one that it would count from can be told from none");
    default:
        break;
    }
    if (cost.runs == 0) {
        return tr("Predicted, the same every time");
    }
    return cost.isSure() ? tr("Between %1 and %2 with a probability of 95 %, by %3 pairs of frames")
                               .arg(digitsText(cost.ratio.lower), digitsText(cost.ratio.upper))
                               .arg(cost.runs)
                         : tr("By %1 pairs of frames, which are too few to say how sure it is")
                               .arg(cost.runs);
}

QString perPixelText(const ChoiceCost& cost, bool withInterval) {
    const double time = cost.nanosecondsPerPixel;
    if (cost.belowNoise) {
        return QStringLiteral("< %1").arg(digitsText(time));
    }
    const double each = cost.ratio.median > 0.0 ? time / cost.ratio.median : 0.0;
    return withInterval ? asSure({time, each * cost.ratio.lower, each * cost.ratio.upper}, cost)
                        : digitsText(time);
}

QString countText(const std::optional<InstructionCount>& count) {
    return count ? numberLocale().toString(count->total()) : QStringLiteral("–");
}

QString kindsText(const std::optional<InstructionCount>& count) {
    if (!count) {
        return tr("Its program cannot be counted");
    }
    return QStringList{tr("%1 sums, products, choices").arg(count->arithmetic),
                       tr("%1 divisions, roots, powers, angles").arg(count->transcendental),
                       tr("%1 looks into images").arg(count->texture),
                       tr("%1 branches").arg(count->branch),
                       tr("%1 loads and stores").arg(count->memory)}
        .join('\n');
}

double countOf(const std::optional<InstructionCount>& count) {
    return count ? double(count->total()) : -1.0;
}

QString tieText(const CostPoint& point, const CostChart& chart, Standing standing) {
    constexpr int maxNames = 4;
    QStringList names;
    int more = 0;
    for (const std::size_t other : tiesOf(chart.points, point)) {
        if (names.size() < maxNames) {
            names << settingName(chart.points[other], chart);
        } else {
            ++more;
        }
    }
    QStringList lines;
    if (!names.isEmpty()) {
        const QString text = tr("Cannot be told from: %1").arg(names.join(QStringLiteral("; ")));
        lines << (more > 0 ? tr("%1 and %2 more").arg(text).arg(more) : text);
    }
    if (standing == Standing::Tie) {
        lines << tr("May be worth choosing, too: the difference is within the noise");
    }
    return lines.join('\n');
}

QString convergedNote(const CostChart& chart) {
    return tr("Against a converged render of %1 other directions, which is right to %2")
        .arg(chart.converged->directions)
        .arg(shareText(chart.converged->noise.p99));
}

QString pointText(std::size_t number, const CostChart& chart) {
    const CostPoint& point = chart.points[number];
    QStringList lines{settingName(point, chart)};
    lines << timeLine(point.cost, chart.boundOf(point));
    lines << tr("99 of 100 pixels are off by %1 or less, the worst by %2")
                 .arg(shareText(point.error.p99), shareText(point.error.max));
    if (chart.isAgainstConverged(point)) {
        lines << convergedNote(chart);
    }
    lines << tr("%1 of the pixels differ on the screen").arg(shareText(point.error.stepShare));
    const QString ties = tieText(point, chart, standings(chart.points)[number]);
    if (!ties.isEmpty()) {
        lines << ties;
    }
    return lines.join('\n');
}

QString stepText(const SweepStep& step, const CostChart& chart) {
    if (step.of < 2) { // the steps are not known yet
        return tr("Measuring …");
    }
    const QString text = tr("Measuring, step %1 of %2: %3, %4 %")
                             .arg(step.number)
                             .arg(step.of)
                             .arg(workText(step, chart))
                             .arg(std::lround(100.0 * step.share));
    constexpr double minute = 60.0;
    return step.secondsInAll < 1.5 * minute ? text
                                            : tr("%1. It takes about %2 minutes in all.")
                                                  .arg(text)
                                                  .arg(std::lround(step.secondsInAll / minute));
}

QString staleText() {
    return tr("It can still be chosen, but its numbers are from before a change.");
}

QString methodText(const CostChart& chart) {
    if (!chart.predictedFor.empty()) {
        return tr("%1 × %2 pixels of the object on a %3; %4; errors against %5.")
            .arg(chart.size.x)
            .arg(chart.size.y)
            .arg(asText(chart.predictedFor), asText(chart.timer), asText(chart.groundTruth));
    }
    return tr("%1 × %2 pixels, %3 of them shaded; %4; errors against %5.")
        .arg(chart.size.x)
        .arg(chart.size.y)
        .arg(wholeText(chart.pixels))
        .arg(asText(chart.timer), asText(chart.groundTruth));
}

QString notesText(const CostChart& chart) {
    QStringList lines;
    for (const std::string& more : {leftOutText(chart), convergedText(chart), sameText(chart)}) {
        if (!more.empty()) {
            lines << QStringLiteral("%1%2.").arg(asText(more).left(1).toUpper(),
                                                 asText(more).mid(1));
        }
    }
    return lines.join(' ');
}

} // namespace patina
