// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QImage>

namespace patina {

/// Returns a picture as PNG; empty where it cannot be written so. `quality` is QImage::save()'s:
/// 100 is large and quick.
QByteArray asPng(const QImage& picture, int quality = -1);

} // namespace patina
