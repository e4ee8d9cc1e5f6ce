// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/short_text.h"

namespace patina {

QString shortened(const QString& name, int most) {
    if (name.size() <= most) {
        return name;
    }
    const int end = most / 4;
    return name.left(most - end - 1) + QStringLiteral("…") + name.right(end);
}

} // namespace patina
