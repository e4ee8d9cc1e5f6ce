// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include <QByteArray>
#include <QPaintDevice>
#include <QSize>
#include <QString>

namespace patina {

/// Returns what `paint` draws on a device of the size, as SVG.
QByteArray asSvg(QSize size, const QString& title, const QString& description,
                 const std::function<void(QPaintDevice&)>& paint);

} // namespace patina
