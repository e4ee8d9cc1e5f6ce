// SPDX-License-Identifier: GPL-3.0-or-later
#include "shading/effects/effect_rows.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "shading/effects/effect_choice.h"
#include "shading/effects/refraction_choice.h"
#include "shading/effects/texture_choice.h"

namespace patina {
namespace {

/// What happens to the picture after the objects are drawn.
std::vector<EffectLine> displayLines(const Scene& scene) {
    std::vector<EffectLine> lines;
    if (scene.exposure != 0.0) {
        lines.push_back({"exposure",
                         {},
                         fmt::format("Everything is {:.4g} stops {}.", std::abs(scene.exposure),
                                     scene.exposure > 0.0 ? "brighter" : "darker")});
    }
    if (scene.toneMapping != ToneMapping::None) {
        lines.push_back({"tone mapping", {}, "What is too bright for a display is compressed."});
    }
    return lines;
}

std::vector<EffectLine> displayLeftOut(const Scene& scene) {
    std::vector<EffectLine> lines;
    if (scene.exposure == 0.0) {
        lines.push_back({"exposure", {}, "It is 0 stops."});
    }
    if (scene.toneMapping == ToneMapping::None) {
        lines.push_back({"tone mapping", {}, "None is chosen."});
    }
    return lines;
}

void append(std::vector<EffectLine>& lines, const std::vector<EffectLine>& more) {
    lines.insert(lines.end(), more.begin(), more.end());
}

/// Adds another object that shadows fall on.
void addReceiver(Scene& alone, const Scene& scene, std::size_t object) {
    for (std::size_t i = 0; i < scene.objects.size(); ++i) {
        if (i != object && scene.objects[i].visible && canBeSeen(scene.objects[i].material)) {
            alone.objects.push_back(scene.objects[i]);
            return;
        }
    }
}

/// Adds another object that shows a dark environment.
void addRefracting(Scene& alone, const Scene& scene, const Catalog& catalog) {
    Scene one;
    for (const Object& object : scene.objects) {
        one.objects = {object};
        if (hasRefraction(one, catalog)) {
            alone.objects.push_back(object);
            return;
        }
    }
}

/// The scene with only the object that is looked at, one that casts shadows if any does, and one
/// that bends light if a dark environment is in for it: which effects one object has depends on no
/// more.
Scene aloneIn(const Scene& scene, std::size_t object, const Catalog& catalog) {
    Scene alone;
    alone.lights = scene.lights;
    alone.parts = scene.parts;
    alone.ambient = scene.ambient;
    alone.hemisphere = scene.hemisphere;
    alone.ground = scene.ground;
    alone.exposure = scene.exposure;
    alone.toneMapping = scene.toneMapping;
    alone.accuracy = scene.accuracy;
    alone.objects = {scene.objects[object]};
    const auto caster = std::ranges::find_if(
        scene.objects, [&catalog](const Object& each) { return isCaster(each, catalog); });
    if (caster != scene.objects.end() && !isCaster(scene.objects[object], catalog)) {
        alone.objects.push_back(*caster);
    }
    if (environmentChoice(alone, catalog).block != environmentChoice(scene, catalog).block) {
        addRefracting(alone, scene, catalog);
    }
    if (hasShadows(scene, catalog) && !hasShadows(alone, catalog)) {
        addReceiver(alone, scene, object);
    }
    return alone;
}

/// The ground is lit by lights that do not reach the object.
EffectSet groundOf(const Scene& scene, const Catalog& catalog, EffectView view) {
    view.unreached.reset();
    return groundEffects(scene, catalog, view);
}

std::vector<EffectLine> linesOf(const Scene& scene, std::size_t object, const Catalog& catalog,
                                const EffectView& view) {
    std::vector<EffectLine> lines =
        effectLines(effectSet(scene.objects[object].material, scene, catalog, view));
    const EffectSet ground = groundOf(scene, catalog, view);
    if (ground.ground != GroundMode::Off) {
        lines.push_back(effectLines(ground).front());
    }
    append(lines, displayLines(scene));
    return lines;
}

bool has(const std::vector<EffectLine>& lines, const std::string& effect) {
    return std::any_of(lines.begin(), lines.end(),
                       [&effect](const EffectLine& line) { return line.effect == effect; });
}

/// Which rows go when one is left out says whether it can be, and what works through it: of several
/// that take a row along the last one has it, which itself works through those before.
void findRemovable(std::vector<EffectRow>& rows, const Scene& alone, const Catalog& catalog,
                   const EffectView& view) {
    for (EffectRow& row : rows) {
        const Scene without = withoutEffects(alone, {&row.line.effect, 1}, catalog);
        const std::vector<EffectLine> left = linesOf(without, 0, catalog, view);
        row.removable = !has(left, row.line.effect);
        for (EffectRow& other : rows) {
            const bool goesAlong = &other != &row && !has(left, other.line.effect);
            if (row.removable && goesAlong && row.within != other.line.effect) {
                other.within = row.line.effect;
            }
        }
    }
}

} // namespace

std::vector<EffectRow> effectRows(const Scene& scene, std::size_t object, const Catalog& catalog,
                                  const EffectView& view) {
    std::vector<EffectRow> rows;
    for (EffectLine& line : linesOf(scene, object, catalog, view)) {
        rows.push_back({std::move(line), true, false, {}});
    }
    findRemovable(rows, aloneIn(scene, object, catalog), catalog, view);
    const EffectSet set = effectSet(scene.objects[object].material, scene, catalog, view);
    std::vector<EffectLine> out = leftOutLines(set);
    const EffectSet ground = groundOf(scene, catalog, view);
    for (const LeftOut& left : ground.leftOut) {
        out.push_back({left.what, {}, left.reason});
    }
    append(out, displayLeftOut(scene));
    for (EffectLine& line : out) {
        rows.push_back({std::move(line), false, false, {}});
    }
    return rows;
}

} // namespace patina
