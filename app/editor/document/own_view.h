// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <nlohmann/json.hpp>

#include "catalog/json_reader.h"
#include "material/reading_rights.h"
#include "scene/scene.h"

namespace patina {

/// Says what of the scene a side's view has of its own while sides are compared. What it has not is
/// linked with the scene.
struct OwnView {
    std::optional<double> exposure;         ///< stops
    bool hasEnvironment = false;            ///< the next, whatever lights the scene
    std::optional<BlockValues> environment; ///< absent: nothing lights it from all around
    std::optional<std::vector<std::string>> switchedOff; ///< its effects, by name

    bool isLinked() const { return *this == OwnView(); }

    friend bool operator==(const OwnView&, const OwnView&) = default;
};

/// The scene's setting that a view may have of its own.
inline constexpr const char* exposureSetting = "exposure";

/// A setting of the scene that is the view's own; nothing where it is linked.
std::optional<Value> settingOf(const OwnView& own, std::string_view id);
void storeSetting(OwnView& own, std::string_view id, const Value& value);

/// Gives a scene what a view has of its own; its effects stay.
void giveOwn(Scene& scene, const OwnView& own);

/// Gives a scene that a view shows what another one has where the view is linked with it.
void relink(Scene& shown, const Scene& scene, const OwnView& own);

nlohmann::json toJson(const OwnView& own);

/// Reads what toJson() gave. A picture that may not be read stays named, and is outside.
OwnView ownViewFrom(const LocatedJson& document, const Catalog& catalog, References& references);

} // namespace patina
