// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <string_view>

#include "catalog/block.h"
#include "scene/scene.h"

namespace patina {

/// What every scene, object and material has is described as blocks too, so that the one form and
/// the one parameter command serve them: same widgets, same undo, same tooltips.
Block sceneBlock();
Block objectBlock();
Block materialBlock();

/// The accuracy choices of blocks as enum parameters; blocks share a choice of the same id.
Block accuracyBlock(std::span<const Block* const> blocks);

std::optional<Value> sceneValue(const Scene& scene, std::string_view parameterId);
std::optional<Value> objectValue(const Object& object, std::string_view parameterId);
std::optional<Value> materialValue(const Material& material, std::string_view parameterId);

void storeSceneValue(Scene& scene, std::string_view parameterId, const Value& value);
void storeObjectValue(Object& object, std::string_view parameterId, const Value& value);
void storeMaterialValue(Material& material, std::string_view parameterId, const Value& value);

} // namespace patina
