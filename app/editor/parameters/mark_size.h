// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

namespace patina {

/// Returns the size of a mark in a row of the form: a square as high as a line of text.
inline QSize markSize(const QWidget& mark) {
    const int side = mark.fontMetrics().height() + 2;
    return {side, side};
}

} // namespace patina
