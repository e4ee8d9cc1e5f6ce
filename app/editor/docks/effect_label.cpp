// SPDX-License-Identifier: GPL-3.0-or-later
#include "docks/effect_label.h"

#include <algorithm>

#include <QCoreApplication>

#include "shading/effects/textures.h"
#include "text/as_text.h"

namespace patina {
namespace {

QString translated(const char* text) {
    return QCoreApplication::translate("EffectLabel", text);
}

bool hasImage(const Material& material, const std::string& id) {
    return material.textures.contains(id);
}

/// Returns a material that has an image of this id; null if none has.
const Material* materialWith(const std::string& id, const Material* first, const Scene& scene) {
    if (first != nullptr && hasImage(*first, id)) {
        return first;
    }
    const auto found = std::ranges::find_if(
        scene.objects, [&id](const Object& object) { return hasImage(object.material, id); });
    return found == scene.objects.end() ? nullptr : &found->material;
}

/// Names the image by the parameter that it drives; by its id if that parameter is unknown.
QString labelOfInput(const std::string& id, const Material* material, const Catalog& catalog) {
    if (material == nullptr) {
        return translated("Image of %1").arg(asText(id));
    }
    const TextureUse& use = material->textures.find(id)->second;
    const Parameter* parameter = textureTarget(id, use, *material, catalog).parameter;
    return translated(isVertexColors(use.file) ? "Vertex colours on %1" : "Image of %1")
        .arg(asText(parameter != nullptr ? parameter->label : id));
}

QString labelOfImage(const std::string& id, const Material* first, const Scene& scene,
                     const Catalog& catalog) {
    if (id.empty()) {
        return translated("Images");
    }
    switch (textureRole(id)) {
    case TextureRole::Normal:
        return translated("Normal map");
    case TextureRole::Height:
        return translated("Height map");
    case TextureRole::Opacity:
        return translated("Image of the opacity");
    default:
        return labelOfInput(id, materialWith(id, first, scene), catalog);
    }
}

} // namespace

QString effectLabel(const std::string& effect, const Material* first, const Scene& scene,
                    const Catalog& catalog) {
    const std::size_t slash = effect.find('/');
    const std::string kind = effect.substr(0, slash);
    const std::string id = slash == std::string::npos ? std::string() : effect.substr(slash + 1);
    if (kind == "texture") {
        return labelOfImage(id, first, scene, catalog);
    }
    const Block* block = catalog.find(kind, id);
    QString label = asText(block != nullptr ? block->label : effect);
    if (!label.isEmpty()) {
        label[0] = label[0].toUpper();
    }
    return label;
}

} // namespace patina
