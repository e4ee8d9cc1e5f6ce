// SPDX-License-Identifier: GPL-3.0-or-later
// Edits of a document that are more than one value.
#include "document/block_label.h"
#include "document/commands/camera_command.h"
#include "document/commands/light_command.h"
#include "document/commands/model_command.h"
#include "document/commands/object_command.h"
#include "document/commands/part_command.h"
#include "document/commands/scene_block_command.h"
#include "document/document.h"
#include "material/model_swap.h"
#include "scene/environment.h"
#include "text/short_text.h"

namespace patina {

namespace {

QString labelOf(const Block& block) {
    return QString::fromStdString(block.label);
}

BlockValues defaultsOf(const Block& block) {
    BlockValues values;
    values.id = block.id;
    values.version = block.version;
    values.parameters = defaultValues(block);
    return values;
}

const char* const parkedKey = "parked";

/// Another block in place of `values`, by the same rules as a model swap: values with the same id
/// carry over, the others are parked beside them.
BlockValues swapped(const BlockValues& values, const Block* before, const Block& after) {
    Material carrier;
    carrier.model = values;
    if (const auto parked = values.unknown.find(parkedKey); parked != values.unknown.end()) {
        carrier.parked = *parked;
    }
    carrier = withModel(carrier, before, after);
    if (!carrier.parked.empty()) {
        carrier.model.unknown[parkedKey] = carrier.parked;
    }
    return carrier.model;
}

template <class Element>
bool hasIndex(const std::vector<Element>& list, int index) {
    return index >= 0 && index < static_cast<int>(list.size());
}

} // namespace

void Document::setModel(Side side, std::string_view modelId) {
    setBlock(pathOf(kinds::models, currentObject_, side), modelId);
}

void Document::prewarmModel(Side side, std::string_view modelId) {
    const Block* model = catalog_->find(kinds::models, modelId);
    DocumentState ahead = state_;
    Material* held = materialAt(ahead, currentObject_, side);
    if (held && model && held->model.id != modelId && !isInteracting()) {
        *held = swappedModel(*held, *model, *catalog_);
        Q_EMIT effectsPrewarmed(ahead);
    }
}

void Document::setBlock(const BlockPath& path, std::string_view blockId) {
    const BlockKind* kind = findKind(path.kind);
    const Block* wanted = blockId.empty() ? nullptr : catalog_->find(path.kind, blockId);
    const bool isPossible = wanted || (blockId.empty() && kind && kind->isPart);
    const BlockValues* held = blockValuesAt(state_, path);
    if (!isPossible || (held ? held->id : std::string()) == blockId) {
        return;
    }
    if (path.owner == BlockOwner::Scene) {
        setSceneBlock(path, wanted);
    } else if (path.owner == BlockOwner::Light) {
        setLightBlock(path, wanted);
    } else if (materialAt(state_, path.index, path.side)) {
        if (path.isAt(kinds::models)) {
            undoStack_.push(new ModelCommand(*this, {path.index, path.side}, *wanted));
        } else {
            undoStack_.push(new PartCommand(*this, path, wanted));
        }
    }
}

void Document::replaceMaterial(Side side, const Material& wanted, const QString& label) {
    const Material* held = material(side);
    if (held && !(*held == wanted)) {
        undoStack_.push(new MaterialCommand(*this, {currentObject_, side}, wanted, label));
    }
}

void Document::addLight(std::string_view blockId) {
    const Block* block = catalog_->find(kinds::lights, blockId);
    if (!block) {
        return;
    }
    const int index = static_cast<int>(state_.scene.lights.size());
    const Light light{block->label, true, defaultsOf(*block)};
    undoStack_.push(
        new LightCommand(*this, index, std::nullopt, light, tr("Add %1").arg(labelOf(*block))));
}

void Document::setLight(int index, const Light& light) {
    if (!hasIndex(state_.scene.lights, index)) {
        return;
    }
    const Light& held = state_.scene.lights[static_cast<std::size_t>(index)];
    if (!(held == light)) {
        undoStack_.push(new LightCommand(*this, index, held, light, tr("Change light")));
    }
}

void Document::setLightBlock(const BlockPath& path, const Block* wanted) {
    if (!hasIndex(state_.scene.lights, path.index)) {
        return;
    }
    const Light& held = state_.scene.lights[static_cast<std::size_t>(path.index)];
    const BlockValues* values = blockValuesAt(state_, path);
    const Block* before = block(path);
    Light light = held;
    if (path.isAt(kinds::shadows)) {
        light.shadow.reset();
    }
    if (wanted) {
        const BlockValues after = values ? swapped(*values, before, *wanted) : defaultsOf(*wanted);
        if (path.isAt(kinds::shadows)) {
            light.shadow = after;
        } else {
            light.block = after;
        }
    }
    if (path.isAt(kinds::lights) && before && light.name == before->label) {
        light.name = wanted->label; // a name nobody chose follows the kind
    }
    undoStack_.push(
        new LightCommand(*this, path.index, held, light, blockLabel(path.kind, wanted)));
}

void Document::removeLight(int index) {
    if (hasIndex(state_.scene.lights, index)) {
        const Light& held = state_.scene.lights[static_cast<std::size_t>(index)];
        undoStack_.push(new LightCommand(*this, index, held, std::nullopt, tr("Remove light")));
    }
}

void Document::setSceneBlock(const BlockPath& path, const Block* wanted) {
    if (const BlockValues* held = state_.scene.part(path.kind)) {
        patina::setPart(lastParts_, path.kind, *held);
    }
    std::optional<BlockValues> after;
    if (wanted) {
        const BlockValues* last = partOf(lastParts_, path.kind);
        after = last ? swapped(*last, blockOf(lastParts_, path.kind, *catalog_), *wanted)
                     : defaultsOf(*wanted);
    }
    undoStack_.push(
        new SceneBlockCommand(*this, path, std::move(after), blockLabel(path.kind, wanted)));
}

std::string_view Document::environmentPicture() const {
    const BlockValues* held = state_.scene.part(kinds::environment);
    const Block* block = blockOf(state_.scene.parts, kinds::environment, *catalog_);
    return block ? pictureFile(*held, *block) : std::string_view();
}

void Document::setEnvironmentPicture(const std::filesystem::path& file) {
    allow(file);
    const BlockPath path = pathOf(kinds::environment);
    const BlockValues* held = blockValuesAt(state_, path);
    const Block* current = block(path);
    const std::vector<const Block*> all = catalog_->ofKind(path.kind);
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
        undoStack_.push(new SceneBlockCommand(
            *this, path, after,
            tr("Environment %1").arg(QString::fromStdString(file.filename().string()))));
    }
}

void Document::editAsOneStep(const QString& label, const std::function<void()>& edits) {
    const Camera before = state_.scene.camera;
    undoStack_.beginMacro(shortened(label));
    edits();
    if (state_.scene.camera != before) {
        undoStack_.push(new CameraCommand(*this, before, state_.scene.camera));
    }
    undoStack_.endMacro();
}

void Document::addObject(const Object& object) {
    const int index = static_cast<int>(state_.scene.objects.size());
    undoStack_.push(new ObjectCommand(*this, index, std::nullopt, object,
                                      tr("Add %1").arg(QString::fromStdString(object.name))));
}

void Document::setObject(int index, const Object& object) {
    if (!hasIndex(state_.scene.objects, index)) {
        return;
    }
    const Object& held = state_.scene.objects[static_cast<std::size_t>(index)];
    if (!(held == object)) {
        undoStack_.push(new ObjectCommand(*this, index, held, object, tr("Change object")));
    }
}

void Document::removeObject(int index) {
    if (hasIndex(state_.scene.objects, index)) {
        const Object& held = state_.scene.objects[static_cast<std::size_t>(index)];
        undoStack_.push(new ObjectCommand(*this, index, held, std::nullopt, tr("Remove object")));
    }
}

} // namespace patina
