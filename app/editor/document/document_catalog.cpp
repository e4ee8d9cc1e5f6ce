// SPDX-License-Identifier: GPL-3.0-or-later
// How a document follows blocks that change while it is open.
#include <utility>

#include "document/document.h"
#include "material/reconciled.h"

namespace patina {

void Document::setCatalog(std::shared_ptr<const Catalog> catalog) {
    const std::shared_ptr<const Catalog> before = std::exchange(catalog_, std::move(catalog));
    accuracyBlocks_.clear();
    for (Object& object : state_.scene.objects) {
        object.material = reconciled(object.material, *before, *catalog_);
    }
    if (state_.second) {
        state_.second = reconciled(*state_.second, *before, *catalog_);
    }
    if (state_.picture) {
        state_.picture->material = reconciled(state_.picture->material, *before, *catalog_);
    }
    for (Light& light : state_.scene.lights) {
        light.block = reconciled(light.block, kinds::lights, *before, *catalog_);
        if (light.shadow) {
            light.shadow = reconciled(*light.shadow, kinds::shadows, *before, *catalog_);
        }
    }
    for (auto& [kind, values] : state_.scene.parts) {
        values = reconciled(values, kind, *before, *catalog_);
    }
    announce({DocumentChange::Catalog});
}

} // namespace patina
