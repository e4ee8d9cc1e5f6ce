// SPDX-License-Identifier: GPL-3.0-or-later
#include "shading/effects/spectral_range.h"

#include <fmt/format.h>

#include "catalog/fills.h"
#include "catalog/spectrum.h"

namespace patina {

std::string spectralRangeNote(const Block& block, const Values& values, const Scene& scene) {
    for (const Parameter& parameter : block.parameters) {
        const EnumValue* choice = spectralChoice(parameter, values);
        if (choice == nullptr) {
            continue;
        }
        for (const auto& [id, fill] : choice->fills) {
            const NumberList* spectrum = spectrumIn(fill);
            const auto [from, to] = spectrum == nullptr ? std::pair(0.0, 1e30) : rangeOf(*spectrum);
            for (int channel = 0; channel < 3; ++channel) {
                const double nm = scene.wavelengths[channel];
                if (!(nm >= from && nm <= to)) {
                    return fmt::format(
                        " {} is known from {:.0f} to {:.0f} nm: {:.0f} nm counts as the nearest.",
                        choice->label, from, to, nm);
                }
            }
        }
    }
    return {};
}

} // namespace patina
