// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <tuple>
#include <utility>

#include "shading/effects/effect_parts.h"

namespace patina {

/// Holds the choices of some effects, each with its own members.
template <class... Effects>
struct EffectChoices : Effects... {
    /// Calls `visit` with each effect in order.
    template <class Visit>
    void each(const Visit& visit) const {
        (visit(static_cast<const Effects&>(*this)), ...);
    }
    template <class Visit>
    void each(const Visit& visit) {
        (visit(static_cast<Effects&>(*this)), ...);
    }

    /// Visits all from the last one to the first.
    template <class Visit>
    void eachBackwards(const Visit& visit) const {
        const auto all = std::tie(static_cast<const Effects&>(*this)...);
        [&]<std::size_t... i>(std::index_sequence<i...>) {
            (visit(std::get<sizeof...(Effects) - 1 - i>(all)), ...);
        }
        (std::index_sequence_for<Effects...>());
    }

    friend bool operator==(const EffectChoices&, const EffectChoices&) = default;
};

/// Lists what is in the program of a set, in its order.
template <class Set>
void list(const Set& set, EffectListing& listing) {
    set.each([&](const auto& effect) {
        if constexpr (requires { effect.list(listing, set); }) {
            effect.list(listing, set);
        }
    });
}

/// Lists what the document has and the program of a set has not.
template <class Set>
void listMissing(const Set& set, LeftOutListing& listing) {
    set.each([&](const auto& effect) {
        if constexpr (requires { effect.listMissing(listing, set); }) {
            effect.listMissing(listing, set);
        }
    });
}

/// Takes an effect of this name out of the scene, where one of the set has it.
template <class Set>
void remove(Scene& scene, const EffectName& name, const Catalog& catalog) {
    Set().each([&]<class Effect>(const Effect&) {
        if constexpr (requires { Effect::remove(scene, name, catalog); }) {
            Effect::remove(scene, name, catalog);
        }
    });
}

} // namespace patina
