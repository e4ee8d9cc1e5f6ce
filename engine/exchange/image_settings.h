// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "exchange/exported_look.h"

namespace patina {

/// Returns the last part of a path with forward slashes.
std::string fileNameOf(const std::string& path);

/// Returns "Image wood.png" for lines.
std::string imageTitle(const TextureUse& use);

/// Tells whether an image lies as the coordinates of its mesh say.
bool isUnplaced(const TextureUse& use);

/// Tells whether an image lies on the surface as another one does, edges and pixels included.
bool liesAs(const TextureUse& use, const TextureUse& other);

/// Tells whether a colour's image is added to it, which no format has: it is to be dropped.
bool isAdded(const TextureUse& use);

/// Returns what the settings of an image ask for that no format of other programs has, as
/// "strength 0.5, one channel"; empty for nothing. What a format has not is for it to add.
std::string lostSettings(const TextureUse& use);

/// Returns what a colour's image is multiplied with: its value, or white where it takes the value's
/// place. Without an image it is the value, black where there is none.
glm::dvec3 imageFactor(const ExportedLook& look, const std::string& word);

} // namespace patina
