// SPDX-License-Identifier: GPL-3.0-or-later
// Undoable edits of the lists of a document's scene and of its environment's picture.
#pragma once

#include <filesystem>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "document/document.h"
#include "render/lights/environment_lamps.h"

namespace patina {

void addLight(Document& document, std::string_view blockId);
/// Adds lights, of which the last one becomes the current one. None is a second key light.
void addLights(Document& document, const std::vector<Light>& lights, const QString& label);
void setLight(Document& document, int index, const Light& light);
void removeLight(Document& document, int index);

/// Turns all lights but this one off; where they are already, those that were on before.
void toggleSolo(Document& document, int index);
/// Turns a light off or on.
void toggleMute(Document& document, int index);

void addObject(Document& document, const Object& object);
void setObject(Document& document, int index, const Object& object);

/// Changes objects, by their indices, as one step.
void setObjects(Document& document, const std::map<int, Object>& objects, const QString& label);
void changeObjects(Document& document, const std::vector<int>& indices, const QString& label,
                   const std::function<void(Object&)>& change);
void removeObjects(Document& document, std::vector<int> indices);
/// Adds objects under names and in groups that none has yet, and selects them.
void addObjects(Document& document, const std::vector<Object>& objects, const QString& label);

/// These objects and all that are in a group with one of them, by rising index.
std::vector<int> withGroups(const Scene& scene, const std::vector<int>& indices);
/// Puts objects into a new group, which they are selected with from then on.
void groupObjects(Document& document, const std::vector<int>& indices);
void ungroupObjects(Document& document, const std::vector<int>& indices);

/// Keeps the camera under a digit from 1 to 9.
void setBookmark(Document& document, int digit, const Camera& camera);

/// Lights the scene as another one is lit (see LightingCommand).
void setLighting(Document& document, const Scene& from);

/// Makes lights of the scene of the lamps of its environment, whose light is limited by as much:
/// with soft shadows where there are any such. False where the catalogue has no light or limit for
/// that, and where there are no lamps.
bool takeLampsOut(Document& document, const EnvironmentLamps& lamps);

/// Returns the file of the picture of the environment that a side shows; empty where it needs none.
std::string_view environmentPicture(const Document& document, Side side);
/// Returns the files of those of all sides that are shown.
std::set<std::string, std::less<>> environmentPictures(const Document& document);
/// Lights the scene, or the active view where its environment is its own, with a picture: of the
/// environment if it shows one, else of the first kind that does.
void setEnvironmentPicture(Document& document, const std::filesystem::path& file);

} // namespace patina
