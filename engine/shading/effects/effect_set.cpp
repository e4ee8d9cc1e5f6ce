// SPDX-License-Identifier: GPL-3.0-or-later
#include "shading/effects/effect_set.h"

#include <algorithm>

namespace patina {
namespace {

template <class Subject>
void chooseFrom(EffectSet& set, const Subject& subject) {
    set.each([&](auto& effect) {
        if constexpr (requires { effect.choose(subject, set); }) {
            effect.choose(subject, set);
        }
    });
    set.each([&](auto& effect) {
        if constexpr (requires { effect.adjust(set); }) {
            effect.adjust(set);
        }
    });
}

std::vector<EffectLine> listed(const EffectSet& set, const EffectSubject* subject) {
    EffectListing listing(subject);
    list(set, listing);
    return listing.take();
}

/// Tells whether an effect is listed, by its name or its kind.
bool isListed(const std::vector<EffectLine>& lines, const std::string& effect) {
    return std::ranges::any_of(lines, [&effect](const EffectLine& line) {
        return line.effect == effect || line.effect.starts_with(effect + '/') ||
               line.effect.starts_with(effect + ' ');
    });
}

} // namespace

void chooseEffects(EffectSet& set, const MaterialSubject& subject) {
    chooseFrom(set, subject);
}

void chooseEffects(EffectSet& set, const SceneSubject& subject) {
    chooseFrom(set, subject);
}

EffectSet sceneEffects(const Scene& scene, const Catalog& catalog, const EffectView& view) {
    EffectSet set;
    chooseEffects(set, SceneSubject{scene, catalog, view});
    return set;
}

EffectSet effectSet(const Material& material, const Scene& scene, const Catalog& catalog,
                    const EffectView& view) {
    EffectSet set;
    chooseEffects(set, MaterialSubject{material, catalog});
    chooseEffects(set, SceneSubject{scene, catalog, view});
    return set;
}

EffectSet groundEffects(const Scene& scene, const Catalog& catalog, const EffectView& view) {
    EffectSet set;
    chooseEffects(set, SceneSubject{scene, catalog, view, true});
    return set;
}

bool isLit(const EffectSet& set) {
    return set.model.has_value() || set.ground != GroundMode::Off;
}

bool dependsOnPlaces(const Scene& scene, const Catalog& catalog, std::string_view kind) {
    bool depends = false;
    EffectSet().each([&]<class Effect>(const Effect&) {
        if constexpr (requires { Effect::dependsOnPlaces(scene, catalog, kind); }) {
            depends = depends || Effect::dependsOnPlaces(scene, catalog, kind);
        }
    });
    return depends;
}

std::vector<EffectLine> effectLines(const EffectSet& set) {
    return listed(set, nullptr);
}

std::vector<EffectLine> effectLines(const EffectSet& set, const EffectSubject& subject) {
    return listed(set, &subject);
}

std::string unknownToReference(const EffectSet& set) {
    std::string unknown;
    set.each([&]<class Effect>(const Effect& effect) {
        constexpr bool writes = requires(SurfaceText & text) {
            effect.write(text);
        }
        || requires(SurfaceText & text) {
            effect.writeLight(text);
        };
        if constexpr (writes && !requires { Effect::isKnownToReference; }) {
            EffectListing listing(nullptr);
            effect.list(listing, set);
            const std::vector<EffectLine> lines = listing.take();
            if (unknown.empty() && !lines.empty()) {
                unknown = lines.front().effect;
            }
        }
    });
    return unknown;
}

std::vector<EffectLine> leftOut(const EffectSet& set, const EffectSubject& subject) {
    LeftOutListing listing(subject);
    listMissing(set, listing);
    return listing.take();
}

std::vector<EffectLine> leftOutLines(const EffectSet& set, const EffectSubject& subject) {
    const std::vector<EffectLine> in = effectLines(set, subject);
    std::vector<EffectLine> out = leftOut(set, subject);
    set.each([&](const auto& effect) {
        if constexpr (requires { effect.absent(set); }) {
            EffectLine line = effect.absent(set);
            if (!isListed(in, line.effect) && !isListed(out, line.effect)) {
                out.push_back(std::move(line));
            }
        }
    });
    return out;
}

} // namespace patina
