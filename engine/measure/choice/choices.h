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

/// Describes one level of a choice: one method to compute the same thing.
struct ChoiceLevel {
    std::string id;
    std::string label;
    std::string doc;

    friend bool operator==(const ChoiceLevel&, const ChoiceLevel&) = default;
};

/// Describes something that can be computed more cheaply, and its levels.
struct Choice {
    /// Tells where a choice is kept and with what its errors are compared.
    enum class Scope {
        Material, ///< is kept in Material::accuracy and compared with double precision
        Picture,  ///< is kept in View or the scene and compared with the finest picture
    };

    Scope scope = Scope::Material;
    std::string id;  ///< is "<choice>" of the model, "<kind>.<choice>" of a part, as for --set
    std::string key; ///< is the key in Material::accuracy; a picture's is its id
    std::string label;
    std::string doc;
    std::string block;               ///< is the label of the block that has it
    std::vector<ChoiceLevel> levels; ///< begin with the exact one

    const ChoiceLevel* level(std::string_view levelId) const;

    friend bool operator==(const Choice&, const Choice&) = default;
};

/// Maps Choice::id to the id of the level that is used; a missing choice is exact.
using ChosenLevels = std::map<std::string, std::string, std::less<>>;

/// Reads what levelsText() writes; nothing is returned where a word is no "<choice>=<level>".
std::optional<ChosenLevels> levelsFromText(const std::string& text);

/// Returns what shading the object's material in its scene could do more cheaply: the accuracy
/// choices of every block in its effect set. Where the model and a part have a choice of the same
/// name they share it, and it is listed once. Empty where there is no such object.
std::vector<Choice> materialChoices(const Scene& scene, std::size_t object, const Catalog& catalog);

/// Returns what the picture of the scene could do more cheaply, whatever is in it.
std::vector<Choice> choicesOfPicture(const Scene& scene, const Catalog& catalog);

/// Returns the levels that the material has now, without those that are exact.
ChosenLevels levelsOf(const Material& material, const std::vector<Choice>& choices);

/// Returns the levels that the picture of the scene has now, without those that are exact. A number
/// that is none of the choice's levels is returned as it is.
ChosenLevels levelsOfPicture(const Scene& scene, const std::vector<Choice>& choices,
                             const Catalog& catalog);

/// Holds what a frame shows: a scene and the view of it.
struct ChosenFrame {
    Scene scene;
    View view;
    int samplesAtOnce = 0;   ///< limits the directions of an environment that are captured at once;
                             ///< 0: the renderer decides
    bool isFinished = false; ///< is captured behind the picture passes, as the light that is shown
};

/// Gives each of these choices the level that `levels` names, or the exact one. Choices of the
/// scope Material are set in every object whose material equals that of `object`.
void choose(ChosenFrame& frame, std::size_t object, const std::vector<Choice>& choices,
            const ChosenLevels& levels, const Catalog& catalog);

/// Returns "fresnel.reflectance=high-index power=table", or "exact".
std::string levelsText(const ChosenLevels& levels);

/// Tells for each object of the scene whether its material equals that of `object`.
std::vector<bool> sharingMaterial(const Scene& scene, std::size_t object);

} // namespace patina
