// SPDX-License-Identifier: GPL-3.0-or-later
// Asks where sheets are read from and written to. Each function returns a file, or an empty text
// where the dialog was closed without one.
#pragma once

#include <QString>

class QWidget;

namespace patina {

class Session;

QString askForSheet(QWidget* parent, Session& session);

/// `name` is that of the file that is offered, without its ending, as in the next.
QString askWhereToSaveSheet(QWidget* parent, Session& session, const QString& name);

/// Offers a picture (.png, .exr) or a table of numbers (.csv).
QString askWhereToExportSheet(QWidget* parent, Session& session, const QString& name);

} // namespace patina
