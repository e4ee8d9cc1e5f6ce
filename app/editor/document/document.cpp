// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/document.h"

#include <algorithm>

#include "docks/picture_accuracy_form.h"
#include "document/accuracy_block.h"
#include "document/commands/parameter_command.h"
#include "material/blocks_in_use.h"

namespace patina {

Document::Document(std::shared_ptr<const Catalog> catalog, QObject* parent)
    : QObject(parent), catalog_(std::move(catalog)) {
    for (const Descriptor& descriptor : settingsDescriptors()) {
        settings_.emplace(descriptor.block.id, descriptor.block);
    }
    for (const Parameter& parameter : pictureAccuracyParameters()) {
        settings_.find(settings::scene)->second.parameters.push_back(parameter);
    }
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
        updateShownScene(Side::A, change.path, change.parameterId);
        updateShownScene(Side::B, change.path, change.parameterId);
        frozenEffects_.follow(state_, change.path, change.parameterId);
    } else if (change.has(DocumentChange::Drawn)) {
        forgetShownScenes();
    }
    if (change.has(DocumentChange::Lights | DocumentChange::Objects | DocumentChange::Comparing)) {
        keepCurrentInside();
    }
    const bool isValue = change.has(DocumentChange::Value | DocumentChange::Camera);
    const bool isDragged = change.has(DocumentChange::Texture) && isInteracting();
    if (!isValue && !isDragged) {
        endFrozenEffects();
    }
    Q_EMIT changed(change);
}

const Scene& Document::scene(Side side) const {
    const bool isOwn = side == Side::A && pictureLaidOver(state_, side) == nullptr;
    if (isOwn || !state_.second || currentObject_ < 0) {
        return state_.scene;
    }
    std::optional<Scene>& shown = shownScenes_[static_cast<std::size_t>(side)];
    if (!shown) {
        shown = shownScene(state_, currentObject_, side);
    }
    return *shown;
}

Scene Document::ownScene(Side side) const {
    return patina::ownScene(state_, currentObject_, side);
}

/// A slider's tick changes what is shown in place: copying it would cost more than drawing it.
void Document::updateShownScene(Side side, const BlockPath& path, const std::string& id) {
    std::optional<Scene>& shown = shownScenes_[static_cast<std::size_t>(side)];
    const std::optional<Value> stored = storedValue(state_, path, id);
    if (!shown || !stored) {
        return;
    }
    const bool isOfMaterial = path.owner == BlockOwner::Material;
    const bool isOfB = isOfMaterial && path.side == Side::B;
    if (isOfB && state_.picture) {
        shown.reset(); // side B may have its own material from now on
        return;
    }
    const bool isHidden = isOfMaterial && !isOfB && path.index == currentObject_ &&
                          side == Side::B && hasSecondMaterial(state_);
    if (isHidden || (isOfB && side == Side::A)) {
        return;
    }
    BlockPath there = path;
    if (isOfB) {
        there.side = Side::A;
        there.index = currentObject_;
    }
    DocumentState changed{std::move(*shown), std::nullopt};
    storeValue(changed, there, id, *stored);
    if (const SidePicture* picture = pictureLaidOver(state_, side)) {
        layOver(changed.scene, *picture);
    }
    shown = std::move(changed.scene);
}

const Material* Document::material(Side side) const {
    return currentObject_ < 0 ? nullptr : materialAt(state_, currentObject_, side);
}

void Document::setCurrentObject(int index) {
    const int inside = std::min(index, static_cast<int>(state_.scene.objects.size()) - 1);
    if (inside != currentObject_) {
        currentObject_ = inside;
        forgetShownScenes();
        DocumentChange change{DocumentChange::Current};
        change.aspects.setFlag(DocumentChange::Material, isComparing()); // B moved to this object
        announce(change);
    }
}

void Document::setCurrentLight(int index) {
    const int inside = std::min(index, static_cast<int>(state_.scene.lights.size()) - 1);
    if (inside != currentLight_) {
        currentLight_ = inside;
        announce({DocumentChange::Current});
    }
}

void Document::setActiveSide(Side side) {
    const Side possible = state_.second ? side : Side::A;
    if (possible != activeSide_) {
        activeSide_ = possible;
        announce({DocumentChange::Current});
    }
}

void Document::keepCurrentInside() {
    const bool hasObjects = !state_.scene.objects.empty();
    const bool hasLights = !state_.scene.lights.empty();
    setCurrentObject(hasObjects ? std::max(currentObject_, 0) : -1);
    setCurrentLight(hasLights ? std::max(currentLight_, 0) : -1);
    setActiveSide(activeSide_);
}

BlockPath Document::currentPath(std::string_view kind) const {
    BlockPath path = pathOf(kind);
    if (path.owner == BlockOwner::Scene) {
        return path;
    }
    path.index = path.owner == BlockOwner::Light ? currentLight_ : currentObject_;
    path.side = path.owner == BlockOwner::Material ? activeSide_ : Side::A;
    return path;
}

const Block* Document::block(const BlockPath& path) const {
    if (const auto found = settings_.find(path.kind); found != settings_.end()) {
        return &found->second;
    }
    if (!path.isAt(settings::accuracy)) {
        const BlockValues* values = blockValuesAt(state_, path);
        return values ? catalog_->find(path.kind, values->id) : nullptr;
    }
    const Material* material = materialAt(state_, path.index, path.side);
    if (!material || !block(pathOf(kinds::models, path.index, path.side))) {
        return nullptr;
    }
    const std::vector<const Block*> blocks = blocksInUse(*material, *catalog_);
    const auto known = accuracyBlocks_.find(blocks);
    return known != accuracyBlocks_.end()
               ? &known->second
               : &accuracyBlocks_.emplace(blocks, accuracyBlock(blocks)).first->second;
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
        allow(*file);
    }
    const Value after = roundedToFloat(conformed(*parameter, wanted));
    if (after == value(path, *parameter)) {
        return;
    }
    const auto edit = [&] {
        undoStack_.push(new ParameterCommand(*this, path, *described, *parameter, after));
    };
    if (!isLaidOver(path, parameterId)) {
        edit();
        return;
    }
    const QString label = tr("Change %1").arg(QString::fromStdString(parameter->label));
    editAsOneStep(label, [&] {
        showOwnPicture(); // so that the edit is seen
        edit();
    });
}

int Document::beginInteraction() {
    endFrozenEffects();
    interaction_ = ++lastInteraction_;
    return interaction_;
}

void Document::endInteraction(int token) {
    if (token == 0 || token == interaction_) {
        interaction_ = 0;
        endFrozenEffects();
    }
}

int Document::beginInteraction(const BlockPath& path, std::string_view parameterId) {
    const int token = beginInteraction();
    const Block* described = block(path);
    const Parameter* parameter = described ? described->parameter(parameterId) : nullptr;
    if (parameter) {
        frozenEffects_.begin(state_, currentObject_, path, *parameter, *catalog_);
        if (texture(path, parameterId)) {
            frozenEffects_.keepTexture(state_, currentObject_, path, textureKey(path, parameterId));
        }
        if (frozenEffects_.differs(state_, *catalog_)) {
            Q_EMIT effectsChanged();
        }
    }
    return token;
}

void Document::prewarm(const BlockPath& path, std::string_view parameterId) {
    const Block* described = block(path);
    const Parameter* parameter = described ? described->parameter(parameterId) : nullptr;
    if (parameter && !isInteracting()) {
        for (const DocumentState& state : prewarmed(state_, path, *parameter, *catalog_)) {
            Q_EMIT effectsPrewarmed(state);
        }
    }
}

void Document::endFrozenEffects() {
    const bool differs = frozenEffects_.differs(state_, *catalog_);
    frozenEffects_.end();
    if (differs) {
        Q_EMIT effectsChanged();
    }
}

void Document::setCamera(const Camera& camera) {
    if (camera != state_.scene.camera) {
        state_.scene.camera = camera;
        announce({DocumentChange::Camera});
    }
}

} // namespace patina
