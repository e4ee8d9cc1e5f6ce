// SPDX-License-Identifier: GPL-3.0-or-later
// How a document follows blocks that change while it is open.
#include <utility>

#include "document.h"

namespace patina {

namespace {

/// Values by id, brought into the block's types and ranges; values the block does not know stay,
/// because it may be the block that is wrong at the moment.
void conformTo(const Block& block, Values& values) {
    for (const Parameter& parameter : block.parameters) {
        const auto found = values.find(parameter.id);
        if (found == values.end()) {
            values.emplace(parameter.id, parameter.defaultValue);
        } else {
            found->second = roundedToFloat(conformed(parameter, found->second));
        }
    }
}

} // namespace

void Document::reconcile(BlockValues& values, std::string_view kind, const Catalog& before) const {
    const Block* now = catalog_->find(kind, values.id);
    const Block* then = before.find(kind, values.id);
    if (now && !(then && *then == *now)) {
        conformTo(*now, values.parameters);
    }
}

void Document::reconcile(Material& material, const Catalog& before) const {
    const Block* model = catalog_->find("models", material.model.id);
    if (const Block* then = before.find("models", material.model.id); model && !then) {
        material = withModel(material, nullptr, *model); // an unknown model became known
    }
    reconcile(material.model, "models", before);
    if (material.fresnel) {
        reconcile(*material.fresnel, "fresnel", before);
    }
}

void Document::setCatalog(std::shared_ptr<const Catalog> catalog) {
    const std::shared_ptr<const Catalog> before = std::exchange(catalog_, std::move(catalog));
    accuracyBlocks_.clear();
    for (Object& object : state_.scene.objects) {
        reconcile(object.material, *before);
    }
    if (state_.second) {
        reconcile(*state_.second, *before);
    }
    for (Light& light : state_.scene.lights) {
        reconcile(light.block, "lights", *before);
    }
    if (state_.scene.fog) {
        reconcile(*state_.scene.fog, "fog", *before);
    }
    Q_EMIT catalogChanged();
}

} // namespace patina
