// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/effect_switches.h"

#include <algorithm>

#include "shading/effects/effect_rows.h"

namespace patina {

EffectSwitches::EffectSwitches(Document& document, ProgramEffects& effects, TriedMaterial& tried,
                               QObject* parent)
    : QObject(parent), document_(document), programs_(effects), tried_(tried) {
    onChange(document, DocumentChange::Drawn | DocumentChange::Current, this,
             &EffectSwitches::forget);
    connect(&effects, &ProgramEffects::changed, this, &EffectSwitches::forget);
    onChange(document, DocumentChange::Scene, this, &EffectSwitches::switchAllOn);
    connect(&tried, &TriedMaterial::changed, this, [this] {
        forget();
        Q_EMIT changed();
    });
}

bool EffectSwitches::isOff(std::string_view effect) const {
    return std::find(off_.begin(), off_.end(), effect) != off_.end();
}

void EffectSwitches::setOff(const std::string& effect, bool off) {
    if (off == isOff(effect)) {
        return;
    }
    if (off) {
        off_.push_back(effect);
    } else {
        std::erase(off_, effect);
    }
    forget();
    Q_EMIT changed();
}

void EffectSwitches::switchAllOn() {
    forget();
    if (!off_.empty()) {
        off_.clear();
        Q_EMIT changed();
    }
}

const Scene& EffectSwitches::scene(Side side) {
    const Scene* tried = tried_.scene(side);
    const Scene& whole = tried ? *tried : document_.scene(side);
    if (off_.empty()) {
        return whole;
    }
    std::optional<Scene>& made = scenes_[indexOf(side)];
    if (!made) {
        made = withoutEffects(whole, off_, document_.catalog());
    }
    return *made;
}

/// A value that is dragged changes the held scene too, so this one is made for every frame.
const Scene* EffectSwitches::effects(Side side) {
    const Scene* held = programs_.scene(side);
    if (held == nullptr || off_.empty()) {
        return held;
    }
    return &effects_[indexOf(side)].emplace(withoutEffects(*held, off_, document_.catalog()));
}

void EffectSwitches::forget() {
    scenes_ = {};
    effects_ = {};
}

} // namespace patina
