// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/mixed_color.h"

#include <cmath>

namespace patina {

QColor mixed(const QColor& a, const QColor& b, double share) {
    const auto part = [share](int x, int y) {
        return static_cast<int>(std::lround((1.0 - share) * x + share * y));
    };
    return {part(a.red(), b.red()), part(a.green(), b.green()), part(a.blue(), b.blue())};
}

} // namespace patina
