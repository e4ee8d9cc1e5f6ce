// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/comparison_text.h"

#include <algorithm>
#include <cmath>

#include <QCoreApplication>
#include <QStringList>

#include "text/display_number.h"

namespace patina {
namespace {

/// Times that differ by a smaller share are called the same.
constexpr double sameTime = 0.01;
/// From this ratio on "times as long" is easier to read than "more".
constexpr double severalTimes = 2.0;

QString numbersText(const char* text) {
    return QCoreApplication::translate("Comparison", text);
}

QString wholePercent(double share) {
    return QStringLiteral("%1 %").arg(std::lround(100.0 * share));
}

QString timeText(const TimeRatio& time) {
    const double ratio = time.ratio.median;
    if (time.ratio.contains(1.0) || std::abs(ratio - 1.0) < sameTime) {
        return numbersText("takes as long");
    }
    if (ratio >= severalTimes) {
        return numbersText("takes %1 times as long").arg(roundText(ratio));
    }
    return ratio < 1.0 ? numbersText("takes %1 less time").arg(wholePercent(1.0 - ratio))
                       : numbersText("takes %1 more time").arg(wholePercent(ratio - 1.0));
}

QString distanceText(const PictureDistance& distance) {
    return distance.flip == 0.0 ? numbersText("looks the same")
                                : numbersText("is FLIP %1 away").arg(digitsText(distance.flip));
}

QString colorText(const Image& image, std::size_t pixel) {
    QStringList parts;
    for (std::size_t channel = 0; channel < 3; ++channel) {
        parts << digitsText(double(image.pixels[std::size_t(image.channels) * pixel + channel]));
    }
    return parts.join(' ');
}

} // namespace

QString comparisonText(const ComparisonNumbers& numbers) {
    if (!numbers.distance) {
        return {};
    }
    const QString distance = distanceText(*numbers.distance);
    const QString letter = letterOf(numbers.other);
    return numbers.time ? numbersText("%1 %2 and %3").arg(letter, timeText(*numbers.time), distance)
                        : numbersText("%1 %2").arg(letter, distance);
}

QString comparisonDetails(const ComparisonNumbers& numbers) {
    QStringList lines;
    if (const auto& distance = numbers.distance) {
        lines << numbersText(
                     "%4's error relative to A, in linear light: at most %1, 99 % of the pixels "
                     "below %2, mean %3")
                     .arg(shareText(distance->largest), shareText(distance->percentile99),
                          shareText(distance->mean), letterOf(numbers.other))
              << numbersText("FLIP %1, SSIM %2 (means of what displays show)")
                     .arg(digitsText(distance->flip),
                          numberLocale().toString(distance->similarity, 'f', 4));
    }
    if (const auto& time = numbers.time) {
        lines << numbersText("%5's frame takes %1 of A's time (%2 to %3, of %4 pairs in turns)")
                     .arg(shareText(time->ratio.median), shareText(time->ratio.lower),
                          shareText(time->ratio.upper))
                     .arg(time->pairs)
                     .arg(letterOf(numbers.other));
    }
    return lines.join('\n');
}

QString pixelText(const ComparedFrames& frames, Side other, const QPointF& place) {
    const auto at = [](double share, int count) {
        return std::clamp(static_cast<int>(share * count), 0, count - 1);
    };
    const int x = at(place.x(), frames.a.width);
    const int y = at(place.y(), frames.a.height);
    const std::size_t pixel = std::size_t(y) * std::size_t(frames.a.width) + std::size_t(x);
    return numbersText("A %1   %4 %2   %3 apart")
        .arg(colorText(frames.a, pixel), colorText(frames.b, pixel),
             shareText(double(frames.difference.relative[pixel])), letterOf(other));
}

} // namespace patina
