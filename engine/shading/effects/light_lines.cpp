// SPDX-License-Identifier: GPL-3.0-or-later
#include "shading/effects/light_lines.h"

#include <algorithm>

namespace patina {
namespace {

/// A model's code is in the text once per line, and compiling takes as much longer.
constexpr int maxLines = 4;

/// In a scene with more no light has lines, so that all lines have room in `sceneData`.
constexpr int maxLights = 8;

} // namespace

void LightLines::clear() {
    groups_.clear();
    lights_ = 0;
}

void LightLines::add(std::uint64_t key, bool isEverywhere, bool isReached) {
    if (key == 0) {
        return;
    }
    ++lights_;
    const auto before = [](const Group& group, std::uint64_t other) { return group.key < other; };
    const auto place = std::lower_bound(groups_.begin(), groups_.end(), key, before);
    if (place == groups_.end() || place->key != key) {
        groups_.insert(place, {key, 1, isEverywhere, isReached});
        return;
    }
    ++place->count;
    place->isReached = place->isReached || isReached;
    place->isEverywhere = place->isEverywhere && isEverywhere;
}

int LightLines::of(const Group& group) const {
    const bool isFew = lights_ <= maxLights && group.count <= maxLines;
    return isFew && group.isEverywhere ? group.count : 0;
}

int LightLines::of(std::uint64_t key) const {
    const auto place = std::find_if(groups_.begin(), groups_.end(),
                                    [key](const Group& group) { return group.key == key; });
    return place == groups_.end() ? 0 : of(*place);
}

} // namespace patina
