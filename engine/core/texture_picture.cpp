// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/texture_picture.h"

namespace patina {

std::size_t texelBytes(TexelFormat format) {
    switch (format) {
    case TexelFormat::Grey8:
        return 1;
    case TexelFormat::Color32:
        return 16;
    default:
        return 4;
    }
}

} // namespace patina
