// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/named_choices.h"

#include <QCoreApplication>

#include "document/document.h"
#include "files/file_actions.h"
#include "library/preset_library.h"

namespace patina {
namespace {

void chooseModel(Document& document, const std::string& id) {
    const Side side = document.selection().side();
    const Material* material = document.material(side);
    if (material != nullptr && material->model.id != id) {
        document.setModel(side, id);
    }
}

} // namespace

std::vector<NamedChoice> namedChoices(Document& document, const PresetLibrary& presets,
                                      FileActions& files) {
    const QString model = QCoreApplication::translate("patina::CommandPalette", "Model");
    const QString preset = QCoreApplication::translate("patina::CommandPalette", "Preset");
    std::vector<NamedChoice> choices;
    for (const Block* each : document.catalog().ofKind(kinds::models)) {
        choices.push_back({model, QString::fromStdString(each->label),
                           [&document, id = each->id] { chooseModel(document, id); }});
    }
    for (const PresetPtr& entry : presets.entries()) {
        choices.push_back({preset, entry->name, [&document, &files, path = entry->path] {
                               files.applyPreset(path, document.selection().side());
                           }});
    }
    return choices;
}

} // namespace patina
