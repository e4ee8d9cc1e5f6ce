// SPDX-License-Identifier: GPL-3.0-or-later
#include "shading/effects/ground_effect.h"

#include <fmt/format.h>

#include "shading/effects/data_layout.h"
#include "shading/effects/effect_set.h"
#include "shading/effects/shadows.h"
#include "shading/effects/surface_text.h"

namespace patina {
namespace {

std::string groundText(const EffectSubject& subject) {
    const Ground& ground = subject.scene.ground;
    return fmt::format("{}, opacity {:.3g}.",
                       ground.mode == GroundMode::Plane ? "A matt plane that the lights shine on"
                                                        : "It shows the shadows that fall on it",
                       ground.opacity);
}

/// Adds light from all around, of which shadows take nothing away.
void addEvenLight(SurfaceText& text, const std::string& light) {
    text.main += fmt::format("    shaded += {};\n", light);
    if (text.set.ground == GroundMode::Shadows) {
        text.main += fmt::format("    sent += {};\n", light);
    }
}

void writeEvenLight(SurfaceText& text) {
    if (text.set.ambient) {
        addEvenLight(text, fmt::format("sceneData[{}].rgb", SceneLayout::ambient));
    }
    if (text.set.hemisphere) {
        addEvenLight(text, hemisphereLight(text));
    }
    if (text.set.environment) {
        addEvenLight(text, fmt::format("objectData[{}].rgb", *text.object.ground + 2));
    }
}

} // namespace

void GroundEffect::choose(const SceneSubject& subject, const EffectSet&) {
    const Ground& wanted = subject.scene.ground;
    ground = subject.isGround && isSeen(wanted) ? wanted.mode : GroundMode::Off;
}

void GroundEffect::adjust(const EffectSet& set) {
    if (ground == GroundMode::Shadows && !hasShadows(set)) {
        ground = GroundMode::Off;
    }
}

void GroundEffect::list(EffectListing& listing, const EffectSet&) const {
    if (ground != GroundMode::Off) {
        listing.add("ground", {}, groundText);
    }
}

void GroundEffect::listMissing(LeftOutListing& listing, const EffectSet&) const {
    const Ground& wanted = listing.subject().scene.ground;
    if (listing.subject().material != nullptr || ground != GroundMode::Off) {
        return;
    }
    listing.add("ground", wanted.mode == GroundMode::Off ? "The scene has no ground."
                          : !isSeen(wanted)              ? "Its opacity is 0."
                                            : "It shows shadows only, and no light has any.");
}

void GroundEffect::place(ObjectLayout& layout, const EffectSet& set) const {
    if (ground != GroundMode::Off) {
        layout.ground = layout.vec4s;
        layout.vec4s += set.environment ? 3 : 2;
    }
}

/// Writes a surface without a model: how much light arrives, and how much was sent.
void GroundEffect::writeLight(SurfaceText& text) const {
    if (ground == GroundMode::Off) {
        return;
    }
    const bool isPlane = ground == GroundMode::Plane;
    text.out.add(fmt::format("#define GROUND {}\n#define IS_DARK(d) ((d).nl <= 0.0)\n"
                             "#define IS_UNLIT(nl) ((nl) <= 0.0)\n"
                             "#define CUT_AT_ZERO(color) (color)\n",
                             *text.object.ground));
    text.out.addFile("passes/ground.glsl");
    text.out.addFile(isPlane ? "passes/ground_plane.glsl" : "passes/ground_shadows.glsl");
    text.main += isPlane ? "    Model model = unpackModel(0);\n"
                         : "    Model model = unpackModel(0);\n    sent = vec3(0.0);\n";
    writeLights(text);
    writeEvenLight(text);
    if (isPlane) {
        text.main += "    shaded = groundColored(shaded);\n";
        text.alpha = "groundShare()";
        return;
    }
    const BlockPlace* fog = text.scene.part(kinds::fog);
    text.stored = fog != nullptr ? fmt::format("groundDarkened(shaded, sent, groundShare() * "
                                               "fogShare(fogRay(s), unpackFog({})))",
                                               fog->first)
                                 : "groundDarkened(shaded, sent, groundShare())";
}

void GroundEffect::remove(Scene& scene, const EffectName& effect, const Catalog&) {
    if (effect.kind == "ground") {
        scene.ground.mode = GroundMode::Off;
    }
}

} // namespace patina
