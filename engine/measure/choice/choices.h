// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "catalog/catalog.h"
#include "render/renderer.h"
#include "scene/scene.h"

namespace patina {

/// One way to compute something.
struct ChoiceLevel {
    std::string id;
    std::string label;
    std::string doc;

    friend bool operator==(const ChoiceLevel&, const ChoiceLevel&) = default;
};

/// Something that can be computed more cheaply.
struct Choice {
    /// Tells what a choice belongs to, which says where it is kept and what its errors are measured
    /// by.
    enum class Scope {
        Material, ///< shading: in Material::accuracy, against double precision
        Picture,  ///< how often and how finely: in View or the scene, against the finest picture
    };

    Scope scope = Scope::Material;
    std::string id;  ///< as for --set: "<choice>" of the model, "<kind>.<choice>" of a part
    std::string key; ///< in Material::accuracy; a picture's is its id
    std::string label;
    std::string doc;
    std::string block;               ///< label of the block that has it
    std::vector<ChoiceLevel> levels; ///< the exact one first

    const ChoiceLevel* level(std::string_view levelId) const;

    friend bool operator==(const Choice&, const Choice&) = default;
};

/// Which level of each choice is taken, by Choice::id; what is missing is exact.
using ChosenLevels = std::map<std::string, std::string, std::less<>>;

/// Returns what levelsText() writes, read again; nothing where a word is no "<choice>=<level>".
std::optional<ChosenLevels> levelsFromText(const std::string& text);

/// Returns what shading the object's material in its scene could do more cheaply: the accuracy
/// choices of every block that is in its effect set. Where the model and a part have a choice of
/// the same name they share it, and it is listed once. None where there is no such object.
std::vector<Choice> materialChoices(const Scene& scene, std::size_t object, const Catalog& catalog);

/// Returns what the picture of the scene could do more cheaply, whatever is in it.
std::vector<Choice> choicesOfPicture(const Scene& scene, const Catalog& catalog);

/// Returns the levels that the material has now, without those that are exact.
ChosenLevels levelsOf(const Material& material, const std::vector<Choice>& choices);

/// Returns the same of the picture of the scene. A level that is none of the choice's is named as
/// it is.
ChosenLevels levelsOfPicture(const Scene& scene, const std::vector<Choice>& choices,
                             const Catalog& catalog);

/// Represents a frame: a scene and how it is looked at.
struct ChosenFrame {
    Scene scene;
    View view;
    int samplesAtOnce = 0; ///< the most directions of an environment that are captured in one go;
                           ///< 0: as many as the renderer likes
};

/// Gives each of these choices the level that `levels` names, or the exact one: those of the scope
/// Material in every object whose material is that of `object`.
void choose(ChosenFrame& frame, std::size_t object, const std::vector<Choice>& choices,
            const ChosenLevels& levels, const Catalog& catalog);

/// Returns "fresnel.reflectance=high-index power=table", or "exact".
std::string levelsText(const ChosenLevels& levels);

/// Returns the objects with the material of `object`.
std::vector<bool> sharingMaterial(const Scene& scene, std::size_t object);

} // namespace patina
