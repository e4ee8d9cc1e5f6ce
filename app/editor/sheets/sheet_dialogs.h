// SPDX-License-Identifier: GPL-3.0-or-later
// Where sheets are read from and written to; each returns a file, or an empty text.
#pragma once

#include <QString>

class QWidget;

namespace patina {

class Session;

QString askForSheet(QWidget* parent, Session& session);

/// `name`: of the file that is offered, without its ending, as in the next.
QString askWhereToSaveSheet(QWidget* parent, Session& session, const QString& name);

/// Tells a picture from a table of numbers.
QString askWhereToExportSheet(QWidget* parent, Session& session, const QString& name);

} // namespace patina
