// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <vector>

#include <QString>

namespace patina {

class Document;
class FileActions;
class PresetLibrary;

/// Is something to choose that is found by its name, as a lighting model.
struct NamedChoice {
    QString kind; ///< says what it is, as "Model"
    QString name;
    std::function<void()> choose;
};

/// Returns the lighting models, then the presets, each chosen on the side that is worked on, and
/// then the scenes whose light ships; each is one undo step. What is passed outlives them.
std::vector<NamedChoice> namedChoices(Document& document, const PresetLibrary& presets,
                                      FileActions& files);

} // namespace patina
