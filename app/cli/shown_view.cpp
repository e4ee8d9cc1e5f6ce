// SPDX-License-Identifier: GPL-3.0-or-later
#include "cli/shown_view.h"

#include <algorithm>
#include <cstddef>
#include <string_view>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "scene/scene_assignment.h"

namespace patina {
namespace {

constexpr std::string_view lightWord = "light=";

struct NamedView {
    std::string_view word;
    InspectedView view = InspectedView::Numbers;
};

constexpr NamedView namedViews[] = {
    {"numbers", InspectedView::Numbers},         {"energy", InspectedView::Energy},
    {"normals", InspectedView::Normals},         {"tangents", InspectedView::Tangents},
    {"coordinates", InspectedView::Coordinates}, {"fresnel", InspectedView::Fresnel},
    {"diffuse", InspectedView::Diffuse},         {"highlight", InspectedView::Highlight},
    {"occlusion", InspectedView::Occlusion},     {"glow", InspectedView::Glow},
    {"opacity", InspectedView::Opacity},
};

} // namespace

Result<Inspected> shownView(const std::string& word, const Scene& scene) {
    if (word.starts_with(lightWord)) {
        const std::string name = word.substr(lightWord.size());
        Scene named = scene;
        const Light* light = lightNamed(named, name);
        if (light == nullptr) {
            return failure(fmt::format("there is no light \"{}\"", name),
                           expectedLights(scene, name));
        }
        return Inspected(InspectedView::Light,
                         static_cast<std::size_t>(light - named.lights.data()));
    }
    const auto* const found = std::ranges::find(namedViews, word, &NamedView::word);
    if (found == std::end(namedViews)) {
        return failure(fmt::format("\"{}\" is nothing that can be shown", word), shownViewWords());
    }
    return Inspected(found->view);
}

std::string shownViewWords() {
    std::vector<std::string_view> words;
    for (const NamedView& each : namedViews) {
        words.push_back(each.word);
    }
    return fmt::format("{} or light=NAME", fmt::join(words, ", "));
}

} // namespace patina
