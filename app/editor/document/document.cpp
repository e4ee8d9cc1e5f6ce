// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/document.h"

#include <algorithm>
#include <utility>

#include "document/block_label.h"
#include "document/commands/camera_command.h"
#include "document/commands/group_command.h"
#include "document/commands/light_command.h"
#include "document/commands/model_command.h"
#include "document/commands/parameter_command.h"
#include "document/commands/part_command.h"
#include "document/commands/scene_block_command.h"
#include "document/commands/texture_command.h"
#include "document/compare_edits.h"
#include "document/swapped_block.h"
#include "scene/scene_settings.h"
#include "text/short_text.h"

namespace patina {
namespace {

/// See DocumentCommand::origin(); of the edits in a macro.
const Material* originIn(const QUndoCommand& command, MaterialPlace& place) {
    if (const auto* edit = dynamic_cast<const DocumentCommand*>(&command)) {
        return edit->origin(place);
    }
    for (int i = command.childCount() - 1; i >= 0; --i) {
        if (const Material* material = originIn(*command.child(i), place)) {
            return material;
        }
    }
    return nullptr;
}

Light ofKind(Light light, const Block* before, const Block& wanted) {
    light.block = swappedBlock(&light.block, before, wanted);
    if (before && light.name == before->label) {
        light.name = wanted.label; // a name nobody chose follows the kind
    }
    return light;
}

} // namespace

Document::Document(std::shared_ptr<const Catalog> catalog, QObject* parent)
    : QObject(parent), catalog_(std::move(catalog)),
      selection_(state_, [this](const DocumentChange& change) { announce(change); }),
      interaction_([this] { announce({DocumentChange::Interaction}); }) {
    connect(&undoStack_, &QUndoStack::cleanChanged, this,
            [this](bool clean) { Q_EMIT modifiedChanged(!clean); });
}

Document::~Document() {
    // Clearing the stack below must not call back into a half-destroyed document.
    undoStack_.disconnect(this);
}

/// The document itself follows first, so that everybody finds it in order.
void Document::announce(const DocumentChange& change) {
    if (change.has(DocumentChange::Value)) {
        shownScenes_.follow(state_, selection_.object(), change.path, change.parameterId);
    } else if (change.has(DocumentChange::Drawn)) {
        shownScenes_.forget();
    }
    if (change.has(DocumentChange::Lights | DocumentChange::Objects | DocumentChange::Comparing)) {
        selection_.keepInside();
    }
    Q_EMIT changed(change);
}

const Scene& Document::scene(Side side) const {
    return shownScenes_.scene(state_, selection_.object(), side);
}

Scene Document::ownScene(Side side) const {
    return patina::ownScene(state_, selection_.object(), side);
}

const Material* Document::material(Side side) const {
    return selection_.object() < 0 ? nullptr : materialAt(state_, selection_.object(), side);
}

void Document::startFrom(DocumentState state, int object) {
    undoStack_.clear();
    interaction_.drop();
    lastParts_.clear();
    state_ = std::move(state);
    opened_ = state_;
    selection_.start(object);
    announce({DocumentChange::Scene | DocumentChange::Comparing});
}

void Document::setCatalog(std::shared_ptr<const Catalog> catalog) {
    const std::shared_ptr<const Catalog> before = std::exchange(catalog_, std::move(catalog));
    blocks_.forget();
    reconcile(state_, *before, *catalog_);
    announce({DocumentChange::Catalog});
}

const Block* Document::block(const BlockPath& path) const {
    return blocks_.find(state_, path, *catalog_);
}

const Parameter* Document::parameter(const ParameterTarget& target) const {
    const Block* described = block(target.path);
    return described ? described->parameter(target.parameterId) : nullptr;
}

Value Document::value(const BlockPath& path, const Parameter& parameter) const {
    const std::optional<Value> stored = storedValue(state_, path, parameter.id);
    return roundedToFloat(stored ? conformed(parameter, *stored) : parameter.defaultValue);
}

void Document::setValue(const BlockPath& path, std::string_view parameterId, const Value& wanted) {
    const Block* described = block(path);
    const Parameter* parameter = described ? described->parameter(parameterId) : nullptr;
    if (!parameter || !isFinite(wanted)) {
        return;
    }
    if (const auto* file = std::get_if<std::string>(&wanted)) {
        Q_EMIT fileNamed(*file);
    }
    if (path.isAt(settings::camera)) {
        Camera camera = state_.scene.camera;
        storeSetting(camera, parameterId, roundedToFloat(conformed(*parameter, wanted)));
        setCamera(camera);
        return;
    }
    const QString label = tr("Change %1").arg(QString::fromStdString(parameter->label));
    bool isChange = false;
    GroupCommand::Edits edits;
    for (const BlockPath& each : selection_.editedPaths(path)) {
        const Block* block = this->block(each);
        const Parameter* same = block ? block->parameter(parameterId) : nullptr;
        if (same && same->type == parameter->type) {
            const Value after = roundedToFloat(conformed(*same, wanted));
            isChange |= after != value(each, *same);
            edits.push_back(std::make_unique<ParameterCommand>(*this, each, *block, *same, after));
        }
    }
    if (!isChange) {
        return;
    }
    const auto edit = [&] { pushAsOne(*this, label, std::move(edits)); };
    if (!isOverlaid(state_, path, parameterId)) {
        edit();
        return;
    }
    editAsOneStep(label, [&] {
        showOwnPicture(*this); // so that the edit is seen
        edit();
    });
}

void Document::setValues(const BlockPath& path, const Values& values, const QString& label,
                         const TextureEdits& textures) {
    if (path.isAt(settings::camera)) {
        for (const auto& [id, value] : values) {
            setValue(path, id, value);
        }
        return;
    }
    bool isChange = false;
    bool isHidden = false;
    GroupCommand::Edits edits; // also of values that stay: the steps of a drag merge
    for (const BlockPath& each : selection_.editedPaths(path)) {
        isChange |= addValueEdits(edits, each, values, label);
        isChange |= addTextureEdits(edits, each, textures, label);
    }
    for (const auto& [id, value] : values) {
        isHidden |= isOverlaid(state_, path, id);
    }
    if (!isChange) {
        return;
    }
    const auto edit = [&] { pushAsOne(*this, label, std::move(edits)); };
    if (!isHidden) {
        edit();
        return;
    }
    editAsOneStep(label, [&] {
        showOwnPicture(*this); // so that the edit is seen
        edit();
    });
}

/// Adds an edit of the values that the block at a path has; true where it changes something.
bool Document::addValueEdits(std::vector<std::unique_ptr<DocumentCommand>>& edits,
                             const BlockPath& path, const Values& values, const QString& label) {
    const Block* described = block(path);
    bool isChange = false;
    Values given;
    for (const auto& [id, wanted] : values) {
        const Parameter* parameter = described ? described->parameter(id) : nullptr;
        if (parameter && isFinite(wanted)) {
            const Value after = roundedToFloat(conformed(*parameter, wanted));
            const bool isNew = after != value(path, *parameter);
            isChange |= isNew;
            if (const auto* file = std::get_if<std::string>(&after);
                file && isNew && infoOf(parameter->type).isFile) {
                Q_EMIT fileNamed(*file);
            }
            given.emplace(id, after);
        }
    }
    if (!given.empty()) {
        edits.push_back(std::make_unique<ParameterCommand>(*this, path, *described, given, label));
    }
    return isChange;
}

bool Document::addTextureEdits(std::vector<std::unique_ptr<DocumentCommand>>& edits,
                               const BlockPath& path, const TextureEdits& textures,
                               const QString& label) {
    const Block* described = block(path);
    bool isChange = false;
    for (const auto& [id, use] : textures) {
        const TextureUse* held = texture(path, id);
        const bool isNew = held ? !use || *use != *held : use.has_value();
        if (isNew && described && described->parameter(id) && takesTextures(path)) {
            isChange = true;
            edits.push_back(
                std::make_unique<TextureCommand>(*this, ParameterTarget{path, id}, use, label));
        }
    }
    return isChange;
}

const TextureUse* Document::texture(const BlockPath& path, std::string_view parameterId) const {
    const Material* held =
        takesTextures(path) ? materialAt(state_, path.index, path.side) : nullptr;
    if (!held) {
        return nullptr;
    }
    const auto found = held->textures.find(textureKey(path, parameterId));
    return found == held->textures.end() ? nullptr : &found->second;
}

void Document::setTexture(const BlockPath& path, std::string_view parameterId,
                          const std::optional<TextureUse>& use) {
    const Block* described = block(path);
    const Parameter* parameter = described ? described->parameter(parameterId) : nullptr;
    const TextureUse* held = texture(path, parameterId);
    if (!parameter || !takesTextures(path) || !materialAt(state_, path.index, path.side)) {
        return;
    }
    bool isChange = false;
    std::vector<BlockPath> paths = selection_.editedPaths(path);
    std::erase_if(paths, [&](const BlockPath& each) {
        const Block* block = this->block(each);
        const Parameter* same = block ? block->parameter(parameterId) : nullptr;
        return !same || same->type != parameter->type;
    });
    for (const BlockPath& each : paths) {
        const TextureUse* there = texture(each, parameterId);
        isChange |= there ? !use || *use != *there : use.has_value();
    }
    if (!isChange) {
        return;
    }
    const QString name = QString::fromStdString(parameter->label);
    const QString label = !use    ? tr("Remove image of %1").arg(name)
                          : !held ? tr("Image on %1").arg(name)
                                  : tr("Change image of %1").arg(name);
    GroupCommand::Edits edits;
    for (const BlockPath& each : paths) {
        edits.push_back(std::make_unique<TextureCommand>(
            *this, ParameterTarget{each, std::string(parameterId)}, use, label));
    }
    pushAsOne(*this, label, std::move(edits));
}

void Document::setBlock(const BlockPath& path, std::string_view blockId) {
    const BlockKind* kind = findKind(path.kind);
    const Block* wanted = blockId.empty() ? nullptr : catalog_->find(path.kind, blockId);
    const bool isPossible = wanted || (blockId.empty() && kind && kind->isPart);
    const BlockValues* held = blockValuesAt(state_, path);
    const bool isSame = (held ? held->id : std::string()) == blockId;
    if (!isPossible || (isSame && path.owner != BlockOwner::Material)) {
        return;
    }
    if (path.isOfView) {
        setOwnEnvironment(path, wanted);
    } else if (scenePartsAt(state_, path)) {
        if (path.isAt(kinds::lights)) {
            setKindOfLight(path, *wanted);
        } else {
            setScenePart(path, wanted);
        }
    } else if (path.owner == BlockOwner::Material && materialAt(state_, path.index, path.side)) {
        setBlocksOfMaterials(path, wanted);
    }
}

/// Gives every material that is edited the block that it does not have yet.
void Document::setBlocksOfMaterials(const BlockPath& path, const Block* wanted) {
    GroupCommand::Edits edits;
    for (const BlockPath& each : selection_.editedPaths(path)) {
        const BlockValues* held = blockValuesAt(state_, each);
        if ((held ? held->id : std::string()) == (wanted ? wanted->id : std::string())) {
            continue;
        }
        if (path.isAt(kinds::models)) {
            edits.push_back(std::make_unique<ModelCommand>(
                *this, MaterialPlace{each.index, each.side}, *wanted));
        } else {
            edits.push_back(std::make_unique<PartCommand>(*this, each, wanted));
        }
    }
    const QString label = path.isAt(kinds::models)
                              ? tr("Model %1").arg(QString::fromStdString(wanted->label))
                              : blockLabel(path.kind, wanted);
    pushAsOne(*this, label, std::move(edits));
}

void Document::setKindOfLight(const BlockPath& path, const Block& wanted) {
    const Light& held = state_.scene.lights[static_cast<std::size_t>(path.index)];
    undoStack_.push(new LightCommand(*this, path.index, held, ofKind(held, block(path), wanted),
                                     blockLabel(path.kind, &wanted)));
}

/// What the scene had last of a kind comes back with its values.
void Document::setScenePart(const BlockPath& path, const Block* wanted) {
    BlockParts held = *scenePartsAt(state_, path);
    if (path.owner == BlockOwner::Scene) {
        if (const BlockValues* part = partOf(held, path.kind)) {
            patina::setPart(lastParts_, path.kind, *part);
        }
        held = lastParts_;
    }
    std::optional<BlockValues> after;
    if (wanted) {
        after = swappedBlock(partOf(held, path.kind), blockOf(held, path.kind, *catalog_), *wanted);
    }
    undoStack_.push(
        new SceneBlockCommand(*this, path, std::move(after), blockLabel(path.kind, wanted)));
}

/// Carries over values with the same id.
void Document::setOwnEnvironment(const BlockPath& path, const Block* wanted) {
    OwnView own = state_.ownViews[indexOf(path.side)];
    const BlockValues* held = own.environment ? &*own.environment : nullptr;
    own.environment =
        wanted ? std::optional(swappedBlock(held, block(path), *wanted)) : std::nullopt;
    setOwnView(*this, path.side, own, blockLabel(path.kind, wanted));
}

void Document::setModel(Side side, std::string_view modelId) {
    setBlock(pathOf(kinds::models, selection_.object(), side), modelId);
}

void Document::replaceMaterial(Side side, const Material& wanted, const QString& label,
                               MaterialEdit edit) {
    const Material* held = material(side);
    if (held && !(*held == wanted)) {
        undoStack_.push(
            new MaterialCommand(*this, {selection_.object(), side}, wanted, label, edit));
    }
}

void Document::replaceMaterials(Side side, const Material& wanted, const QString& label) {
    GroupCommand::Edits edits;
    for (const BlockPath& each :
         selection_.editedPaths(pathOf(kinds::models, selection_.object(), side))) {
        const Material* held = materialAt(state_, each.index, each.side);
        if (held && !(*held == wanted)) {
            edits.push_back(std::make_unique<MaterialCommand>(
                *this, MaterialPlace{each.index, each.side}, wanted, label, MaterialEdit::Applied));
        }
    }
    pushAsOne(*this, label, std::move(edits));
}

void Document::setCamera(const Camera& camera) {
    if (camera != state_.scene.camera) {
        state_.scene.camera = camera;
        announce({DocumentChange::Camera});
    }
}

void Document::nameScene(const std::string& name) {
    state_.scene.name = name;
    shownScenes_.forget(); // they have the name too
}

const Material* Document::originalMaterial(MaterialPlace place) const {
    for (int i = undoStack_.index() - 1; i >= 0; --i) {
        if (const Material* material = originIn(*undoStack_.command(i), place)) {
            return material;
        }
    }
    return materialAt(opened_, place.object, place.side);
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

} // namespace patina
