// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string_view>

#include "scene/scene.h"

namespace patina {

/// Returns a setting that every scene, camera, object or light has; nothing where there is none of
/// this id.
std::optional<Value> settingOf(const Scene& scene, std::string_view id);
std::optional<Value> settingOf(const Camera& camera, std::string_view id);
std::optional<Value> settingOf(const Object& object, std::string_view id);
std::optional<Value> settingOf(const Light& light, std::string_view id);

/// Stores such a setting. Does nothing where the id is not known or the value has the wrong type.
void storeSetting(Scene& scene, std::string_view id, const Value& value);
void storeSetting(Camera& camera, std::string_view id, const Value& value);
void storeSetting(Object& object, std::string_view id, const Value& value);
void storeSetting(Light& light, std::string_view id, const Value& value);

} // namespace patina
