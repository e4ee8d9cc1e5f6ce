// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/display_number.h"

#include <algorithm>
#include <cmath>

#include <QCoreApplication>

namespace patina {
namespace {

constexpr int digits = 3;
constexpr int maxPlaces = 9;

/// A share below this is written as "under" this one, without digits of its own.
constexpr double minShare = 1e-7;

QString tr(const char* text) {
    return QCoreApplication::translate("NumberText", text);
}

/// Returns a number with two digits that count: "17", "0.031", "0.00001".
QString twoDigits(double number) {
    constexpr double minWhole = 9.95; // above it whole numbers have as many
    if (number >= minWhole) {
        return numberLocale().toString(number, 'f', 0);
    }
    constexpr double minPlain = 1e-4; // below it an exponent would be written
    if (number >= minPlain || number <= 0.0) {
        return numberLocale().toString(number, 'g', 2);
    }
    const int places = 1 - static_cast<int>(std::floor(std::log10(number)));
    QString text = numberLocale().toString(number, 'f', places);
    return text.endsWith('0') ? text.chopped(1) : text;
}

/// Returns how many digits after the point make `digits` of the number count.
int placesOf(double number) {
    if (number == 0.0 || !std::isfinite(number)) {
        return 0;
    }
    const int before = static_cast<int>(std::floor(std::log10(std::abs(number)))) + 1;
    return std::clamp(digits - before, 0, maxPlaces);
}

} // namespace

QString wholeText(std::size_t number) {
    return numberLocale().toString(static_cast<qulonglong>(number));
}

QString digitsText(double number) {
    return likeText(number, number);
}

QString likeText(double number, double other) {
    return numberLocale().toString(number, 'f', placesOf(other));
}

QString roundText(double number) {
    QString text = digitsText(number);
    const QString point = numberLocale().decimalPoint();
    if (text.contains(point)) {
        while (text.endsWith('0')) {
            text.chop(1);
        }
        if (text.endsWith(point)) {
            text.chop(point.size());
        }
    }
    return text;
}

QString shortText(double number) {
    constexpr double thousand = 1e3;
    constexpr double million = 1e6;
    if (number >= million) {
        return tr("%1 M").arg(roundText(number / million));
    }
    return number >= thousand ? tr("%1 k").arg(roundText(number / thousand)) : roundText(number);
}

QString shareText(double share) {
    if (share > 0.0 && share < minShare) {
        return tr("under %1 %").arg(twoDigits(100.0 * minShare));
    }
    return tr("%1 %").arg(twoDigits(100.0 * share));
}

} // namespace patina
