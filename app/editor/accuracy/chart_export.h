// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QString>
#include <QWidget>

#include "core/error.h"

namespace patina {

/// Asks for a file with the given ending ("csv") and returns it, or an empty text.
QString askForChartFile(QWidget* parent, const QString& ending);

/// Writes all of it or nothing.
Result<void> writeWhole(const QString& file, const QByteArray& bytes);

} // namespace patina
