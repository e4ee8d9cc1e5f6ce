// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/scene_edits.h"

#include <algorithm>

#include "document/commands/light_command.h"
#include "document/commands/lighting_command.h"
#include "document/commands/object_command.h"
#include "document/commands/scene_block_command.h"
#include "document/swapped_block.h"
#include "scene/environment.h"

namespace patina {
namespace {

template <class Element>
const Element* at(const std::vector<Element>& list, int index) {
    const bool isInside = index >= 0 && index < static_cast<int>(list.size());
    return isInside ? &list[static_cast<std::size_t>(index)] : nullptr;
}

} // namespace

void addLight(Document& document, std::string_view blockId) {
    const Block* block = document.catalog().find(kinds::lights, blockId);
    if (!block) {
        return;
    }
    const int index = static_cast<int>(document.scene().lights.size());
    const Light light{block->label, true, defaultsOf(*block)};
    document.undoStack().push(
        new LightCommand(document, index, std::nullopt, light,
                         Document::tr("Add %1").arg(QString::fromStdString(block->label))));
}

void setLight(Document& document, int index, const Light& light) {
    const Light* held = at(document.scene().lights, index);
    if (held && !(*held == light)) {
        document.undoStack().push(
            new LightCommand(document, index, *held, light, Document::tr("Change light")));
    }
}

void removeLight(Document& document, int index) {
    if (const Light* held = at(document.scene().lights, index)) {
        document.undoStack().push(
            new LightCommand(document, index, *held, std::nullopt, Document::tr("Remove light")));
    }
}

void addObject(Document& document, const Object& object) {
    const int index = static_cast<int>(document.scene().objects.size());
    document.undoStack().push(
        new ObjectCommand(document, index, std::nullopt, object,
                          Document::tr("Add %1").arg(QString::fromStdString(object.name))));
}

void setObject(Document& document, int index, const Object& object) {
    const Object* held = at(document.scene().objects, index);
    if (held && !(*held == object)) {
        document.undoStack().push(
            new ObjectCommand(document, index, *held, object, Document::tr("Change object")));
    }
}

void removeObject(Document& document, int index) {
    if (const Object* held = at(document.scene().objects, index)) {
        document.undoStack().push(
            new ObjectCommand(document, index, *held, std::nullopt, Document::tr("Remove object")));
    }
}

void setLighting(Document& document, const Scene& from) {
    document.undoStack().push(new LightingCommand(document, from));
}

std::string_view environmentPicture(const Document& document) {
    const BlockValues* held = document.scene().part(kinds::environment);
    const Block* block = blockOf(document.scene().parts, kinds::environment, document.catalog());
    return block ? pictureFile(*held, *block) : std::string_view();
}

void setEnvironmentPicture(Document& document, const std::filesystem::path& file) {
    Q_EMIT document.fileNamed(file);
    const BlockPath path = pathOf(kinds::environment);
    const BlockValues* held = blockValuesAt(document.state(), path);
    const Block* current = document.block(path);
    const std::vector<const Block*> all = document.catalog().ofKind(path.kind);
    const auto found = std::find_if(all.begin(), all.end(), [](const Block* block) {
        return pictureParameter(*block) != nullptr;
    });
    const bool fits = current && pictureParameter(*current);
    const Block* wanted = fits ? current : found == all.end() ? nullptr : *found;
    if (!wanted) {
        return;
    }
    BlockValues after = fits ? *held : defaultsOf(*wanted);
    after.parameters[pictureParameter(*wanted)->id] = file.generic_string();
    if (!held || !(*held == after)) {
        document.undoStack().push(new SceneBlockCommand(
            document, path, after,
            Document::tr("Environment %1").arg(QString::fromStdString(file.filename().string()))));
    }
}

} // namespace patina
