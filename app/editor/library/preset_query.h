// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "library/preset_entry.h"

namespace patina {

class PresetMarks;

/// Says which presets are wanted. What is empty or false leaves none out.
struct PresetFilter {
    QString search; ///< words that each begin a word of the name, a tag, the model or other texts
    QString model;  ///< the id of a lighting model
    QString tag;
    QString folder; ///< they lie in it or below
    bool favourites = false;
    bool recent = false; ///< used lately; these come first

    bool isEmpty() const { return *this == PresetFilter(); }

    friend bool operator==(const PresetFilter&, const PresetFilter&) = default;
};

enum class PresetOrder { Name, Date, Model };

/// Tells whether each word of a search begins a word of what the preset is searched by.
bool matches(const PresetEntry& entry, const QString& search);

/// The wanted ones of entries that are sorted by name, in an order.
std::vector<PresetPtr> chosen(const std::vector<PresetPtr>& entries, const PresetFilter& filter,
                              PresetOrder order, const PresetMarks& marks);

} // namespace patina
