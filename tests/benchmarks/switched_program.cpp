// SPDX-License-Identifier: GPL-3.0-or-later
#include "switched_program.h"

#include <algorithm>
#include <cstdlib>

#include <epoxy/gl.h>
#include <fmt/format.h>
#include <glm/matrix.hpp>

#include "catalog/table_source.h"
#include "gl/shader.h"
#include "material/block_values.h"
#include "material/measured_preset.h"
#include "render/gpu/binding.h"
#include "render/pass/data_packer.h"
#include "shading/effects/data_layout.h"
#include "shading/program/block_source.h"
#include "shading/program/parameter_packer.h"
#include "shading/program/program_source.h"

namespace patina::benchmarks {
namespace {

/// Where things are in objectData: what is chosen, then the values of what that is.
constexpr int choices = 1; ///< x: model, y: blending term, z: slot's term, w: slot's highlight
constexpr int modelAt = 2;
constexpr int slotAt = 20;
constexpr int objectVec4s = 40;

/// These are places in sceneData: the ambient colour, the kind of fog and its values, the lights.
constexpr int fogKind = 1;
constexpr int fogAt = 2;
constexpr int lightCount = 8;
constexpr int lightsAt = 9; ///< of each: its kind, then its values
constexpr int lightVec4s = 8;

std::string unpackName(const Block& block) {
    return "unpack" + structName(block);
}

void addBlock(SourceBuilder& out, const Block& block, const std::vector<SlotFill>& slots = {}) {
    out.add(constantsSource(block) + structSource(block));
    out.add(tableDeclarations(block));
    out.addFile(block.shaderFile);
    out.add(computedTables(block));
    out.add(unpackSource(block, {unpackName(block), {}, slots}));
}

/// Calls one of the blocks by its number: {0} is its function, {1} what fills its struct.
std::string chosen(const std::vector<const Block*>& blocks, const std::string& kind,
                   const char* call) {
    std::string text;
    for (std::size_t i = 0; i < blocks.size(); ++i) {
        text += fmt::format(
            "    if ({} == {}) {{\n        return {};\n    }}\n", kind, i + 1,
            fmt::format(fmt::runtime(call), functionName(*blocks[i]), unpackName(*blocks[i])));
    }
    return text;
}

/// Calls the block chosen by `kind` with the values that begin at a place.
std::string chosenAt(const std::vector<const Block*>& blocks, const char* call, int place) {
    return chosen(blocks, "kind", fmt::format(fmt::runtime(call), place).c_str());
}

/// What models call for their slots, whatever fills them.
void addSlots(SourceBuilder& out, const Catalog& catalog) {
    for (const char* kind : {"fresnel", "specular"}) {
        const std::string slot = slotStructName(kind);
        for (const Block* block : catalog.ofKind(kind)) {
            addBlock(out, *block);
        }
        out.add(fmt::format("struct {0} {{\n    int kind;\n}};\n"
                            "{0} unpack{0}(int base) {{\n    {0} p;\n"
                            "    p.kind = int(objectData[{1}].{2});\n    return p;\n}}\n",
                            slot, choices, kind == std::string("fresnel") ? "z" : "w"));
    }
    out.add("vec3 slotFresnel(Incidence i, FresnelSlot p) {\n" +
            chosen(catalog.ofKind("fresnel"), "p.kind",
                   fmt::format("{{0}}(i, {{1}}({}))", slotAt).c_str()) +
            "    return vec3(0.0);\n}\n");
    out.add("vec3 slotSpecular(Directions d, SpecularSlot p) {\n" +
            chosen(catalog.ofKind("specular"), "p.kind",
                   fmt::format("{{0}}(d, {{1}}({}))", slotAt).c_str()) +
            "    return vec3(0.0);\n}\n");
}

void addModels(SourceBuilder& out, const std::vector<const Block*>& models) {
    for (const Block* model : models) {
        std::vector<SlotFill> slots;
        for (const Slot& slot : model->slots) {
            slots.push_back({slot.kind, 0});
        }
        addBlock(out, *model, slots);
    }
    out.add(fmt::format("vec3 shadeAny(Directions d) {{\n"
                        "    int kind = int(objectData[{}].x);\n{}    return vec3(0.0);\n}}\n",
                        choices, chosenAt(models, "{{0}}(d, {{1}}({}))", modelAt)));
}

void addLights(SourceBuilder& out, const Catalog& catalog) {
    out.add(unpackedFrom("sceneData"));
    for (const Block* light : catalog.ofKind("lights")) {
        addBlock(out, *light);
    }
    out.addFile("lib/illumination.glsl");
    out.add("Illumination anyLight(vec3 x, int at) {\n    int kind = int(sceneData[at].x);\n" +
            chosen(catalog.ofKind("lights"), "kind", "{0}(x, {1}(at + 1))") +
            "    Illumination none;\n    none.l = vec3(0.0, 1.0, 0.0);\n"
            "    none.radiance = vec3(0.0);\n    return none;\n}\n");
}

void addFog(SourceBuilder& out, const Catalog& catalog) {
    const std::vector<const Block*> kinds = catalog.ofKind("fog");
    out.addFile("lib/fog_ray.glsl");
    for (const Block* fog : kinds) {
        addBlock(out, *fog);
    }
    out.add(fmt::format("float anyFog(FogRay ray) {{\n    int kind = int(sceneData[{0}].x);\n{1}"
                        "    return 1.0;\n}}\n"
                        "vec3 anyFogColor() {{\n    int kind = int(sceneData[{0}].x);\n{2}"
                        "    return vec3(0.0);\n}}\n",
                        fogKind, chosenAt(kinds, "{{0}}(ray, {{1}}({}))", fogAt),
                        chosenAt(kinds, "{{0}}Color({{1}}({}))", fogAt)));
}

/// The blend of a model without a slot: share and tint.
void addBlend(SourceBuilder& out, const Catalog& catalog) {
    const std::vector<const Block*> kinds = catalog.ofKind("fresnel");
    out.add(fmt::format("vec3 anyShare(Incidence i) {{\n    int kind = int(objectData[{0}].y);\n{1}"
                        "    return vec3(0.0);\n}}\n"
                        "vec3 anyTint() {{\n    int kind = int(objectData[{0}].y);\n{2}"
                        "    return vec3(0.0);\n}}\n",
                        choices, chosenAt(kinds, "{{0}}(i, {{1}}({}))", slotAt),
                        chosenAt(kinds, "{{0}}Tint({{1}}({}))", slotAt)));
}

constexpr const char* mainSource = R"(
void main() {{
    Surface s = surface();
    vec3 shaded = vec3(0.0);
    int lights = int(sceneData[{0}].x);
    bool isAmbient = max(sceneData[0].r, max(sceneData[0].g, sceneData[0].b)) > 0.0;
    for (int i = 0; i < (isAmbient ? lights + 1 : lights); ++i) {{
        Illumination light = anyLight(s.x, {1} + i * {2});
        vec3 v = s.v;
        if (i == lights) {{ // the model's text is in the loop alone
            light.l = s.n;
            light.radiance = sceneData[0].rgb;
            v = 0.5 * s.n + sqrt(0.75) * s.t;
        }}
        Directions d = directionsAt(s, light.l, v);
        if ((objectData[0].y == 0.0 || d.nl > 0.0) && (objectData[0].z == 0.0 || d.nv > 0.0)) {{
            shaded += light.radiance * max(shadeAny(d), vec3(0.0));
        }}
    }}
    if (objectData[{3}].y > 0.0) {{
        shaded = mix(shaded, anyTint(), anyShare(incidenceBetween(s.n, s.v)));
    }}
    if (sceneData[{4}].x > 0.0) {{
        FogRay ray;
        ray.eye = viewData[4].xyz;
        ray.direction = -s.v;
        ray.range = s.range;
        shaded = mix(anyFogColor(), shaded, anyFog(ray));
    }}
    store(shaded, objectData[0].x);
}}
)";

gl::Program linkedOrExit(const ProgramText& text) {
    const auto vertex = gl::Shader::compile(GL_VERTEX_SHADER, text.vertex);
    const auto fragment = gl::Shader::compile(GL_FRAGMENT_SHADER, text.fragment);
    if (!vertex || !fragment) {
        fmt::print(stderr, "{}\n", vertex ? fragment.error() : vertex.error());
        std::exit(2);
    }
    auto linked = gl::Program::link(*vertex, *fragment);
    if (!linked) {
        fmt::print(stderr, "{}\n", linked.error());
        std::exit(2);
    }
    return std::move(*linked);
}

/// Counts from 1 on.
float numberOf(const std::vector<const Block*>& blocks, const std::string& id) {
    const auto found = std::ranges::find(blocks, id, [](const Block* block) { return block->id; });
    return static_cast<float>(found - blocks.begin() + 1);
}

} // namespace

Scene plainScene(const Catalog& catalog) {
    Scene scene;
    scene.objects.emplace_back();
    scene.objects.front().material.model = defaultBlockValues(*catalog.find("models", "phong"));
    for (const glm::dvec3& direction :
         {glm::dvec3(0.55, -0.8, -0.75), {-1.0, -0.2, -0.35}, {-0.35, -0.5, 1.0}}) {
        Light& light = scene.lights.emplace_back();
        light.block = defaultBlockValues(*catalog.find("lights", "directional"));
        light.block.parameters["direction"] = direction;
        light.block.parameters["intensity"] = 0.5;
    }
    return scene;
}

std::vector<const Block*> modelsByFormula(const Catalog& catalog) {
    std::vector<const Block*> models = catalog.ofKind("models");
    std::erase_if(models, [](const Block* model) { return tableParameter(*model) != nullptr; });
    return models;
}

ProgramText switchedText(const Catalog& catalog, const std::vector<const Block*>& models) {
    const auto made = program(
        catalog,
        [](SourceBuilder& vertex) {
            vertex.add(fmt::format("#define OBJECT_VEC4S {}\n", objectVec4s));
            vertex.addFile("passes/surface.vert");
            vertex.add("void main() {\n    placeSurface();\n}\n");
        },
        [&](SourceBuilder& out) {
            out.add(fmt::format("#define OBJECT_VEC4S {}\n#define SCENE_VEC4S {}\n", objectVec4s,
                                SceneLayout::minCapacity));
            out.addFile("passes/surface.glsl");
            out.add(unpackedFrom("objectData"));
            addSlots(out, catalog);
            addModels(out, models);
            addBlend(out, catalog);
            addLights(out, catalog);
            addFog(out, catalog);
            out.add(fmt::format(fmt::runtime(mainSource), lightCount, lightsAt, lightVec4s, choices,
                                fogKind));
        });
    if (!made) {
        fmt::print(stderr, "{}\n", text(made.error()));
        std::exit(2);
    }
    return {made->vertex.text, made->fragment.text};
}

SwitchedProgram::SwitchedProgram(const Catalog& catalog, const std::vector<const Block*>& models,
                                 const Scene& scene, const BallStage& stage)
    : program_(linkedOrExit(switchedText(catalog, models))) {
    program_->bindBlock("ViewBlock", binding::view);
    program_->bindBlock("SceneBlock", binding::scene);
    program_->bindBlock("ObjectBlock", binding::object);
    const glm::dmat4 cameraToWorld = glm::inverse(viewMatrix(stage.camera()));
    const Material& material = scene.objects.front().material;
    const Block& model = *catalog.find("models", material.model.id);
    view_.reserve(ViewLayout::vec4s);
    scene_.reserve(SceneLayout::minCapacity);
    object_.reserve(objectVec4s);
    packView(view_.staging(), stage.worldToClip(), eye(stage.camera()), 1.0);
    const std::span<glm::vec4> object = object_.staging();
    object[0] = {1.0f, model.hasGate("light"), model.hasGate("view"), 0.0f};
    object[choices] = {numberOf(models, model.id), 0.0f, 0.0f, 0.0f};
    packInto(object.subspan(modelAt), layoutOf(model), material.model.parameters, {},
             cameraToWorld);
    const std::span<glm::vec4> lit = scene_.staging();
    lit[lightCount].x = static_cast<float>(scene.lights.size());
    for (std::size_t i = 0; i < scene.lights.size(); ++i) {
        const BlockValues& light = scene.lights[i].block;
        const std::size_t at = lightsAt + i * lightVec4s;
        lit[at].x = numberOf(catalog.ofKind("lights"), light.id);
        packInto(lit.subspan(at + 1), layoutOf(*catalog.find("lights", light.id)), light.parameters,
                 {}, cameraToWorld);
    }
    view_.upload(ViewLayout::vec4s);
    scene_.upload(SceneLayout::minCapacity);
    object_.upload(objectVec4s);
}

void SwitchedProgram::use() {
    view_.bind(binding::view);
    scene_.bind(binding::scene);
    object_.bind(binding::object);
    program_->use();
}

} // namespace patina::benchmarks
