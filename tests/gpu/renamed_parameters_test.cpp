// SPDX-License-Identifier: GPL-3.0-or-later
// The program knows what parameters are by their roles, whatever a block calls them.
#include <array>
#include <fstream>
#include <regex>
#include <sstream>

#include "catalog/index_trend.h"
#include "catalog/shader_names.h"
#include "scene/environment.h"
#include "scene/transparency.h"
#include "shading/effects/body_index.h"
#include "shading/effects/fog.h"
#include "shading/effects/outline.h"
#include "shading_scene.h"
#include "support/program.h"

namespace patina::renamed_parameters_test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;

constexpr const char* suffix = "Renamed";

std::string contents(const fs::path& file) {
    std::ostringstream text;
    text << std::ifstream(file).rdbuf();
    return text.str();
}

std::string replaced(const std::string& text, const std::string& pattern, const std::string& by) {
    return std::regex_replace(text, std::regex(pattern), by);
}

/// A descriptor and its shader in which a parameter has another name.
struct BlockText {
    json descriptor;
    std::string shader;

    void rename(const std::string& id) {
        for (json& parameter : descriptor["parameters"]) {
            if (parameter["id"] == id) {
                parameter["id"] = id + suffix;
            }
            if (parameter.value("enabledWhen", "").starts_with(id + ' ')) {
                const std::string condition = parameter["enabledWhen"];
                parameter["enabledWhen"] = id + suffix + condition.substr(id.size());
            }
            if (parameter.contains("values")) {
                renameFills(parameter["values"], id);
            }
        }
        renameNeutral(id);
        if (descriptor.contains("tables")) {
            for (json& table : descriptor["tables"]) {
                std::ranges::replace(table["of"], json(id), json(id + suffix));
            }
        }
        const std::string field = fieldName(id);
        shader = replaced(shader, "\\bp\\." + field + "\\b", "p." + field + suffix);
        std::string word = replaced(field, "([A-Z])", "_$1");
        std::ranges::transform(word, word.begin(), [](unsigned char c) { return std::toupper(c); });
        shader = replaced(shader, '_' + word + "_([A-Z]+)\\b", '_' + word + "_RENAMED_$1");
    }

    /// Renames what choices of a parameter set.
    static void renameFills(json& choices, const std::string& id) {
        for (json& value : choices) {
            if (value.contains("fills") && value["fills"].contains(id)) {
                value["fills"][id + suffix] = value["fills"][id];
                value["fills"].erase(id);
            }
        }
    }

    void renameNeutral(const std::string& id) {
        json cases = json::array();
        for (const json& each : descriptor.value("neutral", json::array())) {
            json renamed = json::object();
            for (const auto& [key, value] : each.items()) {
                renamed[key == id ? key + suffix : key] = value == id ? json(id + suffix) : value;
            }
            cases.push_back(renamed);
        }
        if (!cases.empty()) {
            descriptor["neutral"] = cases;
        }
    }
};

/// The shipped blocks, with another name for each parameter that has a role.
class RenamedParameters : public ShadingTest {
  protected:
    static const Catalog& renamed() {
        static const tests::TemporaryFolder folder;
        static const Catalog loaded = made(folder.path() / "shaders");
        return loaded;
    }

    static Catalog made(const fs::path& root) {
        fs::copy(PATINA_SOURCE_DIR "/shaders", root, fs::copy_options::recursive);
        for (const Block& block : catalog().blocks) {
            const fs::path file = root / block.kind / (block.id + ".json");
            BlockText text{json::parse(contents(file)),
                           contents(fs::path(file).replace_extension(".glsl"))};
            text.descriptor.erase("looks"); // of other programs' files: no program has them in it
            for (const Parameter& parameter : block.parameters) {
                if (!parameter.role.empty()) {
                    text.rename(parameter.id);
                }
            }
            tests::writeFile(file, text.descriptor.dump(1));
            tests::writeFile(fs::path(file).replace_extension(".glsl"), text.shader);
        }
        return loadCatalog(std::array{BlockRoot{root, true}});
    }

    static BlockValues values(const Catalog& blocks, std::string_view kind, const std::string& id,
                              const std::vector<std::pair<std::string_view, Value>>& byRole = {}) {
        const Block& block = *blocks.find(kind, id);
        BlockValues made{id, block.version, defaultValues(block)};
        for (const auto& [role, value] : byRole) {
            made.parameters[block.withRole(role)->id] = value;
        }
        return made;
    }

    /// A body behind another one in all that a scene may have.
    static Scene fullScene(const Catalog& blocks, const std::string& refraction) {
        Scene scene;
        scene.objects.resize(2);
        scene.objects[1].material = defaultMaterial(*blocks.find(kinds::models, "lambert"));
        Material& glass = scene.objects[0].material;
        glass = scene.objects[1].material;
        glass.opacity = 0.1;
        glass.parts["refraction"] = values(blocks, kinds::refraction, refraction);
        glass.parts["fresnel"] = values(blocks, kinds::fresnel, "dielectric");
        scene.lights.push_back({"sun", true, values(blocks, kinds::lights, "directional")});
        scene.lights[0].setPart(kinds::shadows, values(blocks, kinds::shadows, "soft"));
        scene.setPart(kinds::fog, values(blocks, kinds::fog, "box"));
        scene.setPart(kinds::environment, values(blocks, kinds::environment, "studio"));
        scene.setPart(kinds::transparency, values(blocks, kinds::transparency, "peeled"));
        return scene;
    }

    static std::string programText(const Catalog& blocks, const Scene& scene) {
        const auto program =
            surfaceProgram(effectSet(scene.objects[0].material, scene, blocks), blocks);
        return program ? program->fragment.text : text(program.error());
    }

    /// Leaves out the names that the blocks were given, what stands for them, and line numbers.
    static std::string withoutNames(const std::string& text) {
        const std::string lines = replaced(
            text, "#(define thickness thicknessRenamed|undef thickness|line [0-9 ]+)\n", "");
        return replaced(lines, "Renamed|_RENAMED", "");
    }

    static double index(const Catalog& blocks, const Material& material) {
        return BodyIndex(material, refractionChoice(material, blocks), blocks).channels().y;
    }
};

TEST_F(RenamedParameters, OfAllBlocks_AreNoMistakes) {
    EXPECT_TRUE(renamed().errors.empty()) << text(renamed().errors);
    EXPECT_EQ(renamed().blocks.size(), catalog().blocks.size());
    EXPECT_NE(renamed().find(kinds::outline, "ink-line")->parameter("crease.widthRenamed"),
              nullptr);
}

TEST_F(RenamedParameters, InASceneOfEverything_MakeTheSamePrograms) {
    for (const char* refraction : {"solid-body", "thin-pane"}) {
        const std::string shipped = programText(catalog(), fullScene(catalog(), refraction));
        const std::string own = programText(renamed(), fullScene(renamed(), refraction));
        EXPECT_NE(own.find("Renamed"), std::string::npos);
        EXPECT_TRUE(withoutNames(own) == withoutNames(shipped)) << refraction;
    }
}

TEST_F(RenamedParameters, OfAPane_SayHowThickItIs) {
    const std::string own = programText(renamed(), fullScene(renamed(), "thin-pane"));
    EXPECT_NE(own.find("#define thickness thicknessRenamed\n"), std::string::npos);
}

TEST_F(RenamedParameters, OfDispersion_FollowARayForEachWavelength) {
    for (const double dispersion : {0.0, 0.3}) {
        Scene scene = fullScene(renamed(), "solid-body");
        scene.objects[0].material.parts["refraction"] =
            values(renamed(), kinds::refraction, "solid-body", {{roles::dispersion, dispersion}});
        const bool isApart =
            programText(renamed(), scene)
                .find("#define WAVELENGTH_DISPERSION dispersionRenamed\n") != std::string::npos;
        EXPECT_EQ(isApart, dispersion > 0.0);
    }
}

TEST_F(RenamedParameters, OfLines_SayWhetherThereAreAny) {
    Material material = defaultMaterial(*renamed().find(kinds::models, "lambert"));
    BlockValues& lines = material.parts["outline"];
    lines = values(renamed(), kinds::outline, "ink-line");
    EXPECT_NE(outlineChoice(material, renamed()).block, nullptr);
    lines.parameters["widthRenamed"] = 0.0;
    EXPECT_NE(outlineChoice(material, renamed()).block, nullptr);
    lines.parameters["crease.widthRenamed"] = 0.0;
    EXPECT_STREQ(outlineChoice(material, renamed()).whyNot, "Its lines are 0 pixels wide.");
}

TEST_F(RenamedParameters, OfAFresnelTerm_SayHowStronglyABodyBends) {
    Material material = fullScene(renamed(), "solid-body").objects[0].material;
    material.parts["fresnel"] = values(renamed(), kinds::fresnel, "dielectric",
                                       {{roles::indexInside, 2.4}, {roles::indexOutside, 1.2}});
    EXPECT_DOUBLE_EQ(index(renamed(), material), 2.0);
    material.parts["fresnel"] = values(renamed(), kinds::fresnel, "dielectric",
                                       {{roles::indexInside, 2.4},
                                        {roles::indexOutside, 1.2},
                                        {roles::temperature, 120.0},
                                        {roles::temperatureSlope, -0.0012}});
    EXPECT_NEAR(index(renamed(), material), 1.9, 1e-12);
    material.parts["fresnel"] =
        values(renamed(), kinds::fresnel, "schlick", {{roles::f0, glm::dvec3(0.04)}});
    EXPECT_DOUBLE_EQ(index(renamed(), material), 1.5);
    material.parts["refraction"] =
        values(renamed(), kinds::refraction, "solid-body",
               {{roles::indexFrom, std::string("own")}, {roles::index, 1.3}});
    EXPECT_DOUBLE_EQ(index(renamed(), material), 1.3);
}

TEST_F(RenamedParameters, OfWhatBendsAndColoursNothing_LeaveItOut) {
    Material material = fullScene(renamed(), "solid-body").objects[0].material;
    BlockValues& body = material.parts["refraction"];
    body = values(renamed(), kinds::refraction, "solid-body",
                  {{roles::indexFrom, std::string("own")}, {roles::index, 1.0}});
    EXPECT_EQ(refractionChoice(material, renamed()).block, nullptr);
    body.parameters["tintRenamed"] = glm::dvec3(1.0, 0.5, 0.5);
    EXPECT_NE(refractionChoice(material, renamed()).block, nullptr);
}

TEST_F(RenamedParameters, OfAnEnvironment_SayHowItIsSeen) {
    const Block& studio = *renamed().find(kinds::environment, "studio");
    const BlockValues shown = values(renamed(), kinds::environment, "studio",
                                     {{roles::background, std::string("blurred")},
                                      {roles::blur, 20.0},
                                      {roles::rotate, 90.0},
                                      {roles::directions, 64}});
    EXPECT_EQ(backdropOf(shown, studio), Backdrop::Blurred);
    EXPECT_EQ(environmentNumber(shown, studio, roles::blur), 20.0);
    EXPECT_EQ(environmentNumber(shown, studio, roles::rotate), 90.0);
    EXPECT_EQ(directionsOf(shown, studio), 64);
}

TEST_F(RenamedParameters, OfLayers_SayHowManyAreSorted) {
    const BlockValues layers =
        values(renamed(), kinds::transparency, "peeled", {{roles::layers, 5}});
    EXPECT_EQ(layersOf(layers, *renamed().find(kinds::transparency, "peeled")), 5);
}

} // namespace
} // namespace patina::renamed_parameters_test
