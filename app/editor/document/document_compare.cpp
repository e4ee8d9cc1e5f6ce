// SPDX-License-Identifier: GPL-3.0-or-later
// What of a document is compared: sides A and B of the current object.
#include <utility>

#include "docks/picture_accuracy_form.h"
#include "document/commands/compare_command.h"
#include "document/commands/look_command.h"
#include "document/commands/material_command.h"
#include "document/commands/picture_command.h"
#include "document/document.h"

namespace patina {

void Document::setSecondMaterial(std::optional<Material> wanted) {
    if (wanted != state_.second) {
        undoStack_.push(new CompareCommand(*this, std::move(wanted)));
    }
}

void Document::setComparing(bool on) {
    const Material* first = material(Side::A);
    if (!on && state_.second) {
        if (hasSecondMaterial(state_)) {
            lastSecond_ = state_.second;
            lastSecondObject_ = currentObject_;
        }
        endComparing();
    } else if (on && first && !state_.second) {
        const bool returns = lastSecond_ && lastSecondObject_ == currentObject_;
        setSecondMaterial(returns ? *lastSecond_ : *first);
    }
}

/// Side A gets its own material back, if another one was there just to be looked at.
void Document::endComparing() {
    if (!state_.lookedAt && !state_.picture) {
        setSecondMaterial(std::nullopt);
        return;
    }
    editAsOneStep(tr("Stop comparing"), [&] {
        putBack();
        setPicture(std::nullopt);
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
        setPicture(std::nullopt);
        putBack();
        const Material own = *material(Side::A);
        replaceMaterial(Side::A, first, label);
        setSecondMaterial(second);
        setLookedAt(own == first ? std::nullopt
                                 : std::optional(LookedAt{currentObject_, own, first}));
    });
}

void Document::setPicture(std::optional<ComparedPicture> picture) {
    if (picture != state_.picture) {
        undoStack_.push(new PictureCommand(*this, std::move(picture)));
    }
}

void Document::lookAtPictures(const Scene& first, const Scene& second, const QString& label) {
    const Material* held = material(activeSide_);
    if (!held) {
        return;
    }
    const std::optional<Material> aside =
        activeSide_ == Side::A ? materialAside(state_, currentObject_) : std::nullopt;
    const Scene& own = state_.scene;
    const ComparedPicture wanted{aside.value_or(*held), pictureOf(first, own),
                                 pictureOf(second, own)};
    if (isComparing() && state_.picture == wanted) {
        return;
    }
    editAsOneStep(label, [&] {
        if (!isComparing() || !(*material(Side::A) == wanted.material) ||
            !(*material(Side::B) == wanted.material)) {
            look(wanted.material, wanted.material, label);
        }
        setPicture(wanted);
    });
}

/// Whether side A shows another value than this one, which the scene has.
bool Document::isLaidOver(const BlockPath& path, std::string_view parameterId) const {
    const SidePicture* picture = pictureLaidOver(state_, Side::A);
    if (picture == nullptr) {
        return false;
    }
    if (path.isAt(settings::scene)) {
        return pictureLevel(state_.scene, parameterId).has_value();
    }
    if (path.isAt(kinds::transparency)) {
        return picture->transparency.has_value();
    }
    if (path.isAt(kinds::environment)) {
        return picture->environment.contains(parameterId);
    }
    const auto values = picture->shadows.find(static_cast<std::size_t>(path.index));
    return path.isAt(kinds::shadows) && values != picture->shadows.end() &&
           values->second.contains(parameterId);
}

void Document::showOwnPicture() {
    if (state_.picture && state_.picture->first) {
        ComparedPicture picture = *state_.picture;
        picture.first.reset();
        setPicture(std::move(picture));
    }
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
    const bool isAlike = first && state_.second && *first == *state_.second;
    if (!first || !state_.second || (isAlike && !state_.picture)) {
        return;
    }
    const Material formerFirst = *first;
    undoStack_.beginMacro(tr("Swap A and B"));
    if (state_.picture) {
        ComparedPicture swapped = *state_.picture;
        std::swap(swapped.first, swapped.second);
        setPicture(std::move(swapped));
    }
    replaceMaterial(Side::A, *state_.second, tr("Swap A and B"));
    setSecondMaterial(formerFirst);
    undoStack_.endMacro();
}

} // namespace patina
