// SPDX-License-Identifier: GPL-3.0-or-later
// Writes measured numbers as people read them, never with an exponent, and as the fields of the
// window write theirs: with a point in every language, as what is typed may have either mark.
#pragma once

#include <cstddef>

#include <QLocale>
#include <QString>

namespace patina {

/// Returns how the window writes numbers, in every language.
inline QLocale numberLocale() {
    return QLocale::c();
}

/// Returns all digits of a whole number.
QString wholeText(std::size_t number);

/// Returns a number with three digits that count, and all of those before the point: "23.4",
/// "0.0317", "9346".
QString digitsText(double number);

/// Writes as many digits after the point as digitsText() gives another number.
QString likeText(double number, double other);

/// Returns the digits of digitsText() without zeros that say nothing: "2", "0.5".
QString roundText(double number);

/// Returns large numbers in short: "2.5 k", "50 k", "1 M"; below a thousand as roundText().
QString shortText(double number);

/// Returns a share in per cent, such as "0.39 %", with as many digits as tell something.
QString shareText(double share);

} // namespace patina
