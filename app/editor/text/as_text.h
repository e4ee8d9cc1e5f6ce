// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include <QString>

namespace patina {

/// Converts the engine's text, which is UTF-8.
inline QString asText(const std::string& text) {
    return QString::fromStdString(text);
}

} // namespace patina
