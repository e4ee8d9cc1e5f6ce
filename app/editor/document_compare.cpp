// SPDX-License-Identifier: GPL-3.0-or-later
// What of a document is compared: sides A and B of the current object.
#include <utility>

#include "commands/compare_command.h"
#include "commands/look_command.h"
#include "commands/material_command.h"
#include "document.h"

namespace patina {

void Document::setSecondMaterial(std::optional<Material> wanted) {
    if (wanted != state_.second) {
        undoStack_.push(new CompareCommand(*this, std::move(wanted)));
    }
}

void Document::setComparing(bool on) {
    const Material* first = material(Side::A);
    if (!on && state_.second) {
        lastSecond_ = state_.second;
        lastSecondObject_ = currentObject_;
        endComparing();
    } else if (on && first && !state_.second) {
        const bool returns = lastSecond_ && lastSecondObject_ == currentObject_;
        setSecondMaterial(returns ? *lastSecond_ : *first);
    }
}

/// Side A gets its own material back, if another one was there just to be looked at.
void Document::endComparing() {
    if (!state_.lookedAt) {
        setSecondMaterial(std::nullopt);
        return;
    }
    editAsOneStep(tr("Stop comparing"), [&] {
        putBack();
        setSecondMaterial(std::nullopt);
        setLookedAt(std::nullopt);
    });
}

/// Gives the object whose side A shows another material its own one.
void Document::putBack() {
    const int object = state_.lookedAt ? state_.lookedAt->object : -1;
    if (const std::optional<Material> own = materialAside(state_, object)) {
        undoStack_.push(
            new MaterialCommand(*this, {object, Side::A}, *own, tr("Stop comparing")));
    }
}

void Document::setLookedAt(std::optional<LookedAt> lookedAt) {
    if (lookedAt != state_.lookedAt) {
        undoStack_.push(new LookCommand(*this, std::move(lookedAt)));
    }
}

void Document::look(const Material& first, const Material& second, const QString& label) {
    const Material* held = material(Side::A);
    if (!held) {
        return;
    }
    editAsOneStep(label, [&] {
        putBack();
        const Material own = *material(Side::A);
        replaceMaterial(Side::A, first, label);
        setSecondMaterial(second);
        setLookedAt(own == first ? std::nullopt
                                 : std::optional(LookedAt{currentObject_, own, first}));
    });
}

void Document::setLevels(Side side, const AccuracyLevels& levels, const QString& label) {
    const Material* held = material(side);
    if (!held) {
        return;
    }
    Material wanted = *held;
    wanted.accuracy = levels;
    if (side == Side::B || !materialAside(state_, currentObject_)) {
        replaceMaterial(side, wanted, label);
        return;
    }
    editAsOneStep(label, [&] {
        setLookedAt(std::nullopt);
        replaceMaterial(side, wanted, label);
    });
}

void Document::swapSides() {
    const Material* first = material(Side::A);
    if (!first || !state_.second || *first == *state_.second) {
        return;
    }
    const Material formerFirst = *first;
    undoStack_.beginMacro(tr("Swap A and B"));
    replaceMaterial(Side::A, *state_.second, tr("Swap A and B"));
    setSecondMaterial(formerFirst);
    undoStack_.endMacro();
}

} // namespace patina
