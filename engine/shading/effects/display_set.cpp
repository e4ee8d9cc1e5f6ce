// SPDX-License-Identifier: GPL-3.0-or-later
#include "shading/effects/display_set.h"

namespace patina {

DisplaySet displaySet(const Scene& scene, const Catalog& catalog) {
    DisplaySet set;
    set.each([&](auto& effect) { effect.choose(scene, catalog); });
    return set;
}

std::uint64_t keyOf(const DisplaySet& set) {
    ChoiceHash hash;
    set.each([&hash](const auto& effect) { effect.addTo(hash); });
    return hash.value();
}

/// What comes first in the picture is declared last.
Checked<ProgramSource> displayProgram(const DisplaySet& set, const Catalog& catalog) {
    return screenProgram(catalog, [&set](SourceBuilder& fragment) {
        set.eachBackwards([&fragment](const auto& effect) {
            if constexpr (requires { effect.write(fragment); }) {
                effect.write(fragment);
            }
        });
        fragment.addFile("passes/display.frag");
    });
}

} // namespace patina
