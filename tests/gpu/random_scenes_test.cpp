// SPDX-License-Identifier: GPL-3.0-or-later
// Scenes of everything in any mixture. PATINA_RANDOM_SCENES=<first>,<count> draws others than the
// few of each run; `ninja random-scenes` draws ten thousand.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <map>
#include <set>

#include "bound_programs.h"
#include "gpu/frames_examined.h"
#include "gpu_fixture.h"
#include "random_scenes.h"
#include "render/lights/environment_image.h"
#include "render/lights/ground_place.h"
#include "render/surfaces/scene_depth.h"
#include "shading/effects/effect_set.h"
#include "shading/effects/texture_writer.h"
#include "shading/glsl/tokens.h"

namespace patina::random_scenes_test {
namespace {

constexpr std::uint64_t parts = 4;
constexpr std::uint64_t scenesPerPart = 12;
constexpr std::uint64_t scenesPerContext = 200; ///< drivers keep what they have compiled
constexpr std::uint64_t examinedScenes = 5;     ///< one of so many is looked at before it is cut
constexpr int size = 16;

struct Share {
    std::uint64_t first = 0;
    std::uint64_t count = 0;
};

Share shareOf(std::uint64_t part) {
    unsigned long first = 0;
    unsigned long count = 0;
    const char* wanted = std::getenv("PATINA_RANDOM_SCENES");
    if (wanted != nullptr && std::sscanf(wanted, "%lu,%lu", &first, &count) == 2) {
        return {first + part * count / parts, (part + 1) * count / parts - part * count / parts};
    }
    return {part * scenesPerPart, scenesPerPart};
}

std::shared_ptr<const TexturePicture> picture(float shade) {
    FileImage image{{4, 4, 4, {}}, 8};
    for (int i = 0; i < 16; ++i) {
        const float x = float(i % 5) / 4.0f;
        image.image.pixels.insert(image.image.pixels.end(), {x, shade, 1.0f - x, 0.5f + 0.5f * x});
    }
    return std::make_shared<const TexturePicture>(madeTexture(image, TextureDecoding::Linear));
}

class RandomScene : public GpuTest, public testing::WithParamInterface<std::uint64_t> {
  protected:
    void SetUp() override {
        GpuTest::SetUp();
        shipped_ = catalog;
        shaders_ = std::make_unique<ExaminedShaders>(ExaminedShaders::Stage::Surface);
        examining_ = std::make_shared<const Catalog>(
            loadCatalog(std::array{BlockRoot{shaders_->path(), true}}));
        pictures_ = {picture(0.0f), picture(1.0f)};
        begin();
    }

    /// A new renderer in a new context.
    void begin() {
        renderer.reset();
        debug.reset();
        context.reset();
        GpuTest::SetUp();
        makeRenderer();
        // Two images are there, one is missing, one on its way.
        renderer->setTextures([this](const TextureUse& use, TextureDecoding) -> TextureLookup {
            const auto number = std::size_t(use.file[std::string("/picture").size()] - '0');
            return {number < pictures_.size() ? pictures_[number] : nullptr, number == 2};
        });
    }

    View viewFor(const Scene& scene, std::uint64_t number) const {
        View view = viewOf(scene, size);
        view.samples = number % 2 == 0 ? 4 : 1;
        view.environmentImage = panorama_;
        view.environmentSamples = 4;
        return view;
    }

    /// What the rows of an object or of the ground name, and which meshes its programs draw.
    struct Named {
        std::set<std::string> blocks; ///< "texture/<id>" is none
        std::size_t textures = 0;
        GLsizei corners = 0;
        bool hasLines = false;
        bool mayLack = false; ///< of lights those that end before it

        bool draws(const BoundPrograms::Drawing& drawing) const {
            return drawing.first == GL_TRIANGLES ? drawing.second == corners : hasLines;
        }
    };

    Named namedBy(const EffectSet& set, GLsizei corners) const {
        const bool hasLines = set.outline || (set.shells && hasFins(*set.shells));
        Named named{{}, set.textures.size(), corners, hasLines, false};
        std::size_t textures = 0;
        for (const EffectLine& line : effectLines(set)) {
            const auto slash = line.effect.find('/');
            const bool isBlock = slash != std::string::npos &&
                                 catalog->find(line.effect.substr(0, slash),
                                               line.effect.substr(slash + 1)) != nullptr;
            const bool isNumber = set.method == EnvironmentMethod::OneLight && // of one light
                                  line.effect.starts_with("environment/");
            if (isBlock && !isNumber) {
                named.blocks.insert(line.effect);
            }
            textures += line.effect.starts_with("texture/") ? 1 : 0;
        }
        EXPECT_EQ(textures, set.textures.size());
        return named;
    }

    std::vector<Named> namedIn(const Scene& scene) {
        std::vector<Named> all;
        for (std::size_t i = 0; i < scene.objects.size(); ++i) {
            const Object& each = scene.objects[i];
            const EffectView view = objectView(scene, i, *catalog, meshSource());
            all.push_back(namedBy(effectSet(each.material, scene, *catalog, view),
                                  GLsizei(mesh(each).indices.size())));
        }
        const EffectSet ground = groundEffects(scene, *catalog);
        if (ground.ground != GroundMode::Off) {
            all.push_back(namedBy(ground, GLsizei(groundMesh().indices.size())));
            all.back().mayLack = true;
            std::erase_if(all.back().blocks, [](const std::string& each) {
                return each.starts_with("environment/"); // its light is a number there
            });
        }
        return all;
    }

    /// The blocks and the images of a program, by the names in its text.
    Named heldBy(const BoundPrograms::Program& program) const {
        const std::string text = withoutComments(program.text);
        std::set<std::string_view> names;
        for (const GlslToken& token : glslTokens(text)) {
            names.insert(token.text);
        }
        Named held;
        for (const Block& block : catalog->blocks) {
            if (names.contains(functionName(block)) || names.contains(structName(block))) {
                held.blocks.insert(block.kind + '/' + block.id);
            }
        }
        while (names.contains(samplerName(held.textures))) {
            ++held.textures;
        }
        return held;
    }

    static bool isWithin(const Named& held, const Named& named) {
        return held.textures <= named.textures && std::ranges::includes(named.blocks, held.blocks);
    }

    /// Without the blocks that other programs hold: those of outlines, and of an environment that
    /// is looked up where it was drawn before.
    static std::set<std::string> heldBySurfaces(std::set<std::string> blocks, const Scene& scene) {
        std::erase_if(blocks, [&scene](const std::string& each) {
            return each.starts_with("outline/") ||
                   (each.starts_with("environment/") && scene.accuracy.fitsEnvironment());
        });
        return blocks;
    }

    /// What was bound for a mesh has no block that the rows of what has that mesh do not name, and
    /// where only one object has it they have all of them.
    void expectNamedBlocks(const Scene& scene) {
        const std::vector<Named> all = namedIn(scene);
        std::map<BoundPrograms::Drawing, std::set<std::string>> held;
        for (const BoundPrograms::Program* program : bound_.drawn()) {
            const Named has = heldBy(*program);
            for (const BoundPrograms::Drawing& drawing : program->drawings) {
                held[drawing].insert(has.blocks.begin(), has.blocks.end());
                EXPECT_TRUE(std::ranges::any_of(all, [&](const Named& named) {
                    return named.draws(drawing) && isWithin(has, named);
                })) << testing::PrintToString(has.blocks);
            }
        }
        for (const auto& [drawing, blocks] : held) {
            const auto isOf = [&at = drawing](const Named& named) { return named.draws(at); };
            const auto named = std::ranges::find_if(all, isOf);
            const bool isOne = std::ranges::count_if(all, isOf) == 1;
            if (isOne && !named->mayLack && drawing.first == GL_TRIANGLES && !blocks.empty()) {
                EXPECT_EQ(heldBySurfaces(blocks, scene), heldBySurfaces(named->blocks, scene));
            }
        }
    }

    void expectSound(const Image& image) {
        ASSERT_FALSE(image.pixels.empty());
        const auto isLight = [](float x) { return std::isfinite(x) && x >= 0.0f; };
        EXPECT_TRUE(std::ranges::all_of(image.pixels, isLight));
    }

    Image captured(const Scene& scene, std::uint64_t number, bool display) {
        auto image = renderer->capture(scene, viewFor(scene, number), meshSource(), display);
        EXPECT_TRUE(image) << (image ? "" : image.error().text());
        const FrameReport& report = renderer->report();
        const auto mistakes =
            std::span(report.messages).first(report.messages.size() - report.warnings);
        EXPECT_TRUE(mistakes.empty()) << text(Errors(mistakes.begin(), mistakes.end()));
        return image ? *image : Image();
    }

    void makeSolid(Material& material) const {
        material.opacity = material.opacity > 0.0 ? 1.0 : 0.0;
        for (const Parameter& each : shipped_->find("models", material.model.id)->parameters) {
            if (each.transparency) {
                material.model.parameters[each.id] = 0.0;
            }
        }
    }

    /// Without anything behind the objects, which is no surface and not looked at.
    void examine(Scene scene, std::uint64_t number) {
        scene.background = glm::dvec3(0.0);
        scene.accuracy.choose(PictureChoice::Normals, 0); // models say nothing of shorter ones
        scene.setPart(kinds::transparency,
                      std::nullopt); // each surface stores what was wrong with it by itself
        if (scene.part(kinds::environment)) {
            scene.part(kinds::environment)->parameters["background"] = std::string("hidden");
        }
        for (Object& each : scene.objects) {
            makeSolid(each.material);
            each.material.parts.erase("outline");
            each.material.parts.erase("shells");
            each.material.parts.erase("strokes");
        }
        renderer->setCatalog(examining_);
        const Image image = captured(scene, number, false);
        renderer->setCatalog(shipped_);
        glm::vec3 worst(0.0f);
        for (int i = 0; i < image.width * image.height; ++i) {
            worst = glm::max(worst, pixel(image, i % image.width, i / image.width));
        }
        EXPECT_EQ(worst, glm::vec3(0.0f))
            << "red: a colour that is not finite, green: negative, blue: a point or a light";
    }

    void expectSilence() { EXPECT_EQ(debug->messages(), std::vector<std::string>()); }

    void draw(std::uint64_t number) {
        SCOPED_TRACE("scene " + std::to_string(number));
        const Scene scene = RandomScenes(*shipped_).scene(number);
        bound_.begin();
        expectSound(captured(scene, number, false));
        expectSound(captured(scene, number, true));
        expectNamedBlocks(scene);
        if (number % examinedScenes == 0) {
            examine(scene, number);
        }
        expectSilence();
    }

  private:
    BoundPrograms bound_;
    std::shared_ptr<const Catalog> shipped_;
    std::shared_ptr<const Catalog> examining_;
    std::unique_ptr<ExaminedShaders> shaders_;
    std::array<std::shared_ptr<const TexturePicture>, 2> pictures_;
    std::shared_ptr<const EnvironmentImage> panorama_ =
        EnvironmentImage::from({4, 2, 1, {0.1f, 0.5f, 8.0f, 1.0f, 0.0f, 0.2f, 0.3f, 0.4f}});
};

TEST_P(RandomScene, OfAnyMixture_CompilesIsFiniteAndHasNoOtherBlock) {
    const Share share = shareOf(GetParam());
    for (std::uint64_t i = 0; i < share.count; ++i) {
        if (i % scenesPerContext == scenesPerContext - 1) {
            begin();
        }
        draw(share.first + i);
    }
}

INSTANTIATE_TEST_SUITE_P(Parts, RandomScene, testing::Range(std::uint64_t(0), parts));

} // namespace
} // namespace patina::random_scenes_test
