// SPDX-License-Identifier: GPL-3.0-or-later
#include "text/short_text.h"

namespace patina {

QString shortened(const QString& name, int maxLength) {
    if (name.size() <= maxLength) {
        return name;
    }
    const int end = maxLength / 4;
    return name.left(maxLength - end - 1) + QStringLiteral("…") + name.right(end);
}

} // namespace patina
