// SPDX-License-Identifier: GPL-3.0-or-later
#include "docks/library_steps.h"

#include <algorithm>

#include "files/file_actions.h"
#include "library/preset_library.h"

namespace patina {

void LibrarySteps::step(Side side, int by) {
    std::vector<PresetPtr> presets(library_.entries().begin(), library_.entries().end());
    std::ranges::stable_sort(presets, {}, [](const PresetPtr& entry) -> const std::string& {
        return entry->material.name;
    });
    step(side, by, presets);
}

PresetPtr LibrarySteps::step(Side side, int by, const std::vector<PresetPtr>& presets) {
    if (presets.empty() || document_.material(Side::A) == nullptr) {
        return nullptr;
    }
    std::filesystem::path& last = last_[indexOf(side)];
    const Material* shown = document_.material(side);
    const std::string name = shown != nullptr ? shown->name : document_.material(Side::A)->name;
    const auto isNamed = [&](const PresetPtr& entry) { return entry->material.name == name; };
    auto now = std::ranges::find_if(
        presets, [&](const PresetPtr& entry) { return entry->file == last && isNamed(entry); });
    if (now == presets.end()) {
        now = std::ranges::find_if(presets, isNamed);
    }
    const auto count = static_cast<int>(presets.size());
    const int from = now == presets.end() ? -1 : static_cast<int>(now - presets.begin());
    const int next = from < 0 ? 0 : ((from + by) % count + count) % count;
    PresetPtr applied = presets[static_cast<std::size_t>(next)];
    last = applied->file;
    files_.applyPreset(QString::fromStdString(last.string()), side);
    return applied;
}

} // namespace patina
