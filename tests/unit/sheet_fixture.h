// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "catalog_fixture.h"
#include "material/block_values.h"
#include "scene/scene.h"

namespace patina::tests {

/// Returns a catalogue of two models, of which only one has a sheen, a light, a fog and an
/// environment.
inline std::shared_ptr<const Catalog> sheetCatalog() {
    static const auto made = [] {
        using nlohmann::json;
        BlockFolder folder;
        json velvet = plainDescriptor("velvet");
        velvet["parameters"].push_back({{"id", "sheen"},
                                        {"label", "Sheen"},
                                        {"type", "float"},
                                        {"default", 1.0},
                                        {"min", 0.5},
                                        {"max", 1000.0},
                                        {"scale", "log"}});
        velvet["parameters"].push_back({{"id", "weave"},
                                        {"label", "Weave"},
                                        {"type", "enum"},
                                        {"default", "plain"},
                                        {"values",
                                         {{{"id", "plain"}, {"label", "Plain weave"}},
                                          {{"id", "twill"}, {"label", "Twill"}}}}});
        velvet["parameters"].push_back(
            {{"id", "tint"}, {"label", "Tint"}, {"type", "color"}, {"default", {1, 1, 1}}});
        velvet["accuracy"] = {{{"id", "power"},
                               {"label", "Power"},
                               {"values",
                                {{{"id", "full"}, {"label", "Full"}, {"exact", true}},
                                 {{"id", "fast"}, {"label", "Fast"}}}}}};
        folder.add("models", velvet);
        folder.add("models", plainDescriptor("chalk"));
        folder.add("lights", plainDescriptor("lamp"));
        folder.add("environment", plainDescriptor("sky"));
        folder.add("fog", plainDescriptor("mist"));
        return std::make_shared<const Catalog>(folder.load());
    }();
    return made;
}

/// Makes a scene of a velvet ball under two lamps in mist.
inline Scene sheetScene() {
    const Catalog& catalog = *sheetCatalog();
    Scene scene;
    scene.objects.emplace_back().material = defaultMaterial(*catalog.find("models", "velvet"));
    const BlockValues lamp = defaultBlockValues(*catalog.find("lights", "lamp"));
    scene.lights = {{"Key", true, lamp}, {"Fill", true, lamp}};
    scene.setPart("fog", defaultBlockValues(*catalog.find("fog", "mist")));
    return scene;
}

} // namespace patina::tests
