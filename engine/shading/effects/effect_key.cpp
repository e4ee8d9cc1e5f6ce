// SPDX-License-Identifier: GPL-3.0-or-later
#include "shading/effects/effect_key.h"

#include "shading/effects/display_set.h"

namespace patina {
namespace {

/// Hashes the choices of the effects that are chosen from such a subject.
template <class Subject>
std::uint64_t hashOf(const EffectSet& set) {
    ChoiceHash hash;
    set.each([&]<class Effect>(const Effect& effect) {
        if constexpr (requires(Effect chosen, const Subject& subject) {
                          chosen.choose(subject, set);
                          effect.addTo(hash);
                      }) {
            effect.addTo(hash);
        }
    });
    return hash.value();
}

} // namespace

std::uint64_t EffectKey::ofScene(const Scene& scene, const Catalog& catalog,
                                 const EffectView& view) {
    chooseEffects(set_, SceneSubject{scene, catalog, view});
    return hashOf<SceneSubject>(set_);
}

std::uint64_t EffectKey::ofMaterial(const Material& material, const Catalog& catalog) {
    EffectSet set;
    chooseEffects(set, MaterialSubject{material, catalog});
    return hashOf<MaterialSubject>(set);
}

std::uint64_t EffectKey::ofEnvironment(const Scene& scene, const Catalog& catalog) {
    static const EffectView anyView;
    EffectSet set;
    set.EnvironmentEffect::choose({scene, catalog, anyView}, set);
    ChoiceHash hash;
    set.EnvironmentEffect::addTo(hash);
    return set.environment ? hash.value() : 0;
}

std::uint64_t EffectKey::ofDisplay(const Scene& scene, const Catalog& catalog) {
    return keyOf(displaySet(scene, catalog));
}

std::uint64_t EffectKey::ofLight(const Light& light, const Catalog& catalog, bool hasShadows) {
    return lightKey(light, catalog, hasShadows);
}

} // namespace patina
