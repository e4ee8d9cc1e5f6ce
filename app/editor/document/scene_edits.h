// SPDX-License-Identifier: GPL-3.0-or-later
// Undoable edits of the lists of a document's scene and of its environment's picture.
#pragma once

#include <filesystem>
#include <string_view>

#include "document/document.h"
#include "render/lights/environment_lamps.h"

namespace patina {

void addLight(Document& document, std::string_view blockId);
void setLight(Document& document, int index, const Light& light);
void removeLight(Document& document, int index);

void addObject(Document& document, const Object& object);
void setObject(Document& document, int index, const Object& object);
void removeObject(Document& document, int index);

/// Lights the scene as another one is lit (see LightingCommand).
void setLighting(Document& document, const Scene& from);

/// Makes lights of the scene of the lamps of its environment, whose light is limited by as much:
/// with soft shadows where there are any such. False where the catalogue has no light or limit for
/// that, and where there are no lamps.
bool takeLampsOut(Document& document, const EnvironmentLamps& lamps);

/// The file of the environment's picture; empty where it needs none.
std::string_view environmentPicture(const Document& document);
/// Lights the scene with a picture: of the environment if it shows one, else of the first kind
/// that does.
void setEnvironmentPicture(Document& document, const std::filesystem::path& file);

} // namespace patina
