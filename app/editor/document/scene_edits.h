// SPDX-License-Identifier: GPL-3.0-or-later
// Edits the lists of a document's scene and the picture of its environment; every edit can be
// undone.
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
/// Adds lights, of which the last one becomes the current one. None of them becomes a second key
/// light.
void addLights(Document& document, const std::vector<Light>& lights, const QString& label);
void setLight(Document& document, int index, const Light& light);
void removeLight(Document& document, int index);

/// Turns all lights but this one off; where this was done already, turns those on again that were
/// on before.
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

/// Returns these objects and all that are in a group with one of them, by rising index.
std::vector<int> withGroups(const Scene& scene, const std::vector<int>& indices);
/// Puts objects into a new group, with which they are selected from then on.
void groupObjects(Document& document, const std::vector<int>& indices);
void ungroupObjects(Document& document, const std::vector<int>& indices);

/// Keeps the camera under a digit from 1 to 9.
void setBookmark(Document& document, int digit, const Camera& camera);

/// Adds a pass over the picture behind the others, with the block's defaults.
void addPass(Document& document, std::string_view blockId);
void removePass(Document& document, int index);
/// Moves a pass to another place in the row.
void movePass(Document& document, int index, int to);

/// Lights the scene as another one is lit (see LightingCommand).
void setLighting(Document& document, const Scene& from);

/// Replaces the lamps of the scene's environment by lights of the scene, with soft shadows where
/// the catalogue has them, and limits the environment's radiance to what is left. Returns false
/// where the catalogue has no fitting light, where the environment has no limit, and where there
/// are no lamps.
bool takeLampsOut(Document& document, const EnvironmentLamps& lamps);

/// Returns the picture file of the environment that a side shows; empty where it needs none.
std::string_view environmentPicture(const Document& document, Side side);
/// Returns these files of all sides that are shown.
std::set<std::string, std::less<>> environmentPictures(const Document& document);
/// Lights the scene, or the active view where its environment is its own, with a picture. The
/// environment stays of its kind if that has a picture, and becomes the first kind with one
/// otherwise.
void setEnvironmentPicture(Document& document, const std::filesystem::path& file);

} // namespace patina
