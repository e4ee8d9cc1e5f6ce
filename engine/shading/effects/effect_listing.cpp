// SPDX-License-Identifier: GPL-3.0-or-later
#include "shading/effects/effect_listing.h"

#include <fmt/format.h>

namespace patina {

std::string effectName(std::string_view kind, std::string_view id) {
    return fmt::format("{}/{}", kind, id);
}

std::string effectName(const BlockUse& use) {
    return effectName(use.block().kind, use.block().id);
}

std::string compiledText(const BlockUse& use) {
    std::string text;
    for (const CompiledValue& value : use.compiled()) {
        text += fmt::format("{}{}={}", text.empty() ? "" : ", ", value.id, value.value);
    }
    return text;
}

void EffectListing::add(std::string effect, std::string detail, const Reason& reason) {
    lines_.push_back({std::move(effect), std::move(detail),
                      subject_ == nullptr ? std::string() : reason(*subject_)});
}

void EffectListing::add(const BlockUse& use, const Reason& reason) {
    add(effectName(use), compiledText(use), reason);
}

EffectListing::Reason always(std::string sentence) {
    return [sentence = std::move(sentence)](const EffectSubject&) { return sentence; };
}

std::string detailed(std::string detail, bool counts, std::string_view more) {
    if (counts) {
        detail += detail.empty() ? "" : ", ";
        detail += more;
    }
    return detail;
}

} // namespace patina
