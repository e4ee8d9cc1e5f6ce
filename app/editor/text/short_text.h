// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace patina {

/// Returns a name as it stands in a menu or a line of text: in full up to `maxLength` letters, else
/// its start and its end around "…".
QString shortened(const QString& name, int maxLength = 36);

} // namespace patina
