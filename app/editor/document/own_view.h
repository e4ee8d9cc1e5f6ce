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

/// Holds what a side's view has of its own while sides are compared. What is absent here is linked
/// with the scene.
struct OwnView {
    std::optional<double> exposure;         ///< stops
    bool hasEnvironment = false;            ///< says that `environment` counts, not the scene's
    std::optional<BlockValues> environment; ///< is absent where the view has no environment
    /// Holds the names of effects that are off.
    std::optional<std::vector<std::string>> switchedOff;

    bool isLinked() const { return *this == OwnView(); }

    friend bool operator==(const OwnView&, const OwnView&) = default;
};

/// Names the setting of the scene that a view may have of its own.
inline constexpr const char* exposureSetting = "exposure";

/// Returns a setting of the scene that is the view's own; nothing where it is linked.
std::optional<Value> settingOf(const OwnView& own, std::string_view id);
void storeSetting(OwnView& own, std::string_view id, const Value& value);

/// Gives a scene what a view has of its own; its effects stay.
void giveOwn(Scene& scene, const OwnView& own);

/// Brings the linked settings of a scene that a view shows up to date with `scene`.
void relink(Scene& shown, const Scene& scene, const OwnView& own);

nlohmann::json toJson(const OwnView& own);

/// Reads what toJson() gave. A picture that may not be read stays named, and is outside.
OwnView ownViewFrom(const LocatedJson& document, const Catalog& catalog, References& references);

} // namespace patina
