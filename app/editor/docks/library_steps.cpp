// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/library_steps.h"

#include <algorithm>
#include <vector>

#include "files/file_actions.h"
#include "library/preset_library.h"

namespace patina {

void LibrarySteps::step(Side side, int by) {
    std::vector<const PresetEntry*> entries;
    for (const PresetPtr& entry : library_.entries()) {
        entries.push_back(entry.get());
    }
    if (entries.empty() || document_.material(Side::A) == nullptr) {
        return;
    }
    std::ranges::stable_sort(entries, {}, [](const PresetEntry* entry) -> const std::string& {
        return entry->material.name;
    });
    std::filesystem::path& last = last_[indexOf(side)];
    const Material* shown = document_.material(side);
    const std::string name = shown != nullptr ? shown->name : document_.material(Side::A)->name;
    const auto isNamed = [&](const PresetEntry* entry) { return entry->material.name == name; };
    auto now = std::ranges::find_if(
        entries, [&](const PresetEntry* entry) { return entry->file == last && isNamed(entry); });
    if (now == entries.end()) {
        now = std::ranges::find_if(entries, isNamed);
    }
    const auto count = static_cast<int>(entries.size());
    const int from = now == entries.end() ? -1 : static_cast<int>(now - entries.begin());
    const int next = from < 0 ? 0 : ((from + by) % count + count) % count;
    last = entries[static_cast<std::size_t>(next)]->file;
    files_.applyPreset(QString::fromStdString(last.string()), side);
}

} // namespace patina
