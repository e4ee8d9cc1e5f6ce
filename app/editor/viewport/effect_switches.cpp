// SPDX-License-Identifier: GPL-3.0-or-later
#include "viewport/effect_switches.h"

#include <algorithm>
#include <utility>

#include "document/compare_edits.h"
#include "shading/effects/effect_rows.h"

namespace patina {

EffectSwitches::EffectSwitches(Document& document, ProgramEffects& effects, TriedMaterial& tried,
                               QObject* parent)
    : QObject(parent), document_(document), programs_(effects), tried_(tried) {
    onChange(document, DocumentChange::Drawn | DocumentChange::Current, this,
             &EffectSwitches::forget);
    connect(&effects, &ProgramEffects::changed, this, &EffectSwitches::forget);
    onChange(document, DocumentChange::Scene, this, [this] {
        if (!std::exchange(off_, {}).empty()) {
            Q_EMIT changed();
        }
    });
    // off() may mean other switches after these changes.
    onChange(document,
             DocumentChange::OwnView | DocumentChange::Comparing | DocumentChange::Current, this,
             &EffectSwitches::follow);
    connect(&tried, &TriedMaterial::changed, this, [this] {
        forget();
        Q_EMIT changed();
    });
}

void EffectSwitches::follow() {
    if (shown_ != off()) {
        shown_ = off();
        Q_EMIT changed();
    }
}

const std::vector<std::string>& EffectSwitches::offOn(Side side) const {
    const OwnView& own = ownView(document_.state(), side);
    return own.switchedOff ? *own.switchedOff : off_;
}

bool EffectSwitches::isOff(std::string_view effect) const {
    return std::ranges::find(off(), effect) != off().end();
}

void EffectSwitches::setOff(const std::string& effect, bool off) {
    if (off == isOff(effect)) {
        return;
    }
    std::vector<std::string> all = this->off();
    if (off) {
        all.push_back(effect);
    } else {
        std::erase(all, effect);
    }
    setSwitchedOff(std::move(all), off ? tr("Switch an effect off") : tr("Switch an effect on"));
}

void EffectSwitches::switchAllOn() {
    setSwitchedOff({}, tr("Switch all effects on"));
}

void EffectSwitches::setSwitchedOff(std::vector<std::string> off, const QString& label) {
    const Side side = document_.selection().side();
    OwnView own = ownView(document_.state(), side);
    if (own.switchedOff) {
        own.switchedOff = std::move(off);
        setOwnView(document_, side, own, label);
        return;
    }
    if (off != off_) {
        off_ = std::move(off);
        shown_ = off_;
        forget();
        Q_EMIT changed();
    }
}

const Scene& EffectSwitches::scene(Side side) {
    const Scene* tried = tried_.scene(side);
    if (tried == nullptr && ownView(document_.state(), side).switchedOff) {
        return whole(side);
    }
    const Scene& all = tried ? *tried : document_.scene(side);
    if (offOn(side).empty()) {
        return all;
    }
    std::optional<Scene>& made = scenes_[indexOf(side)];
    if (!made) {
        made = withoutEffects(all, offOn(side), document_.catalog());
    }
    return *made;
}

const Scene& EffectSwitches::whole(Side side) {
    const OwnView& own = ownView(document_.state(), side);
    if (!own.switchedOff || own.switchedOff->empty()) {
        return document_.scene(side);
    }
    std::optional<Scene>& made = wholes_[indexOf(side)];
    if (!made) {
        made = withoutEffects(document_.scene(side), *own.switchedOff, document_.catalog());
    }
    return *made;
}

/// A value that is dragged also changes the scene that ProgramEffects holds, so this one is made
/// for every frame.
const Scene* EffectSwitches::effects(Side side) {
    const Scene* held = programs_.scene(side);
    if (held == nullptr || offOn(side).empty()) {
        return held;
    }
    return &effects_[indexOf(side)].emplace(
        withoutEffects(*held, offOn(side), document_.catalog()));
}

void EffectSwitches::forget() {
    scenes_ = {};
    wholes_ = {};
    effects_ = {};
}

} // namespace patina
