// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QStringList>

class QDragEnterEvent;
class QDropEvent;
class QMimeData;

namespace patina {

/// Returns the local files that are dragged; none for anything else.
QStringList draggedFiles(const QMimeData& data);

/// Accepts what is dragged as a copy, whatever its source proposed: some delete what was moved.
void acceptCopy(QDropEvent& event);

/// Accepts whatever names files, also those that are not local.
void acceptFiles(QDragEnterEvent& event);

} // namespace patina
