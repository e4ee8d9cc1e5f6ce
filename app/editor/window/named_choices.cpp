// SPDX-License-Identifier: GPL-3.0-or-later
#include "window/named_choices.h"

#include <filesystem>

#include <QCoreApplication>

#include "document/document.h"
#include "document/scene_edits.h"
#include "files/file_actions.h"
#include "library/preset_library.h"
#include "scene/scene_file.h"

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
    const QString lighting = QCoreApplication::translate("patina::CommandPalette", "Lighting");
    for (const std::filesystem::path& file : shippedScenes()) {
        if (const auto read = readScene(file, document.catalog())) {
            choices.push_back({lighting, QString::fromStdString(read->scene.name),
                               [&document, scene = read->scene] { setLighting(document, scene); }});
        }
    }
    return choices;
}

} // namespace patina
