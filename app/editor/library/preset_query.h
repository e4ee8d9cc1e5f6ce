// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "library/preset_entry.h"

namespace patina {

class PresetMarks;

/// Says which presets are wanted. Fields that are empty or false exclude none.
struct PresetFilter {
    QString search; ///< holds words, each of which begins a word of a preset's text
    QString model;  ///< is the id of a lighting model
    QString tag;
    QString folder; ///< holds the presets, directly or below
    bool favourites = false;
    bool recent = false; ///< keeps those used lately, newest first

    bool isEmpty() const { return *this == PresetFilter(); }

    friend bool operator==(const PresetFilter&, const PresetFilter&) = default;
};

enum class PresetOrder { Name, Date, Model };

/// Returns whether each word of a search begins a word of the preset's text.
bool matches(const PresetEntry& entry, const QString& search);

/// Returns the presets that pass a filter, in the given order; `entries` have to be sorted by name.
/// By name those come first that have what is searched in their names.
std::vector<PresetPtr> chosen(const std::vector<PresetPtr>& entries, const PresetFilter& filter,
                              PresetOrder order, const PresetMarks& marks);

} // namespace patina
