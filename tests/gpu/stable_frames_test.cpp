// SPDX-License-Identifier: GPL-3.0-or-later
// Whole frames of scenes and meshes that break formulas: nothing on the way to a pixel is anything
// but finite, and no light is negative, looked at before anything is cut.
#include <algorithm>
#include <functional>
#include <limits>

#include "gpu/frames_examined.h"
#include "gpu/gpu_fixture.h"
#include "material/preset_file.h"
#include "measure/stability/edge_case_values.h"

namespace patina::stable_frames_test {
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
    if (scene.part(kinds::fog)->parameters.contains(parameter)) {
        scene.part(kinds::fog)->parameters[parameter] = value;
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
    {"FlatObject", [](Scene& scene, Mesh&) { scene.objects[0].scale = glm::dvec3(1.0, 0.0, 1.0); }},
    {"MirroredObject",
     [](Scene& scene, Mesh&) { scene.objects[0].scale = glm::dvec3(-1.0, 1.0, 2.0); }},
    {"InvertedObject", [](Scene& scene, Mesh&) { scene.objects[0].scale = glm::dvec3(-1.0); }},
    {"StretchedObject",
     [](Scene& scene, Mesh&) { scene.objects[0].scale = glm::dvec3(1e-6, 1e3, 1.0); }},
    {"ShearedObject",
     [](Scene& scene, Mesh&) { scene.objects[0].shear = glm::dvec3(100.0, -100.0, 100.0); }},
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
    {"EndlessNormals",
     [](Scene&, Mesh& mesh) {
         eachVertex(mesh, [](Vertex& v, std::size_t i) {
             v.normal = i % 3 == 0 ? glm::vec3(-infinity) : v.normal * 1e30f;
         });
     }},
    {"TinyNormals",
     [](Scene&, Mesh& mesh) {
         eachVertex(mesh,
                    [](Vertex& v, std::size_t i) { v.normal *= i % 2 == 0 ? 1e-12f : 1e-20f; });
     }},
    {"NormalsAwayFromTheViewer",
     [](Scene&, Mesh& mesh) {
         eachVertex(mesh, [](Vertex& v, std::size_t) { v.normal = {0.0f, 1e-4f, -1.0f}; });
     }},
};

/// Draws with shaders that show what is wrong.
class ExaminedFrame : public GpuTest {
  protected:
    void examine(ExaminedShaders::Stage stage) {
        shaders_ = std::make_unique<ExaminedShaders>(stage);
        load();
    }

    void load() {
        std::vector<BlockRoot> roots{{shaders_->path(), true}};
        if (!std::filesystem::is_empty(own_.path())) {
            roots.push_back({own_.path(), false});
        }
        catalog = std::make_shared<const Catalog>(loadCatalog(roots));
        ASSERT_TRUE(catalog->errors.empty()) << text(catalog->errors);
        Renderer::Options options;
        options.shadowTexels = 256; // enough for pictures of 33 pixels
        makeRenderer(options);
    }

    /// A model of the test's own that gives `value`.
    void addModel(const std::string& value) {
        tests::writeFile(own_ / "models/wrong.json", R"({
  "id": "wrong", "version": 1, "label": "Wrong", "summary": "s", "applications": "a",
  "source": "a test", "doc": "d", "parameters": [], "claims": []
})");
        tests::writeFile(own_ / "models/wrong.glsl",
                         "vec3 wrong(Directions d, Wrong p) {\n    return vec3(" + value +
                             ");\n}\n");
        load();
    }

    static glm::vec3 worst(const Image& image) {
        glm::vec3 largest(0.0f);
        for (int y = 0; y < image.height; ++y) {
            for (int x = 0; x < image.width; ++x) {
                largest = glm::max(largest, pixel(image, x, y));
            }
        }
        return largest;
    }

    void expectSound(const Scene& scene, const std::string& what) {
        const Image image = capture(scene);
        ASSERT_FALSE(image.pixels.empty()) << what;
        EXPECT_TRUE(renderer->report().messages.empty())
            << what << ": " << text(renderer->report().messages);
        const glm::vec3 found = worst(image);
        EXPECT_EQ(found.r, 0.0f) << what << ": a colour is not finite";
        EXPECT_EQ(found.g, 0.0f) << what << ": a colour is negative";
        EXPECT_EQ(found.b, 0.0f) << what << ": a point, a normal or a light is wrong";
    }

  private:
    std::unique_ptr<ExaminedShaders> shaders_;
    tests::TemporaryFolder own_;
};

class HardFrame : public ExaminedFrame, public testing::WithParamInterface<HardScene> {
  protected:
    void SetUp() override {
        GpuTest::SetUp();
        ASSERT_NO_FATAL_FAILURE(examine(ExaminedShaders::Stage::Surface));
    }

    /// Every kind of light in front of the object, with shadows, and fog of the given kind.
    Scene fullScene(const Material& material, const Block& fog) const {
        Scene scene = simpleScene();
        scene.background = glm::dvec3(0.0);
        scene.ambient = glm::dvec3(0.5);
        scene.objects[0].mesh = "builtin:hard";
        scene.objects[0].material = material;
        const auto shadows = catalog->ofKind("shadows");
        for (const Block* kind : catalog->ofKind("lights")) {
            scene.lights.push_back(light(kind->id));
            scene.lights.back().setPart(
                kinds::shadows,
                block("shadows", shadows[scene.lights.size() % shadows.size()]->id));
        }
        scene.ground.mode = GroundMode::Plane;
        scene.setPart(kinds::fog, block("fog", fog.id));
        return scene;
    }

    /// Each scene is drawn with other materials, so that all are, and not all with each scene: a
    /// program takes a third of a second to compile. A model is always in the same fog, for the
    /// same reason.
    static std::size_t placeOfScene() {
        const auto found =
            std::find_if(std::begin(hardScenes), std::end(hardScenes),
                         [](const HardScene& own) { return own.name == GetParam().name; });
        return static_cast<std::size_t>(found - std::begin(hardScenes));
    }

    /// The scene with every number of the material, in turn, at the same end of its range; the
    /// compiled choices, and so the program, stay.
    void expectSoundAtTheEnds(Scene& scene, const std::string& what) {
        expectSound(scene, what);
        BlockValues& model = scene.objects[0].material.model;
        for (const std::size_t end : {1, 2, 3}) {
            for (const Parameter& parameter : catalog->find("models", model.id)->parameters) {
                const std::vector<Value> ends = edgeCaseValues(parameter);
                if (parameter.compiled == Compiled::No && !parameter.emission &&
                    end < ends.size()) {
                    model.parameters[parameter.id] = ends[end];
                }
            }
            expectSound(scene, what + ", at end " + std::to_string(end));
        }
    }

    void expectSoundWith(const Material& material, const Block& fog) {
        Scene scene = fullScene(material, fog);
        Mesh mesh = *primitive("sphere");
        GetParam().change(scene, mesh);
        mesh.bounds = boundsOf(mesh.vertices);
        meshes["hard"] = mesh;
        expectSoundAtTheEnds(scene, material.name + " (" + material.model.id + ") in " + fog.id);
    }
};

TEST_P(HardFrame, OfModelsInEveryFog_IsFiniteBeforeItIsStored) {
    const auto models = catalog->ofKind("models");
    const auto fogs = catalog->ofKind("fog");
    const std::size_t perFog = (models.size() + fogs.size() - 1) / fogs.size();
    for (std::size_t i = 0; i < fogs.size(); ++i) {
        const std::size_t model = i * perFog + placeOfScene() % perFog;
        expectSoundWith(defaultMaterial(*models[model % models.size()]), *fogs[i]);
    }
}

std::vector<std::filesystem::path> shippedPresets() {
    std::vector<std::filesystem::path> files;
    const auto folder = std::filesystem::path(PATINA_SOURCE_DIR) / "presets";
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
        if (entry.path().filename().string().ends_with(".patina.json")) {
            files.push_back(entry.path());
        }
    }
    std::sort(files.begin(), files.end());
    return files;
}

TEST_P(HardFrame, OfAPreset_IsFiniteBeforeItIsStored) {
    const auto files = shippedPresets();
    const auto fogs = catalog->ofKind("fog");
    ASSERT_FALSE(files.empty());
    auto preset = readPreset(files[5 * placeOfScene() % files.size()], *catalog);
    ASSERT_TRUE(preset) << text(preset.error());
    preset->material.parts.erase("outline"); // lines have programs that show their own colour
    expectSoundWith(preset->material, *fogs[placeOfScene() % fogs.size()]);
}

INSTANTIATE_TEST_SUITE_P(Scenes, HardFrame, testing::ValuesIn(hardScenes),
                         [](const auto& tested) { return std::string(tested.param.name); });

class WrongModel : public ExaminedFrame {
  protected:
    glm::vec3 seen(const std::string& value) {
        examine(ExaminedShaders::Stage::Surface);
        addModel(value);
        return worst(capture(simpleScene("wrong")));
    }
};

TEST_F(WrongModel, ThatIsNoNumber_IsSeen) {
    EXPECT_GT(seen("sqrt(-d.nv)").r, 0.5f);
}

TEST_F(WrongModel, ThatIsInfinite_IsSeen) {
    EXPECT_GT(seen("1.0 / min(d.nv, 0.0)").r, 0.5f);
}

TEST_F(WrongModel, ThatIsNegative_IsSeen) {
    EXPECT_GT(seen("-d.nv").g, 0.5f);
}

class DisplayedFrame : public ExaminedFrame, public testing::WithParamInterface<double> {};

/// From black to the brightest light that is stored.
TEST_P(DisplayedFrame, OfAnyLight_IsFiniteBeforeItIsClamped) {
    examine(ExaminedShaders::Stage::Display);
    std::vector<std::optional<BlockValues>> curves{std::nullopt};
    for (const Block* each : catalog->ofKind(kinds::tone)) {
        curves.emplace_back(block("tone", each->id));
    }
    for (const std::optional<BlockValues>& curve : curves) {
        for (const double intensity : {0.0, 1e-7, 1.0, 1e5}) {
            Scene scene = simpleScene();
            scene.lights[0].block.parameters["intensity"] = intensity;
            scene.setPart(kinds::tone, curve);
            scene.exposure = GetParam();
            EXPECT_EQ(worst(capture(scene, true)), glm::vec3(0.0f)) << intensity;
        }
    }
}

INSTANTIATE_TEST_SUITE_P(Exposures, DisplayedFrame, testing::Values(-20.0, 0.0, 20.0),
                         [](const auto& tested) {
                             return std::string(tested.param < 0.0   ? "Darkest"
                                                : tested.param > 0.0 ? "Brightest"
                                                                     : "Middle");
                         });

} // namespace
} // namespace patina::stable_frames_test
