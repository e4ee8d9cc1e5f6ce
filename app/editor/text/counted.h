// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include <QString>

namespace patina {

/// Returns `one` for a single thing, and else `several` with the number in place of %1.
inline QString counted(std::size_t count, const QString& one, const QString& several) {
    return count == 1 ? one : several.arg(count);
}

} // namespace patina
