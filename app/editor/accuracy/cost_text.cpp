// SPDX-License-Identifier: GPL-3.0-or-later
#include "accuracy/cost_text.h"

#include <QCoreApplication>
#include <QLocale>
#include <QStringList>

namespace patina {
namespace {

QString tr(const char* text) {
    return QCoreApplication::translate("CostText", text);
}

QString asText(const std::string& text) {
    return QString::fromStdString(text);
}

/// A level that a point takes, with its choice; null where the chart does not know it.
struct TakenLevel {
    const Choice* choice = nullptr;
    const ChoiceLevel* level = nullptr;
};

std::vector<TakenLevel> takenLevels(const CostPoint& point, const CostChart& chart) {
    std::vector<TakenLevel> taken;
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

/// "Half" says nothing without what it is half of.
QString levelName(const TakenLevel& taken) {
    return QStringLiteral("%1: %2").arg(asText(taken.choice->label), asText(taken.level->label));
}

QString timeLine(const ChoiceCost& cost) {
    const QString time = digitsText(cost.nanosecondsPerPixel);
    const QString ratio = digitsText(cost.ratio.median);
    if (cost.belowNoise) {
        return tr("At most %1 ns per pixel, %2 of the exact time").arg(time, ratio);
    }
    if (!cost.isSure()) {
        return tr("%1 ns per pixel, %2 of the exact time, by too few pairs of frames to tell")
            .arg(time, ratio);
    }
    return tr("%1 ns per pixel, %2 of the exact time (%3 to %4)")
        .arg(time, ratio, digitsText(cost.ratio.lower), digitsText(cost.ratio.upper));
}

} // namespace

QString wayName(const CostPoint& point, const CostChart& chart) {
    QStringList names;
    for (const TakenLevel& taken : takenLevels(point, chart)) {
        names << levelName(taken);
    }
    return names.isEmpty() ? tr("Exact") : names.join(QStringLiteral(" + "));
}

QString wayDescription(const CostPoint& point, const CostChart& chart) {
    QStringList lines;
    for (const TakenLevel& taken : takenLevels(point, chart)) {
        lines << QStringLiteral("%1. %2").arg(levelName(taken), asText(taken.level->doc));
    }
    return lines.isEmpty() ? tr("Every choice is exact.") : lines.join('\n');
}

QString ratioText(const MedianInterval& ratio) {
    if (ratio.upper - ratio.lower > 2.0 * ratio.median) {
        return QStringLiteral("%1 ± ?").arg(digitsText(ratio.median));
    }
    return QStringLiteral("%1 ± %2").arg(
        digitsText(ratio.median), likeText(0.5 * (ratio.upper - ratio.lower), ratio.median));
}

QString costRatioText(const ChoiceCost& cost) {
    if (cost.belowNoise) {
        return QStringLiteral("< %1").arg(digitsText(cost.ratio.median));
    }
    return cost.isSure() ? ratioText(cost.ratio)
                         : QStringLiteral("%1 ± ?").arg(digitsText(cost.ratio.median));
}

QString countText(const std::optional<InstructionCount>& count) {
    return count ? QLocale().toString(count->total()) : QStringLiteral("–");
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

QString tieText(const CostPoint& point, const CostChart& chart) {
    constexpr int most = 4;
    QStringList names;
    int more = 0;
    for (const std::size_t other : tiesOf(chart.points, point)) {
        if (names.size() < most) {
            names << wayName(chart.points[other], chart);
        } else {
            ++more;
        }
    }
    if (names.isEmpty()) {
        return {};
    }
    const QString text = tr("Cannot be told from: %1").arg(names.join(QStringLiteral("; ")));
    return more > 0 ? tr("%1 and %2 more").arg(text).arg(more) : text;
}

QString convergedNote(const CostChart& chart) {
    return tr("Against a converged render of %1 other directions, which is right to %2")
        .arg(chart.converged->directions)
        .arg(shareText(chart.converged->noise.p99));
}

QString pointText(const CostPoint& point, const CostChart& chart) {
    QStringList lines{wayName(point, chart)};
    lines << timeLine(point.cost);
    lines << tr("99 of 100 pixels are off by %1 or less, the worst by %2")
                 .arg(shareText(point.error.p99), shareText(point.error.max));
    if (chart.isAgainstConverged(point)) {
        lines << convergedNote(chart);
    }
    lines << tr("%1 of the pixels differ on the screen").arg(shareText(point.error.stepShare));
    if (const QString ties = tieText(point, chart); !ties.isEmpty()) {
        lines << ties;
    }
    return lines.join('\n');
}

QString staleText() {
    return tr("It can still be chosen, but its numbers are from before a change.");
}

QString methodText(const CostChart& chart) {
    const QString method = tr("%1 × %2 pixels, %3 of them shaded; %4; errors against %5.")
                               .arg(chart.size.x)
                               .arg(chart.size.y)
                               .arg(QLocale().toString(static_cast<qulonglong>(chart.pixels)))
                               .arg(asText(chart.timer), asText(chart.right));
    QStringList lines{method};
    for (const std::string& more : {convergedText(chart), sameText(chart)}) {
        if (!more.empty()) {
            lines << QStringLiteral("%1%2.").arg(asText(more).left(1).toUpper(),
                                                 asText(more).mid(1));
        }
    }
    return lines.join(' ');
}

} // namespace patina
