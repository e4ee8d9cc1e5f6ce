// SPDX-License-Identifier: GPL-3.0-or-later
// Programs that a long row of edits needs.
#include <algorithm>
#include <functional>
#include <set>
#include <string>
#include <vector>

#include "gpu_fixture.h"
#include "render/surfaces/scene_depth.h"
#include "shading/effects/effect_set.h"
#include "support/program.h"

namespace patina::editing_session_test {
namespace {

using Edit = std::function<void(Scene&)>;

class EditingSession : public GpuTest {
  protected:
    /// Everything once: each block of every kind, and what else is in the effect set.
    std::vector<Edit> edits() const {
        std::vector<Edit> all;
        for (const Block* each : catalog->ofKind("models")) {
            const BlockValues model = block("models", each->id);
            all.emplace_back([model](Scene& s) { s.objects[0].material.model = model; });
        }
        for (const std::string_view kind : partKinds(BlockOwner::Material)) {
            const std::string name(kind);
            for (const Block* each : catalog->ofKind(kind)) {
                const BlockValues part = block(name, each->id);
                all.emplace_back([name, part](Scene& s) {
                    s.objects[0].material.opacity = name == "refraction" ? 0.5 : 1.0;
                    s.objects[0].material.parts[name] = part;
                });
            }
            all.emplace_back([name](Scene& s) { s.objects[0].material.parts.erase(name); });
        }
        for (const Block* each : catalog->ofKind("lights")) {
            const Light made = light(each->id);
            all.emplace_back([made](Scene& s) { s.lights = {made}; });
        }
        for (const Block* each : catalog->ofKind("shadows")) {
            const BlockValues made = block("shadows", each->id);
            all.emplace_back([made](Scene& s) { s.lights[0].setPart(kinds::shadows, made); });
        }
        for (const Block* each : catalog->ofKind("fog")) {
            const BlockValues made = block("fog", each->id);
            all.emplace_back([made](Scene& s) { s.setPart(kinds::fog, made); });
        }
        for (const Block* each : catalog->ofKind("transparency")) {
            const BlockValues made = block("transparency", each->id);
            all.emplace_back([made](Scene& s) {
                s.objects[0].material.opacity = 0.5;
                s.setPart(kinds::transparency, made);
            });
        }
        all.insert(all.end(), {
                                  [](Scene& s) { s.setPart(kinds::transparency, std::nullopt); },
                                  [](Scene& s) { s.objects[0].material.opacity = 1.0; },
                                  [](Scene& s) { s.ambient = glm::dvec3(0.1); },
                                  [](Scene& s) { s.hemisphere.sky = glm::dvec3(0.2); },
                                  [](Scene& s) { s.ground.mode = GroundMode::Plane; },
                                  [](Scene& s) { s.ground.mode = GroundMode::Shadows; },
                                  [](Scene& s) { s.exposure = 1.0; },
                                  [](Scene& s) { s.setPart(kinds::tone, std::nullopt); },
                                  [](Scene& s) { s.setPart(kinds::fog, std::nullopt); },
                              });
        return all;
    }

    /// Counts over a session from the first edit to the last, and to the first again.
    struct Session {
        int compiled = 0;
        std::size_t sets = 0; ///< different ones that were seen
    };

    static std::string toneOf(const Scene& scene) {
        const BlockValues* tone = scene.part(kinds::tone);
        return tone == nullptr ? "plain" : tone->id;
    }

    /// How much of the device's work that is no surface's is seen: each kind of pass has a program.
    static std::vector<std::string> passesOf(const EffectSet& set, const Scene& scene) {
        std::vector<std::string> passes{"display " + toneOf(scene) +
                                        (scene.exposure == 0.0 ? " plain" : " exposed")};
        for (const LightGroup& group : set.lights) {
            if (group.shadow) {
                passes.emplace_back("shadow map");
            }
        }
        if (set.outline) {
            passes.push_back("outline " + set.outline->block().id);
        }
        if (set.shells) {
            passes.push_back("fins " + set.shells->block().id);
        }
        if (set.strokes) {
            passes.push_back("marks " + set.strokes->block().id);
        }
        if (set.refraction) {
            passes.emplace_back("back of a body");
        }
        if (set.isShownRefracted) {
            passes.emplace_back("reach of what is behind a body");
        }
        if (set.transparency && isVisiblyTransparent(set)) {
            passes.push_back("layers " + set.transparency->block().id);
            passes.push_back("their sum " + set.transparency->block().id);
        }
        return passes;
    }

    Session edit() {
        makeRenderer(folder_ / "programs");
        Session session;
        std::vector<EffectSet> sets;
        std::set<std::string> passes;
        Scene scene = simpleScene("lambert");
        const auto see = [&](const EffectSet& set) {
            if (std::ranges::find(sets, set) == sets.end()) {
                sets.push_back(set);
            }
            passes.merge([&] {
                const auto of = passesOf(set, scene);
                return std::set<std::string>(of.begin(), of.end());
            }());
        };
        const std::vector<Edit> all = edits();
        for (std::size_t i = 0; i < 2 * all.size(); ++i) { // undone and done again
            all[i % all.size()](scene);
            capture(scene, true);
            session.compiled += renderer->report().compiled;
            const EffectView view = effectView(scene, scene.camera, *catalog, meshSource());
            see(effectSet(scene.objects[0].material, scene, *catalog,
                          objectView(scene, 0, *catalog, meshSource())));
            const EffectSet ground = groundEffects(scene, *catalog, view);
            if (ground.ground != GroundMode::Off) {
                see(ground);
            }
        }
        session.sets = sets.size() + passes.size();
        renderer.reset();
        return session;
    }

    tests::TemporaryFolder folder_;
};

TEST_F(EditingSession, TouchingEverythingOnce_CompilesNoMoreThanEffectSetsAreSeen) {
    const Session first = edit();
    EXPECT_GT(first.compiled, 40);
    EXPECT_LE(first.compiled, static_cast<int>(first.sets));
    EXPECT_EQ(edit().compiled, 0); // the next start
}

} // namespace
} // namespace patina::editing_session_test
