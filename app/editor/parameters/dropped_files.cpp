// SPDX-License-Identifier: GPL-3.0-or-later
#include "parameters/dropped_files.h"

#include <QDragEnterEvent>
#include <QMimeData>
#include <QUrl>

namespace patina {

QStringList draggedFiles(const QMimeData& data) {
    QStringList files;
    for (const QUrl& url : data.urls()) {
        if (url.isLocalFile()) {
            files << url.toLocalFile();
        }
    }
    return files;
}

void acceptCopy(QDropEvent& event) {
    event.setDropAction(Qt::CopyAction);
    event.accept();
}

void acceptFiles(QDragEnterEvent& event) {
    if (event.mimeData()->hasUrls()) {
        acceptCopy(event);
    }
}

} // namespace patina
