// SPDX-License-Identifier: GPL-3.0-or-later
#include "render/lights/light_kinds.h"

#include <algorithm>

#include "shading/effects/effect_key.h"
#include "shading/effects/shadows.h"

namespace patina {

void LightKinds::begin(const Scene& effects, const Catalog& catalog) {
    keys_.clear();
    missingKinds_.clear();
    missingCount_ = 0;
    kindOf_.assign(effects.lights.size(), 0);
    const bool shadows = hasShadows(effects, catalog);
    for (std::size_t i = 0; i < effects.lights.size(); ++i) {
        const std::uint64_t key = EffectKey::ofLight(effects.lights[i], catalog, shadows);
        if (key == 0) {
            continue;
        }
        const auto kind = std::ranges::find(keys_, key);
        kindOf_[i] = static_cast<std::size_t>(kind - keys_.begin()) + 1;
        if (kind == keys_.end()) {
            keys_.push_back(key);
        }
    }
}

std::size_t LightKinds::missingKinds(const LightLists& lists, std::size_t list) {
    if (missingKinds_.size() <= list) {
        missingKinds_.resize(list + 1, 0);
    }
    if (missingKinds_[list] == 0) {
        missingKinds_[list] = find(lists, list) + 1;
    }
    return missingKinds_[list] - 1;
}

std::size_t LightKinds::find(const LightLists& lists, std::size_t list) {
    isThere_.assign(keys_.size(), 0);
    for (std::size_t i = 0; i < kindOf_.size(); ++i) {
        if (kindOf_[i] != 0 && lists.holds(list, i)) {
            isThere_[kindOf_[i] - 1] = 1;
        }
    }
    found_.clear();
    for (std::size_t i = 0; i < kindOf_.size(); ++i) {
        if (kindOf_[i] != 0 && isThere_[kindOf_[i] - 1] == 0) {
            found_.add(i);
        }
    }
    std::size_t missing = found_.empty() ? 0 : 1;
    while (missing != 0 && missing <= missingCount_ && !(*lights_[missing - 1] == found_)) {
        ++missing;
    }
    if (missing <= missingCount_) {
        return missing;
    }
    if (lights_.size() == missingCount_) {
        lights_.emplace_back();
    }
    std::shared_ptr<LightSet>& kept = lights_[missingCount_++];
    if (kept.use_count() != 1) {
        kept = std::make_shared<LightSet>();
    }
    *kept = found_;
    return missing;
}

std::shared_ptr<const LightSet> LightKinds::lights(std::size_t missing) const {
    return missing == 0 ? nullptr : lights_[missing - 1];
}

} // namespace patina
