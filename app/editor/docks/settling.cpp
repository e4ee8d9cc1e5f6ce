// SPDX-License-Identifier: GPL-3.0-or-later
#include "docks/settling.h"

#include <QTimer>

#include "document/document.h"
#include "resources/mesh_library.h"

namespace patina {

void startWhenChanged(QTimer& settle, const Document& document, const MeshLibrary& meshes) {
    const auto later = [&settle] {
        if (!settle.isActive()) {
            settle.start();
        }
    };
    onChange(document, DocumentChange::Drawn | DocumentChange::Current, &settle, later);
    QObject::connect(&meshes, &MeshLibrary::loaded, &settle, later);
    QObject::connect(&meshes, &MeshLibrary::opennessFound, &settle, later);
}

} // namespace patina
