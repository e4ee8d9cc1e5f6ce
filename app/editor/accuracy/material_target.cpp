// SPDX-License-Identifier: GPL-3.0-or-later
#include "accuracy/material_target.h"

#include <optional>

#include <QCoreApplication>

#include "document/comparison.h"
#include "measure/cost/measured_scene.h"
#include "scene/environment.h"
#include "viewport/compare_area.h"

namespace patina {
namespace {

/// Writes the exact level only over another one, since a material without an entry is exact.
Material withLevels(Material material, const std::vector<Choice>& choices,
                    const ChosenLevels& levels) {
    for (const Choice& choice : choices) {
        const std::string& exact = choice.levels.front().id;
        const auto found = levels.find(choice.id);
        const std::string& level = found == levels.end() ? exact : found->second;
        if (level != exact || material.accuracy.contains(choice.key)) {
            material.accuracy[choice.key] = level;
        }
    }
    return material;
}

/// Gives the picture its usual accuracy and the environment its default directions, so that
/// materials are measured alike.
void forgetPicture(Scene& scene, const Catalog& catalog) {
    scene.accuracy = PictureAccuracy();
    const Block* block = blockOf(scene.parts, kinds::environment, catalog);
    const Parameter* directions = block == nullptr ? nullptr : directionsParameter(*block);
    if (directions != nullptr) {
        scene.part(kinds::environment)->parameters.erase(directions->id);
    }
}

} // namespace

std::vector<Choice> MaterialTarget::choices() const {
    const int object = document_.selection().object();
    return object < 0 ? std::vector<Choice>()
                      : materialChoices(document_.ownScene(document_.selection().side()),
                                        static_cast<std::size_t>(object), document_.catalog());
}

ChosenLevels MaterialTarget::levels(const std::vector<Choice>& choices) const {
    const Material* material = document_.material(document_.selection().side());
    if (material == nullptr) {
        return {};
    }
    const std::optional<Material> aside =
        document_.selection().side() == Side::A
            ? materialAside(document_.state(), document_.selection().object())
            : std::nullopt;
    return levelsOf(aside.value_or(*material), choices);
}

MeasuredSubject MaterialTarget::subject() const {
    const int object = document_.selection().object();
    Scene scene = document_.ownScene(document_.selection().side());
    if (object >= 0) {
        Material& material = scene.objects[static_cast<std::size_t>(object)].material;
        material.accuracy.clear();
        material.name.clear();
        material.description.clear();
        material.author.clear();
        material.license.clear();
        material.tags.clear();
    }
    leaveSurfaces(scene); // a measurement covers only them
    forgetPicture(scene, document_.catalog());
    return subjectOf(std::move(scene), object, document_.catalog());
}

void MaterialTarget::apply(const std::vector<Choice>& choices, const ChosenLevels& levels,
                           const QString& label) {
    if (const Material* held = document_.material(document_.selection().side())) {
        comparison_.setLevels(document_.selection().side(),
                              withLevels(*held, choices, levels).accuracy, label);
    }
}

void MaterialTarget::compare(const std::vector<Choice>& choices, const ChosenLevels& levels) {
    const Material* held = document_.material(document_.selection().side());
    if (held == nullptr) {
        return;
    }
    const Material exact = withLevels(*held, choices, {});
    const Material chosen = withLevels(*held, choices, levels);
    views_.setDifferenceWanted(true);
    const bool isSo = document_.isComparing() && *document_.material(Side::A) == exact &&
                      *document_.material(Side::B) == chosen;
    if (isSo) {
        return;
    }
    comparison_.previewMaterials(
        exact, chosen, QCoreApplication::translate("MaterialTarget", "Compare with exact"));
}

QString MaterialTarget::measureText() const {
    return QCoreApplication::translate(
        "MaterialTarget", "Measure the time and the error of every way to compute this material");
}

QString MaterialTarget::noChoicesText() const {
    return QCoreApplication::translate("MaterialTarget",
                                       "Nothing of this material can be computed more cheaply.");
}

} // namespace patina
