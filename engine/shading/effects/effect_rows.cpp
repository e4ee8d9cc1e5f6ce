// SPDX-License-Identifier: GPL-3.0-or-later
#include "shading/effects/effect_rows.h"

#include <algorithm>

#include "shading/effects/display_set.h"
#include "shading/effects/key_light.h"

namespace patina {
namespace {

std::vector<EffectLine> displayLines(const EffectSubject& subject) {
    EffectListing listing(&subject);
    list(displaySet(subject.scene, subject.catalog), listing);
    return listing.take();
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

/// Returns the scene with only the object that is looked at, one that casts shadows if any does,
/// and one that refracts light if a dark environment is in for it: which effects one object has
/// depends on no more.
Scene aloneIn(const Scene& scene, std::size_t object, const Catalog& catalog) {
    Scene alone = scene;
    alone.objects = {scene.objects[object]};
    if (const std::optional<std::size_t> key = keyLight(scene, catalog)) {
        for (Light& light : alone.lights) {
            light.isKey = &light == &alone.lights[*key];
        }
    }
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
EffectSet groundOf(const EffectSubject& subject) {
    EffectView view = subject.view;
    view.unreached.reset();
    return groundEffects(subject.scene, subject.catalog, view);
}

std::vector<EffectLine> objectLines(const EffectSubject& subject) {
    return effectLines(effectSet(*subject.material, subject.scene, subject.catalog, subject.view),
                       subject);
}

/// Returns what the whole picture has: its ground and what is done to it behind the objects.
std::vector<EffectLine> pictureLines(const EffectSubject& subject) {
    EffectListing ground(&subject);
    groundOf(subject).GroundEffect::list(ground, {});
    std::vector<EffectLine> lines = ground.take();
    append(lines, displayLines(subject));
    return lines;
}

/// Returns what is neither in the object's program nor in the ground's or the display's.
std::vector<EffectLine> missingLines(const EffectSubject& subject, const EffectSet& set) {
    std::vector<EffectLine> out = leftOutLines(set, subject);
    const EffectSubject withoutMaterial{nullptr, subject.scene, subject.catalog, subject.view};
    LeftOutListing rest(withoutMaterial);
    groundOf(subject).GroundEffect::listMissing(rest, set);
    listMissing(displaySet(subject.scene, subject.catalog), rest);
    append(out, rest.take());
    return out;
}

/// Takes one effect out of the scene, by its name.
void takeOut(Scene& scene, std::string_view name, const Catalog& catalog) {
    const std::size_t slash = name.find('/');
    const EffectName effect{name.substr(0, slash), slash == std::string_view::npos
                                                       ? std::string_view()
                                                       : name.substr(slash + 1)};
    remove<EffectSet>(scene, effect, catalog);
    remove<DisplaySet>(scene, effect, catalog);
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
        const EffectSubject subject{&without.objects.front().material, without, catalog, view};
        std::vector<EffectLine> left = objectLines(subject);
        append(left, pictureLines(subject));
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
    const EffectSubject subject{&scene.objects[object].material, scene, catalog, view};
    for (EffectLine& line : objectLines(subject)) {
        rows.push_back({std::move(line), true, false, {}});
    }
    for (EffectLine& line : pictureLines(subject)) {
        rows.push_back({std::move(line), true, false, {}, true});
    }
    findRemovable(rows, aloneIn(scene, object, catalog), catalog, view);
    const EffectSet set = effectSet(*subject.material, scene, catalog, view);
    for (EffectLine& line : missingLines(subject, set)) {
        rows.push_back({std::move(line), false, false, {}});
    }
    return rows;
}

Scene withoutEffects(Scene scene, std::span<const std::string> effects, const Catalog& catalog) {
    for (const std::string_view name : effects) {
        takeOut(scene, name, catalog);
    }
    return scene;
}

} // namespace patina
