// SPDX-License-Identifier: GPL-3.0-or-later
// Whole frames of scenes and meshes that break formulas: no pixel of the linear target, which is
// read before tone mapping, is anything but a finite number of at least 0.
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>

#include "gpu/gpu_fixture.h"

namespace patina {
namespace {

/// A scene with everything in it that the cases below push to an end.
struct HardScene {
    const char* name;
    std::function<void(Scene&, Mesh&)> change;
};

void PrintTo(const HardScene& scene, std::ostream* stream) {
    *stream << scene.name;
}

void setLight(Scene& scene, const char* parameter, const Value& value) {
    for (Light& light : scene.lights) {
        if (light.block.parameters.contains(parameter)) {
            light.block.parameters[parameter] = value;
        }
    }
}

void setFog(Scene& scene, const char* parameter, const Value& value) {
    if (scene.fog->parameters.contains(parameter)) {
        scene.fog->parameters[parameter] = value;
    }
}

void setCone(Scene& scene, double inner, double outer) {
    setLight(scene, "angle.inner", inner);
    setLight(scene, "angle.outer", outer);
}

template <class Change>
void eachVertex(Mesh& mesh, Change change) {
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
        change(mesh.vertices[i], i);
    }
}

constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float infinity = std::numeric_limits<float>::infinity();

const HardScene hardScenes[] = {
    {"UnchangedScene", [](Scene&, Mesh&) {}},
    {"LightOnTheSurface",
     [](Scene& scene, Mesh&) { setLight(scene, "position", glm::dvec3(0.0, 0.0, 0.5)); }},
    {"LightInTheMiddle", [](Scene& scene, Mesh&) { setLight(scene, "position", glm::dvec3(0.0)); }},
    {"NoAttenuationAtAll",
     [](Scene& scene, Mesh&) { setLight(scene, "attenuation.constant", 0.0); }},
    {"ConeOfNothing", [](Scene& scene, Mesh&) { setCone(scene, 0.0, 0.0); }},
    {"ConeOfEverything", [](Scene& scene, Mesh&) { setCone(scene, 180.0, 180.0); }},
    {"InnerConeBeyondOuter", [](Scene& scene, Mesh&) { setCone(scene, 180.0, 0.0); }},
    {"BeamOfNoDirection",
     [](Scene& scene, Mesh&) { setLight(scene, "direction", glm::dvec3(0.0)); }},
    {"BrightestLight", [](Scene& scene, Mesh&) { setLight(scene, "intensity", 10000.0); }},
    {"NoFog", [](Scene& scene, Mesh&) { setFog(scene, "density", 0.0); }},
    {"DensestFog", [](Scene& scene, Mesh&) { setFog(scene, "density", 1e6); }},
    {"FogWithoutWay",
     [](Scene& scene, Mesh&) {
         setFog(scene, "start", 4.0);
         setFog(scene, "end", 4.0);
     }},
    {"DarkestExposure", [](Scene& scene, Mesh&) { scene.exposure = -20.0; }},
    {"BrightestExposure", [](Scene& scene, Mesh&) { scene.exposure = 20.0; }},
    {"FlatObject", [](Scene& scene, Mesh&) { scene.objects[0].scale = glm::dvec3(1.0, 0.0, 1.0); }},
    {"MirroredObject",
     [](Scene& scene, Mesh&) { scene.objects[0].scale = glm::dvec3(-1.0, 1.0, 2.0); }},
    {"InvertedObject", [](Scene& scene, Mesh&) { scene.objects[0].scale = glm::dvec3(-1.0); }},
    {"StretchedObject",
     [](Scene& scene, Mesh&) { scene.objects[0].scale = glm::dvec3(1e-6, 1e3, 1.0); }},
    {"CameraInTheMesh", [](Scene& scene, Mesh&) { scene.camera.distance = 0.1; }},
    {"CameraOnTheSurface", [](Scene& scene, Mesh&) { scene.camera.distance = 0.5; }},
    {"ZeroNormals",
     [](Scene&, Mesh& mesh) {
         eachVertex(mesh, [](Vertex& v, std::size_t) { v.normal = glm::vec3(0.0f); });
     }},
    {"SomeNormalsNotNumbers",
     [](Scene&, Mesh& mesh) {
         eachVertex(mesh, [](Vertex& v, std::size_t i) { v.normal.x = i % 5 == 0 ? nan : 0.3f; });
     }},
    {"InfiniteNormals",
     [](Scene&, Mesh& mesh) {
         eachVertex(mesh, [](Vertex& v, std::size_t) { v.normal.y = infinity; });
     }},
    {"OpposedNormals",
     [](Scene&, Mesh& mesh) {
         eachVertex(mesh, [](Vertex& v, std::size_t i) { v.normal *= i % 2 == 0 ? 1.0f : -1.0f; });
     }},
    {"ZeroTangents",
     [](Scene&, Mesh& mesh) {
         eachVertex(mesh, [](Vertex& v, std::size_t) { v.tangent = glm::vec4(0.0f); });
     }},
    {"TangentsAlongNormals",
     [](Scene&, Mesh& mesh) {
         eachVertex(mesh, [](Vertex& v, std::size_t) { v.tangent = glm::vec4(v.normal, 1.0f); });
     }},
    {"TangentsNotNumbers",
     [](Scene&, Mesh& mesh) {
         eachVertex(mesh, [](Vertex& v, std::size_t) { v.tangent = glm::vec4(nan); });
     }},
    {"TrianglesWithoutArea",
     [](Scene&, Mesh& mesh) {
         eachVertex(mesh, [](Vertex& v, std::size_t) { v.position.z = v.position.x; });
     }},
};

class HardFrame : public GpuTest, public testing::WithParamInterface<HardScene> {
  protected:
    void SetUp() override {
        GpuTest::SetUp();
        if (context != nullptr) {
            makeRenderer();
        }
    }

    /// Every kind of light in front of the object, and fog of the given kind.
    Scene fullScene(const std::string& model, const Block& fog) const {
        Scene scene = simpleScene(model);
        scene.objects[0].mesh = "builtin:hard";
        for (const Block* kind : catalog->ofKind("lights")) {
            scene.lights.push_back(light(kind->id));
        }
        BlockValues values;
        values.id = fog.id;
        values.parameters = defaultValues(fog);
        scene.fog = values;
        return scene;
    }

    /// Each scene is drawn with other models, so that all are, and not all with each scene: a
    /// program takes a third of a second to compile.
    static std::size_t placeOf(const HardScene& scene) {
        const auto found =
            std::find_if(std::begin(hardScenes), std::end(hardScenes),
                         [&](const HardScene& own) { return own.name == scene.name; });
        return static_cast<std::size_t>(found - std::begin(hardScenes));
    }

    static void expectSound(const Image& image, const std::string& what) {
        for (std::size_t i = 0; i < image.pixels.size(); ++i) {
            const float x = image.pixels[i];
            ASSERT_TRUE(std::isfinite(x) && x >= 0.0f)
                << what << ": " << x << " in pixel " << i / std::size_t(image.channels);
        }
    }
};

TEST_P(HardFrame, InEveryFog_HasOnlyFiniteLight) {
    const auto models = catalog->ofKind("models");
    const auto fogs = catalog->ofKind("fog");
    const std::size_t first = placeOf(GetParam());
    for (std::size_t i = 0; i < fogs.size(); ++i) {
        const Block& model = *models[(first + i) % models.size()];
        const Block& fog = *fogs[i];
        Scene scene = fullScene(model.id, fog);
        Mesh mesh = *primitive("sphere");
        GetParam().change(scene, mesh);
        mesh.bounds = boundsOf(mesh.vertices);
        meshes["hard"] = mesh;
        expectSound(capture(scene), model.id + " in " + fog.id);
        expectSound(capture(scene, true), model.id + " in " + fog.id + ", displayed");
    }
}

INSTANTIATE_TEST_SUITE_P(Scenes, HardFrame, testing::ValuesIn(hardScenes),
                         [](const auto& tested) { return std::string(tested.param.name); });

} // namespace
} // namespace patina
