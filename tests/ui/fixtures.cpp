// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/fixtures.h"

namespace patina::tests {

namespace {

const char* const firstModel = R"({
  "id": "first", "version": 1, "label": "First", "summary": "For tests.",
  "applications": "Tests.", "source": "None", "doc": "For tests.",
  "parameters": [
    {"id": "diffuse.color", "label": "Base colour", "type": "color",
     "default": [0.5, 0.4, 0.3], "min": 0, "max": 1, "doc": "The colour of the surface.",
     "texture": true,
     "physical": {"min": 0.02, "max": 0.9, "message": "Nothing real is this dark or bright."}},
    {"id": "roughness", "label": "Roughness", "type": "float", "default": 0.5, "min": 0,
     "max": 10, "softMin": 0, "softMax": 1, "step": 0.01, "group": "Surface",
     "doc": "How rough the surface is."},
    {"id": "exponent", "label": "Exponent", "type": "float", "default": 32, "min": 1,
     "max": 100000, "softMin": 1, "softMax": 1000, "step": 1, "scale": "log",
     "group": "Surface", "doc": "How narrow the highlight is."},
    {"id": "samples", "label": "Samples", "type": "int", "default": 4, "min": 1, "max": 64,
     "softMin": 1, "softMax": 16, "step": 1, "group": "Surface", "doc": "How many."},
    {"id": "tilt", "label": "Tilt", "type": "angle", "default": 30, "min": 0, "max": 90,
     "softMin": 0, "softMax": 90, "step": 1, "unit": "deg", "group": "Surface",
     "doc": "How far it leans."},
    {"id": "mode", "label": "Mode", "type": "enum", "default": "plain", "compiled": true,
     "doc": "Which way it is computed.",
     "values": [{"id": "plain", "label": "Plain", "doc": "The simple way."},
                {"id": "fancy", "label": "Fancy", "doc": "The other way."}]},
    {"id": "strength", "label": "Strength", "type": "float", "default": 0.25, "min": 0,
     "max": 1, "step": 0.01, "enabledWhen": "mode == fancy", "doc": "How fancy."},
    {"id": "twoSided", "label": "Two-sided", "type": "bool", "default": false,
     "doc": "Lights both sides."},
    {"id": "direction", "label": "Direction", "type": "vec3", "default": [0, 1, 0],
     "min": -1, "max": 1, "softMin": -1, "softMax": 1, "step": 0.01, "group": "Surface",
     "advanced": true, "doc": "Which way it points."}
  ],
  "claims": ["finite"]
})";

const char* const secondModel = R"({
  "id": "second", "version": 1, "label": "Second", "summary": "For tests.",
  "applications": "Tests.", "source": "None", "doc": "For tests.",
  "slots": [{"kind": "specular"}],
  "parameters": [
    {"id": "diffuse.color", "label": "Base colour", "type": "color",
     "default": [0.5, 0.4, 0.3], "min": 0, "max": 1, "doc": "The colour of the surface.",
     "texture": true,
     "physical": {"min": 0.02, "max": 0.9, "message": "Nothing real is this dark or bright."}},
    {"id": "gloss", "label": "Gloss", "type": "float", "default": 0.1, "min": 0, "max": 1,
     "step": 0.01, "doc": "How much it shines."}
  ],
  "claims": ["finite"]
})";

const char* const fresnelBlock = R"({
  "id": "rim", "version": 1, "label": "Rim", "summary": "For tests.",
  "applications": "Tests.", "source": "None", "doc": "For tests.",
  "parameters": [
    {"id": "f0", "label": "Facing", "type": "float", "default": 0.04, "min": 0, "max": 1,
     "step": 0.01, "doc": "How much is mirrored."}
  ],
  "claims": ["finite"]
})";

const char* const highlightBlock = R"({
  "id": "spark", "version": 1, "label": "Spark", "summary": "For tests.",
  "applications": "Tests.", "source": "None", "doc": "For tests.",
  "parameters": [
    {"id": "size", "label": "Size", "type": "float", "default": 0.5, "min": 0, "max": 1,
     "step": 0.01, "doc": "How large it is."}
  ],
  "claims": ["finite"]
})";

const char* const lampBlock = R"({
  "id": "lamp", "version": 1, "label": "Lamp", "summary": "For tests.",
  "applications": "Tests.", "source": "None", "doc": "For tests.",
  "parameters": [
    {"id": "intensity", "label": "Intensity", "type": "float", "default": 1, "min": 0,
     "max": 10000, "softMin": 0, "softMax": 10, "step": 0.01, "doc": "How bright it is."},
    {"id": "height", "label": "Height", "type": "float", "default": 2, "min": 0, "max": 100,
     "softMin": 0, "softMax": 10, "step": 0.1, "unit": "m", "doc": "How high it hangs."}
  ],
  "neutral": [{"intensity": 0}],
  "claims": ["finite"]
})";

const char* const sunBlock = R"({
  "id": "sun", "version": 1, "label": "Sun", "summary": "For tests.",
  "applications": "Tests.", "source": "None", "doc": "For tests.",
  "parameters": [
    {"id": "intensity", "label": "Intensity", "type": "float", "default": 1, "min": 0,
     "max": 10000, "softMin": 0, "softMax": 10, "step": 0.01, "doc": "How bright it is."}
  ],
  "neutral": [{"intensity": 0}],
  "claims": ["finite"]
})";

const char* const mistBlock = R"({
  "id": "mist", "version": 1, "label": "Mist", "summary": "For tests.",
  "applications": "Tests.", "source": "None", "doc": "For tests.",
  "parameters": [
    {"id": "density", "label": "Density", "type": "float", "default": 0.1, "min": 0, "max": 10,
     "softMin": 0, "softMax": 1, "step": 0.01, "unit": "1/m", "doc": "How thick it is."}
  ],
  "neutral": [{"density": 0}],
  "claims": ["finite"]
})";

const char* const veilBlock = R"({
  "id": "veil", "version": 1, "label": "Veil", "summary": "For tests.",
  "applications": "Tests.", "source": "None", "doc": "For tests.",
  "parameters": [
    {"id": "width", "label": "Width", "type": "float", "default": 0.1, "min": 0, "max": 1,
     "step": 0.01, "unit": "m", "doc": "How wide its edge is."}
  ],
  "claims": []
})";

const char* const diffuseShader = "// SPDX-License-"
                                  "Identifier: MIT-0\n"
                                  "#include \"lib/directions.glsl\"\n";

} // namespace

FixtureBlocks::FixtureBlocks() {
    write("models", "first", firstModel,
          "vec3 first(Directions d, First p) {\n    return p.diffuseColor * d.nl;\n}\n");
    write("models", "second", secondModel,
          "vec3 second(Directions d, Second p) {\n"
          "    return p.diffuseColor * d.nl + slotSpecular(d, p.specular);\n}\n");
    write("fresnel", "rim", fresnelBlock,
          "vec3 rimFresnel(Incidence i, RimFresnel p) {\n    return vec3(p.f0);\n}\n"
          "vec3 rimFresnelTint(RimFresnel p) {\n    return vec3(1.0);\n}\n");
    write("specular", "spark", highlightBlock,
          "vec3 sparkSpecular(Directions d, SparkSpecular p) {\n    return vec3(p.size);\n}\n");
    write("lights", "lamp", lampBlock, "");
    write("lights", "sun", sunBlock, "");
    write("fog", "mist", mistBlock, "");
    write("shadows", "veil", veilBlock, "");
    load();
}

void FixtureBlocks::write(const std::string& kind, const std::string& id,
                          const std::string& descriptor, const std::string& glsl) const {
    const std::filesystem::path place = folder() / kind;
    std::filesystem::create_directories(place);
    writeFile(place / (id + ".json"), descriptor);
    writeFile(place / (id + ".glsl"), diffuseShader + glsl);
}

void FixtureBlocks::load() {
    const BlockRoot root{folder(), false};
    catalog_ = std::make_shared<const Catalog>(loadCatalog(std::span(&root, 1)));
}

void FixtureBlocks::add(const std::string& kind, const std::string& id,
                        const std::string& descriptor, const std::string& glsl) {
    write(kind, id, descriptor, glsl);
    load();
}

Scene fixtureScene(const Catalog& catalog) {
    Scene scene;
    Object object;
    object.name = "Object";
    object.material = defaultMaterial(*catalog.find("models", "first"));
    scene.objects.push_back(object);
    const Block& lamp = *catalog.find("lights", "lamp");
    scene.lights.push_back({"Key", true, {lamp.id, lamp.version, defaultValues(lamp), {}}});
    scene.lights.back().block.unknown = nlohmann::json::object();
    return scene;
}

Value FixtureDocument::value(const std::string& id) const {
    return document.value(model(), *document.block(model())->parameter(id));
}

} // namespace patina::tests
