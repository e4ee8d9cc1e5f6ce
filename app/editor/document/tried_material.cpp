// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/tried_material.h"

namespace patina {

TriedMaterial::TriedMaterial(Document& document, QObject* parent)
    : QObject(parent), document_(document) {
    DocumentChange::Aspects edits = DocumentChange::Drawn;
    edits.setFlag(DocumentChange::Camera, false);
    onChange(document, edits | DocumentChange::Current, this, &TriedMaterial::end);
}

void TriedMaterial::show(Side side, const Material& material, const QString& what) {
    if (!document_.material(side)) {
        return;
    }
    Scene scene = document_.scene(side);
    scene.objects[static_cast<std::size_t>(document_.selection().object())].material = material;
    shown_ = Shown{side, std::move(scene), what};
    Q_EMIT changed();
}

void TriedMaterial::end() {
    if (shown_) {
        shown_.reset();
        Q_EMIT changed();
    }
}

const Scene* TriedMaterial::scene(Side side) const {
    return shown_ && shown_->side == side ? &shown_->scene : nullptr;
}

} // namespace patina
