// SPDX-License-Identifier: GPL-3.0-or-later
#include "document/program_effects.h"

#include "material/model_swap.h"

namespace patina {

ProgramEffects::ProgramEffects(Document& document, QObject* parent)
    : QObject(parent), document_(document) {
    connect(&document, &Document::changed, this, &ProgramEffects::follow);
    connect(&document, &Document::valueApproached, this, &ProgramEffects::prewarm);
    connect(&document, &Document::modelApproached, this, &ProgramEffects::prewarmModel);
}

void ProgramEffects::follow(const DocumentChange& change) {
    if (change.has(DocumentChange::Value)) {
        frozen_.follow(document_.state(), change.path, change.parameterId);
        return;
    }
    const bool isDragged =
        change.has(DocumentChange::Texture) && document_.interaction().isGoingOn();
    if (!isDragged && !change.has(DocumentChange::Camera)) {
        end();
    }
    if (change.has(DocumentChange::Interaction) && document_.interaction().dragged()) {
        begin(*document_.interaction().dragged());
    }
}

void ProgramEffects::begin(const ParameterTarget& dragged) {
    const auto& [path, parameterId] = dragged;
    const Parameter* parameter = document_.parameter(dragged);
    if (!parameter) {
        return;
    }
    const DocumentState& state = document_.state();
    const int object = document_.selection().object();
    frozen_.begin(state, object, path, *parameter, document_.catalog());
    if (document_.texture(path, parameterId)) {
        frozen_.keepTexture(state, object, path, textureKey(path, parameterId));
    }
    if (frozen_.differs(state, document_.catalog())) {
        Q_EMIT changed();
    }
}

void ProgramEffects::end() {
    const bool differs = frozen_.differs(document_.state(), document_.catalog());
    frozen_.end();
    if (differs) {
        Q_EMIT changed();
    }
}

void ProgramEffects::prewarm(const ParameterTarget& approached) {
    const Parameter* parameter = document_.parameter(approached);
    if (parameter && !document_.interaction().isGoingOn()) {
        for (const DocumentState& state : patina::prewarmed(document_.state(), approached.path,
                                                            *parameter, document_.catalog())) {
            Q_EMIT prewarmed(state);
        }
    }
}

void ProgramEffects::prewarmModel(Side side, std::string_view modelId) {
    const Block* model = document_.catalog().find(kinds::models, modelId);
    DocumentState ahead = document_.state();
    Material* held = materialAt(ahead, document_.selection().object(), side);
    if (held && model && held->model.id != modelId && !document_.interaction().isGoingOn()) {
        *held = swappedModel(*held, *model, document_.catalog());
        Q_EMIT prewarmed(ahead);
    }
}

} // namespace patina
