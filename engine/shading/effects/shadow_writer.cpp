// SPDX-License-Identifier: GPL-3.0-or-later
// The part of SurfaceWriter that writes shadows, the ground and the ambient light.
#include <algorithm>

#include <fmt/format.h>

#include "shading/effects/surface_writer.h"

namespace patina {
namespace {

/// "parallel" or "local": the file, and the functions in it.
const char* mapOf(const LightGroup& group) {
    return group.projection == ShadowProjection::Parallel ? "parallel" : "local";
}

/// How a point of a light with a map of one kind or the other calls it.
std::string dispatch(bool parallel, bool local, const std::string& name,
                     const std::string& arguments) {
    const std::string call = parallel ? "parallel" + name + arguments : "local" + name + arguments;
    return parallel && local ? fmt::format("s.isParallel ? {} : local{}{}", call, name, arguments)
                             : call;
}

/// A reason for nothing to arrive.
std::string arrivalGate(const char* condition) {
    return fmt::format("    if ({}) {{\n        return 0.0;\n    }}\n", condition);
}

bool claimsIsotropic(const Block& block) {
    return std::ranges::find(block.claims, "isotropic") != block.claims.end();
}

/// Whether the model, and what fills its slots, look the same however a surface is turned about its
/// normal. A Fresnel term knows no more than the angle of incidence.
bool isIsotropic(const ObjectLayout& object) {
    return claimsIsotropic(*object.model->block) &&
           std::ranges::all_of(object.slots, [](const BlockPlace& slot) {
               return slot.block->kind == kinds::fresnel || claimsIsotropic(*slot.block);
           });
}

} // namespace

bool SurfaceWriter::hasShadows() const {
    return std::any_of(scene_.groups.begin(), scene_.groups.end(),
                       [](const LightPlace& group) { return group.shadow.has_value(); });
}

/// What all shadows share. Of the two kinds of map only those are in the text that lights have.
void SurfaceWriter::writeShadowCode() {
    bool parallel = false;
    bool local = false;
    out_.add("#define SHADOW_DATA(i) sceneData[base + (i)]\n");
    out_.addFile("passes/shadow.glsl");
    for (const LightGroup& group : set_.scene.lights) {
        if (group.shadow) {
            const bool isParallel = group.projection == ShadowProjection::Parallel;
            (isParallel ? parallel : local) = true;
            out_.addFile(fmt::format("passes/shadow_{}.glsl", mapOf(group)));
        }
    }
    out_.add(fmt::format("ShadowRay shadowRay(ShadowPoint s, vec2 offset) {{\n    return {};\n}}\n"
                         "vec4 shadowDepths(ShadowPoint s, vec4 stored) {{\n    return {};\n}}\n",
                         dispatch(parallel, local, "ShadowRay", "(s, offset)"),
                         dispatch(parallel, local, "ShadowDepths", "(s, stored)")));
    out_.addFile("passes/shadow_taps.glsl");
    main_ += "    shadowFace = faceNormal(s.v);\n    shadowLift = shadingNormal(s.v);\n"
             "    shadowAside = shadowInset(s.v);\n";
}

/// `arriving<index>`: the share of a light of this group that nothing keeps away; 0 where the model
/// asks for none.
void SurfaceWriter::writeShadow(std::size_t index) {
    const LightPlace& group = scene_.groups[index];
    const LightGroup& effect = set_.scene.lights[index];
    const Block& block = *group.shadow->block;
    const std::string unpack = fmt::format("unpack{}{}", structName(block), index);
    writeBlock(block);
    writeUnpack(block, *effect.shadow, unpack);
    std::string gates;
    if (group.light.block->reach && effect.lines == 0) {
        gates += arrivalGate("!(max(max(light.radiance.r, light.radiance.g), "
                             "light.radiance.b) > 0.0)");
    }
    if (!isLitFromBehind()) {
        gates += arrivalGate("dot(s.n, light.l) <= 0.0");
    }
    out_.add(fmt::format("float arriving{0}(Surface s, Illumination light, int base) {{\n"
                         "{1}"
                         "    ShadowView view = shadowViewAt(base + {2});\n"
                         "    ShadowPoint point = shadowPoint(s, light.l, view, {3});\n"
                         "    return clamp({4}(point, {5}(base + {6})), 0.0, 1.0);\n"
                         "}}\n",
                         index, gates, group.shadow->first + group.shadow->vec4s(),
                         effect.projection == ShadowProjection::Parallel, functionName(block),
                         unpack, group.shadow->first));
}

/// What the model makes of light from all around.
std::string SurfaceWriter::ambientShare() {
    out_.addFile("passes/ambient.glsl");
    if (!isIsotropic(object_)) {
        return "ambientShare(s, model)";
    }
    out_.addFile("passes/levelled.glsl");
    return "ambientShare(levelled(s), model)";
}

void SurfaceWriter::writeAmbient() {
    if (set_.scene.ambient) {
        main_ += fmt::format("    shaded += sceneData[{}].rgb * {};\n", SceneLayout::ambient,
                             ambientShare());
        noteTerm("AMBIENT", fmt::format("sceneData[{}].rgb * modelled", SceneLayout::ambient),
                 "0.0");
    }
}

/// What the sky and the ground of the ambient light send to a surface.
std::string SurfaceWriter::hemisphereSource() const {
    const int first = *scene_.hemisphere;
    return fmt::format("hemisphereLight(s, sceneData[{}].rgb, sceneData[{}].rgb, "
                       "sceneData[{}].xyz)",
                       first, first + 1, first + 2);
}

void SurfaceWriter::writeHemisphere() {
    if (!scene_.hemisphere) {
        return;
    }
    out_.addFile("passes/hemisphere.glsl");
    const std::string light = hemisphereSource();
    main_ += fmt::format("    shaded += {} * {};\n", light, ambientShare());
    noteTerm("AMBIENT", light + " * modelled", "0.0");
}

/// A surface without a model: how much light arrives, and how much was sent.
void SurfaceWriter::writeGround() {
    const bool isPlane = set_.ground == GroundMode::Plane;
    out_.add(fmt::format("#define GROUND {}\n#define IS_DARK(d) ((d).nl <= 0.0)\n"
                         "#define IS_UNLIT(nl) ((nl) <= 0.0)\n"
                         "#define CUT_AT_ZERO(color) (color)\n",
                         *object_.ground));
    out_.addFile("passes/ground.glsl");
    out_.addFile(isPlane ? "passes/ground_plane.glsl" : "passes/ground_shadows.glsl");
    main_ += isPlane ? "    Model model = unpackModel(0);\n"
                     : "    Model model = unpackModel(0);\n    sent = vec3(0.0);\n";
    writeLights();
    if (set_.scene.ambient) {
        addToGround(fmt::format("sceneData[{}].rgb", SceneLayout::ambient));
    }
    if (scene_.hemisphere) {
        out_.addFile("passes/hemisphere.glsl");
        addToGround(hemisphereSource());
    }
    if (scene_.environment != nullptr) {
        addToGround(fmt::format("objectData[{}].rgb", *object_.ground + 2));
    }
    if (isPlane) {
        main_ += "    shaded = groundColored(shaded);\n";
        alpha_ = "groundShare()";
        return;
    }
    stored_ = scene_.fog ? fmt::format("groundDarkened(shaded, sent, groundShare() * "
                                       "fogShare(fogRay(s), unpackFog({})))",
                                       scene_.fog->first)
                         : "groundDarkened(shaded, sent, groundShare())";
}

/// Light from all around, of which shadows take nothing away.
void SurfaceWriter::addToGround(const std::string& light) {
    main_ += fmt::format("    shaded += {};\n", light);
    if (set_.ground == GroundMode::Shadows) {
        main_ += fmt::format("    sent += {};\n", light);
    }
}

} // namespace patina
