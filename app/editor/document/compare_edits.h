// SPDX-License-Identifier: GPL-3.0-or-later
// Undoable edits of what the sides of a document show while they are compared.
#pragma once

#include <optional>
#include <vector>

#include "document/document.h"

namespace patina {

/// Starts comparing with a material, changes it, or stops (nullopt).
void setSecondMaterial(Document& document, std::optional<Material> material);

/// Gives sides C and D these materials; fewer take sides away.
void setFurtherMaterials(Document& document, std::vector<Material> materials);

/// Lays settings of the picture over what the sides show, or none (nullopt).
void setComparedPicture(Document& document, std::optional<ComparedPicture> picture);

/// Gives a side's view what it has of its own; all else is linked with the scene.
void setOwnView(Document& document, Side side, const OwnView& own, const QString& label);

/// Lets side A draw the picture as its scene says, where other settings were shown there.
void showOwnPicture(Document& document);

} // namespace patina
