// SPDX-License-Identifier: GPL-3.0-or-later
// Edits of a document that are more than one value.
#include "document/commands/camera_command.h"
#include "document/commands/environment_command.h"
#include "document/commands/fog_command.h"
#include "document/commands/light_command.h"
#include "document/commands/model_command.h"
#include "document/commands/object_command.h"
#include "document/commands/part_command.h"
#include "document/commands/transparency_command.h"
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
    const Material* held = material(side);
    const Block* model = catalog_->find("models", modelId);
    if (held && model && held->model.id != modelId) {
        undoStack_.push(new ModelCommand(*this, {currentObject_, side}, *model));
    }
}

void Document::prewarmModel(Side side, std::string_view modelId) {
    const Block* model = catalog_->find("models", modelId);
    DocumentState ahead = state_;
    Material* held = materialAt(ahead, currentObject_, side);
    if (held && model && held->model.id != modelId && !isInteracting()) {
        *held = swappedModel(*held, *model, *catalog_);
        Q_EMIT effectsPrewarmed(ahead);
    }
}

void Document::setPart(Side side, BlockPath::Part part, std::string_view blockId) {
    const Material* held = material(side);
    const std::string_view kind = partKind(part);
    const Block* wanted = blockId.empty() ? nullptr : catalog_->find(kind, blockId);
    if (!held || kind.empty() || (!wanted && !blockId.empty())) {
        return;
    }
    const BlockValues* current = held->part(kind);
    if ((current ? current->id : std::string()) != blockId) {
        undoStack_.push(new PartCommand(*this, {currentObject_, side}, part, wanted));
    }
}

void Document::replaceMaterial(Side side, const Material& wanted, const QString& label) {
    const Material* held = material(side);
    if (held && !(*held == wanted)) {
        undoStack_.push(new MaterialCommand(*this, {currentObject_, side}, wanted, label));
    }
}

void Document::addLight(std::string_view blockId) {
    const Block* block = catalog_->find("lights", blockId);
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

void Document::setLightKind(int index, std::string_view blockId) {
    const Block* wanted = catalog_->find("lights", blockId);
    if (!wanted || !hasIndex(state_.scene.lights, index)) {
        return;
    }
    const Light& held = state_.scene.lights[static_cast<std::size_t>(index)];
    if (held.block.id == blockId) {
        return;
    }
    const Block* before = catalog_->find("lights", held.block.id);
    Light light = held;
    light.block = swapped(held.block, before, *wanted);
    if (before && light.name == before->label) {
        light.name = wanted->label; // a name nobody chose follows the kind
    }
    undoStack_.push(
        new LightCommand(*this, index, held, light, tr("Light %1").arg(labelOf(*wanted))));
}

void Document::removeLight(int index) {
    if (hasIndex(state_.scene.lights, index)) {
        const Light& held = state_.scene.lights[static_cast<std::size_t>(index)];
        undoStack_.push(new LightCommand(*this, index, held, std::nullopt, tr("Remove light")));
    }
}

void Document::setShadow(int index, std::string_view blockId) {
    if (!hasIndex(state_.scene.lights, index)) {
        return;
    }
    const Light& held = state_.scene.lights[static_cast<std::size_t>(index)];
    const Block* wanted = blockId.empty() ? nullptr : catalog_->find("shadows", blockId);
    if ((!wanted && !blockId.empty()) || (held.shadow ? held.shadow->id : "") == blockId) {
        return;
    }
    Light light = held;
    light.shadow.reset();
    if (wanted) {
        const Block* before = held.shadow ? catalog_->find("shadows", held.shadow->id) : nullptr;
        light.shadow = held.shadow ? swapped(*held.shadow, before, *wanted) : defaultsOf(*wanted);
    }
    undoStack_.push(new LightCommand(*this, index, held, light,
                                     wanted ? labelOf(*wanted) : tr("Shadows off")));
}

void Document::setFog(std::string_view blockId) {
    const std::optional<BlockValues>& held = state_.scene.fog;
    if ((held ? held->id : std::string()) == blockId) {
        return;
    }
    if (held) {
        lastFog_ = held;
    }
    if (blockId.empty()) {
        undoStack_.push(new FogCommand(*this, std::nullopt, tr("Fog off")));
        return;
    }
    const Block* wanted = catalog_->find("fog", blockId);
    if (!wanted) {
        return;
    }
    const Block* before = lastFog_ ? catalog_->find("fog", lastFog_->id) : nullptr;
    const BlockValues fog = lastFog_ ? swapped(*lastFog_, before, *wanted) : defaultsOf(*wanted);
    undoStack_.push(new FogCommand(*this, fog, tr("Fog %1").arg(labelOf(*wanted))));
}

void Document::setEnvironment(std::string_view blockId) {
    const std::optional<BlockValues>& held = state_.scene.environment;
    const Block* wanted = catalog_->find("environment", blockId);
    if ((held ? held->id : std::string()) == blockId || (!wanted && !blockId.empty())) {
        return;
    }
    if (held) {
        lastEnvironment_ = held;
    }
    if (!wanted) {
        undoStack_.push(new EnvironmentCommand(*this, std::nullopt, tr("Environment off")));
        return;
    }
    const std::optional<BlockValues>& last = lastEnvironment_;
    const Block* before = last ? catalog_->find("environment", last->id) : nullptr;
    undoStack_.push(new EnvironmentCommand(
        *this, last ? swapped(*last, before, *wanted) : defaultsOf(*wanted),
        tr("Environment %1").arg(labelOf(*wanted))));
}

void Document::setTransparency(std::string_view blockId) {
    const std::optional<BlockValues>& held = state_.scene.transparency;
    const Block* wanted = catalog_->find("transparency", blockId);
    if ((held ? held->id : std::string()) == blockId || (!wanted && !blockId.empty())) {
        return;
    }
    if (held) {
        lastTransparency_ = held;
    }
    if (!wanted) {
        undoStack_.push(new TransparencyCommand(*this, std::nullopt, tr("Sorted by object")));
        return;
    }
    const bool isBack = lastTransparency_ && lastTransparency_->id == blockId;
    undoStack_.push(new TransparencyCommand(
        *this, isBack ? *lastTransparency_ : defaultsOf(*wanted), labelOf(*wanted)));
}

std::string_view Document::environmentPicture() const {
    const std::optional<BlockValues>& held = state_.scene.environment;
    const Block* block = held ? catalog_->find("environment", held->id) : nullptr;
    return block ? pictureFile(*held, *block) : std::string_view();
}

void Document::setEnvironmentPicture(const std::filesystem::path& file) {
    allow(file);
    const std::optional<BlockValues>& held = state_.scene.environment;
    const Block* current = held ? catalog_->find("environment", held->id) : nullptr;
    const std::vector<const Block*> all = catalog_->ofKind("environment");
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
        undoStack_.push(new EnvironmentCommand(
            *this, after,
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
