// SPDX-License-Identifier: GPL-3.0-or-later
// Passes over the finished picture.
#include <cmath>

#include <fmt/format.h>

#include "frame_target.h"
#include "gpu_fixture.h"
#include "scene/picture_choice_text.h"
#include "shading/effects/display_set.h"
#include "support/program.h"

namespace patina::picture_passes_test {
namespace {

class PicturePassesTest : public GpuTest {
  protected:
    void SetUp() override {
        GpuTest::SetUp();
        makeRenderer();
    }

    static void set(Scene& scene, const std::string& id, const Value& value) {
        scene.passes.back().parameters[id] = value;
    }

    Scene with(const std::string& pass) const {
        Scene scene = simpleScene();
        scene.passes = {block("pass", pass)};
        return scene;
    }

    /// The largest difference of any channel of any pixel.
    static float difference(const Image& a, const Image& b) {
        float most = 0.0f;
        EXPECT_EQ(a.pixels.size(), b.pixels.size());
        for (std::size_t i = 0; i < std::min(a.pixels.size(), b.pixels.size()); ++i) {
            most = std::max(most, std::abs(a.pixels[i] - b.pixels[i]));
        }
        return most;
    }

    static double mean(const Image& image) {
        double sum = 0.0;
        for (std::size_t i = 0; i < image.pixels.size(); ++i) {
            sum += i % 4 == 3 ? 0.0 : static_cast<double>(image.pixels[i]);
        }
        return sum / static_cast<double>(image.width * image.height * 3);
    }

    /// Each pixel's mean over squares of `side` pixels.
    static Image averaged(const Image& image, int side) {
        Image small{image.width / side, image.height / side, 4, {}};
        for (int y = 0; y < small.height; ++y) {
            for (int x = 0; x < small.width; ++x) {
                glm::vec3 sum(0.0f);
                for (int i = 0; i < side * side; ++i) {
                    sum += pixel(image, x * side + i % side, y * side + i / side);
                }
                sum /= static_cast<float>(side * side);
                small.pixels.insert(small.pixels.end(), {sum.r, sum.g, sum.b, 1.0f});
            }
        }
        return small;
    }

    static double meanDifference(const Image& a, const Image& b) {
        double sum = 0.0;
        for (std::size_t i = 0; i < a.pixels.size(); ++i) {
            sum += static_cast<double>(std::abs(a.pixels[i] - b.pixels.at(i)));
        }
        return sum / static_cast<double>(a.pixels.size());
    }
};

TEST_F(PicturePassesTest, ProgramOfTheDisplay_HasNothingOfAPass) {
    const auto without = displayProgram(displaySet(simpleScene(), *catalog), *catalog);
    const auto beside = displayProgram(displaySet(with("kuwahara"), *catalog), *catalog);
    ASSERT_TRUE(without && beside);
    EXPECT_EQ(without->fragment.text, beside->fragment.text);
    EXPECT_EQ(without->fragment.text.find("pictureImage"), std::string::npos);
}

TEST_F(PicturePassesTest, NeutralPass_LeavesThePictureAsItIs) {
    Scene scene = with("kuwahara");
    set(scene, "radius", 0.0);
    EXPECT_TRUE(displaySet(scene, *catalog).passes.empty());
    EXPECT_EQ(capture(scene, true).pixels, capture(simpleScene(), true).pixels);
}

TEST_F(PicturePassesTest, LinearPicture_IsWithoutPasses) {
    EXPECT_EQ(capture(with("kuwahara")).pixels, capture(simpleScene()).pixels);
}

TEST_F(PicturePassesTest, EvenPicture_StaysEvenUnderAPainter) {
    Scene scene = with("kuwahara");
    scene.objects[0].visible = false;
    set(scene, "bristles", 0.0);
    Scene without = scene;
    without.passes.clear();
    EXPECT_LE(difference(capture(scene, true), capture(without, true)), 1.01f / 255.0f);
}

/// Kuwahara's filter takes small detail away and leaves edges where they are.
TEST_F(PicturePassesTest, StraightEdge_StaysSharpUnderAPainter) {
    Scene scene = plate();
    scene.objects[0].translation = {1.0, 0.0, 0.0}; // its left edge is in the middle
    const Image sharp = capture(scene, true, 64);
    scene.passes = {block("pass", "kuwahara")};
    set(scene, "radius", 32.0); // 4 pixels of this picture
    const Image painted = capture(scene, true, 64);
    const auto between = [](const Image& image) {
        int count = 0;
        for (int x = 0; x < image.width; ++x) {
            const float value = pixel(image, x, image.height / 2).g;
            count += value > 0.6f && value < 0.93f ? 1 : 0;
        }
        return count;
    };
    EXPECT_LE(between(painted), between(sharp) + 2);
    EXPECT_NEAR(pixel(painted, 63, 32).g, pixel(sharp, 63, 32).g, 0.02f);
    EXPECT_NEAR(pixel(painted, 0, 32).g, pixel(sharp, 0, 32).g, 0.02f);
}

TEST_F(PicturePassesTest, SeveralPasses_WorkInTheirOrder) {
    Scene scene = simpleScene();
    scene.passes = {block("pass", "kuwahara"), block("pass", "dither")};
    const Image inkLast = capture(scene, true);
    std::swap(scene.passes[0], scene.passes[1]);
    set(scene, "radius", 48.0);
    const Image paintLast = capture(scene, true);
    const auto inked = [](const Image& image) {
        int count = 0;
        for (int i = 0; i < image.width * image.height; ++i) {
            const float g = pixel(image, i % image.width, i / image.width).g;
            count += g < 0.2f || g > 0.85f ? 1 : 0;
        }
        return count;
    };
    EXPECT_EQ(inked(inkLast), 33 * 33); // nothing but the two inks
    EXPECT_LT(inked(paintLast), 33 * 33);
}

TEST_F(PicturePassesTest, SamePassTwice_WorksTwice) {
    Scene once = with("kuwahara");
    set(once, "radius", 64.0);
    Scene twice = once;
    twice.passes.push_back(once.passes[0]);
    EXPECT_GT(difference(capture(once, true), capture(twice, true)), 1.5f / 255.0f);
}

TEST_F(PicturePassesTest, PictureOfTwiceTheSize_LooksTheSame) {
    for (const char* pass : {"kuwahara", "watercolour"}) {
        Scene scene = with(pass);
        if (scene.passes[0].id == "kuwahara") {
            set(scene, "radius", 64.0);
        } else {
            set(scene, "width", 16.0);
            set(scene, "grain", 0.0); // finer than a pixel
        }
        const Image small = capture(scene, true, 64);
        const Image large = averaged(capture(scene, true, 128), 2);
        EXPECT_LT(meanDifference(small, large), 0.012) << pass;
    }
}

/// Half of the light is half of the dots, whatever the pattern.
TEST_F(PicturePassesTest, DitheredTone_KeepsTheMeanOfTheLight) {
    for (const char* pattern : {"bayer", "blue", "diffused"}) {
        Scene scene = with("dither");
        scene.objects[0].visible = false;
        scene.background = glm::dvec3(0.37);
        set(scene, "pattern", std::string(pattern));
        set(scene, "dark", glm::dvec3(0.0));
        set(scene, "light", glm::dvec3(1.0));
        EXPECT_NEAR(mean(capture(scene, true, 128)), 0.37, 0.01) << pattern;
    }
}

TEST_F(PicturePassesTest, ScreenedTone_CoversThatShareOfThePaper) {
    for (const char* mark : {"dots", "lines", "crosses", "spiral"}) {
        for (const double light : {0.15, 0.5, 0.85}) {
            Scene scene = with("screen");
            scene.objects[0].visible = false;
            scene.background = glm::dvec3(light);
            set(scene, "mark", std::string(mark));
            set(scene, "spacing", 64.0); // 16 pixels of this picture
            set(scene, "ink", glm::dvec3(0.0));
            set(scene, "paper", glm::dvec3(1.0));
            const Image shown = capture(scene, true, 128);
            double paper = 0.0;
            for (int i = 0; i < 128 * 128; ++i) {
                paper += std::pow(static_cast<double>(pixel(shown, i % 128, i / 128).g), 2.2);
            }
            EXPECT_NEAR(paper / (128.0 * 128.0), light, 0.03) << mark;
        }
    }
}

/// The image is mostly dark, so that its own tones are far from even.
TEST_F(PicturePassesTest, ToneScreenedByAnImage_CoversThatShareOfThePaper) {
    FileImage image{{64, 64, 1, {}}, 8};
    for (int i = 0; i < 64 * 64; ++i) {
        image.image.pixels.push_back(std::pow((float(i % 64) + 0.5f) / 64.0f, 4.0f));
    }
    const auto picture =
        std::make_shared<const TexturePicture>(madeTexture(image, TextureDecoding::Linear));
    for (const bool isThere : {true, false}) {
        View view = viewOf(with("screen"));
        view.size = glm::ivec2(128);
        renderer->setTextures([&](const TextureUse&, TextureDecoding) {
            return TextureLookup{isThere ? picture : nullptr, !isThere};
        });
        for (const double light : {0.15, 0.85}) {
            Scene scene = with("screen");
            scene.objects[0].visible = false;
            scene.background = glm::dvec3(light);
            set(scene, "mark", std::string("image"));
            set(scene, "threshold", std::string("/some/image.png"));
            set(scene, "threshold.width", 256.0); // 64 pixels of this picture
            set(scene, "angle", 0.0);
            set(scene, "ink", glm::dvec3(0.0));
            set(scene, "paper", glm::dvec3(1.0));
            const auto shown = renderer->capture(scene, view, meshSource(), true);
            ASSERT_TRUE(shown);
            double paper = 0.0;
            for (int i = 0; i < 128 * 128; ++i) {
                paper += std::pow(static_cast<double>(pixel(*shown, i % 128, i / 128).g), 2.2);
            }
            const double expected = isThere ? light : std::round(light);
            EXPECT_NEAR(paper / (128.0 * 128.0), expected, 0.03) << isThere;
        }
    }
}

TEST_F(PicturePassesTest, ScreenOfWhiteAndBlack_LeavesNoDust) {
    FileImage image{{64, 64, 1, {}}, 8};
    for (int i = 0; i < 64 * 64; ++i) {
        image.image.pixels.push_back(float(i % 61) / 60.0f);
    }
    const auto picture =
        std::make_shared<const TexturePicture>(madeTexture(image, TextureDecoding::Linear));
    renderer->setTextures([&](const TextureUse&, TextureDecoding) {
        return TextureLookup{picture, false};
    });
    for (const char* mark : {"dots", "lines", "crosses", "spiral", "image"}) {
        for (const double light : {0.0, 0.997, 1.0}) {
            Scene scene = with("screen");
            scene.objects[0].visible = false;
            scene.background = glm::dvec3(light);
            set(scene, "mark", std::string(mark));
            set(scene, "threshold", std::string("/some/image.png"));
            set(scene, "ink", glm::dvec3(0.0));
            set(scene, "paper", glm::dvec3(1.0));
            const Image shown = capture(scene, true, 128);
            for (int i = 0; i < 128 * 128; ++i) {
                ASSERT_EQ(pixel(shown, i % 128, i / 128), glm::vec3(float(std::round(light))))
                    << mark << ' ' << light;
            }
        }
    }
}

/// The pass returns 0.5 of linear light everywhere.
TEST_F(PicturePassesTest, BlendOfAPass_IsThatOfItsFormula) {
    const auto linear = [&](const std::string& blend, double amount, double light) {
        Scene scene = with("screen");
        scene.objects[0].visible = false;
        scene.background = glm::dvec3(light);
        set(scene, "ink", glm::dvec3(0.5));
        set(scene, "paper", glm::dvec3(0.5));
        set(scene, "blend", blend);
        set(scene, "amount", amount);
        const double shown = pixel(capture(scene, true, 8), 4, 4).g;
        return shown <= 0.04045 ? shown / 12.92 : std::pow((shown + 0.055) / 1.055, 2.4);
    };
    for (const double light : {0.1, 0.7}) {
        EXPECT_NEAR(linear("replace", 0.25, light), 0.5, 0.01);
        EXPECT_NEAR(linear("over", 0.25, light), 0.75 * light + 0.125, 0.01);
        EXPECT_NEAR(linear("multiply", 1.0, light), 0.5 * light, 0.01);
        EXPECT_NEAR(linear("screen", 1.0, light), 0.5 + 0.5 * light, 0.01);
        EXPECT_NEAR(linear("add", 1.0, light), std::min(0.5 + light, 1.0), 0.01);
    }
}

TEST_F(PicturePassesTest, PassOnSurfaces_LeavesTheBackgroundAsItWas) {
    Scene scene = with("screen");
    scene.background = glm::dvec3(0.5);
    set(scene, "ink", glm::dvec3(1.0, 0.0, 0.0));
    set(scene, "paper", glm::dvec3(1.0, 0.0, 0.0));
    for (const char* where : {"surfaces", "background"}) {
        set(scene, "where", std::string(where));
        const Image shown = capture(scene, true, 32);
        const bool isOnSurfaces = std::string(where) == "surfaces";
        EXPECT_EQ(pixel(shown, 0, 0).g > 0.1f, isOnSurfaces);
        EXPECT_EQ(pixel(shown, 16, 16).g < 0.1f, isOnSurfaces);
    }
}

TEST_F(PicturePassesTest, BarePaper_IsWhereNoObjectIs) {
    Scene scene = with("watercolour");
    scene.background = glm::dvec3(0.0);
    set(scene, "background", std::string("bare"));
    set(scene, "grain", 0.0);
    set(scene, "paper", glm::dvec3(0.5));
    set(scene, "wobble", 0.0);
    const Image shown = capture(scene, true);
    EXPECT_NEAR(pixel(shown, 0, 0).g, 0.7354f, 1.1f / 255.0f);
    EXPECT_LT(pixel(shown, 16, 16).g, 0.73f);
}

TEST_F(PicturePassesTest, ValueOfAPass_IsTakenWithoutDrawingTheScene) {
    FrameTarget target(33);
    for (const char* pass : {"kuwahara", "watercolour"}) {
        Scene scene = with(pass);
        renderer->draw(scene, viewOf(scene), meshSource(), target.name());
        const auto before = target.picture();
        set(scene, scene.passes[0].id == "kuwahara" ? "radius" : "thinness",
            scene.passes[0].id == "kuwahara" ? 64.0 : 0.7);
        FrameJob& job = renderer->job();
        const int compiled = renderer->report().compiled;
        ASSERT_TRUE(job.takePasses(scene, scene));
        job.show(target.name());
        const auto after = target.picture();
        EXPECT_NE(before, after) << pass;
        EXPECT_EQ(renderer->report().compiled, compiled);
        renderer->draw(scene, viewOf(scene), meshSource(), target.name());
        EXPECT_EQ(after, target.picture()) << pass;
    }
}

TEST_F(PicturePassesTest, PictureThatWasNotDrawn_IsNotShownAgain) {
    const Scene scene = with("kuwahara");
    EXPECT_FALSE(renderer->job().takePasses(scene, scene));
}

/// A slider may be taken up long after the targets were freed. One sample per pixel is drawn into
/// the picture itself, several are not, and a part of the pixels is stretched to it.
TEST_F(PicturePassesTest, ReleasedTargets_LeaveThePictureToThePasses) {
    FrameTarget target(33);
    for (const auto& [samples, scale] : {std::pair("1", "full"), {"4", "full"}, {"4", "half"}}) {
        SCOPED_TRACE(fmt::format("{} samples, {}", samples, scale));
        Scene scene = with("watercolour");
        for (const auto& [id, level] : {std::pair("samples", samples), {"scale", scale}}) {
            const PictureChoiceText& text = *pictureChoiceText(id);
            scene.accuracy.choose(text.choice, *text.level(level));
        }
        set(scene, "thinness", 0.7);
        renderer->draw(scene, viewOf(scene), meshSource(), target.name());
        const auto wanted = target.picture();
        set(scene, "thinness", 0.2);
        renderer->draw(scene, viewOf(scene), meshSource(), target.name());
        renderer->job().releaseTargets();
        set(scene, "thinness", 0.7);
        ASSERT_TRUE(renderer->job().takePasses(scene, scene));
        renderer->job().show(target.name());
        EXPECT_EQ(target.picture(), wanted);
        renderer->draw(scene, viewOf(scene), meshSource(), target.name());
        EXPECT_EQ(target.picture(), wanted);
    }
}

/// Programs are made ahead while the view rests, and drawn with where nobody sees it.
TEST_F(PicturePassesTest, ReleasedTargets_StayBesideAFrameThatNobodySees) {
    const Scene scene = with("watercolour");
    FrameTarget target(33);
    renderer->draw(scene, viewOf(scene), meshSource(), target.name());
    const auto wanted = target.picture();
    renderer->job().releaseTargets();
    Scene ahead = scene;
    ahead.objects.front().material.model = block("models", "phong");
    ASSERT_TRUE(prewarm(ahead, viewOf(ahead), meshSource())) << "the test needs a new program";
    ASSERT_TRUE(renderer->job().takePasses(scene, scene));
    renderer->job().show(target.name());
    EXPECT_EQ(target.picture(), wanted);
}

TEST_F(PicturePassesTest, TargetsThatAFrameUnseenMakesAnew_HaveNoPicture) {
    const Scene scene = with("watercolour");
    FrameTarget target(33);
    renderer->draw(scene, viewOf(scene), meshSource(), target.name());
    Scene ahead = scene;
    ahead.objects.front().material.model = block("models", "phong");
    ASSERT_TRUE(prewarm(ahead, viewOf(ahead), meshSource()));
    EXPECT_TRUE(renderer->job().takePasses(scene, scene)) << "they are as before";
    const PictureChoiceText& scale = *pictureChoiceText("scale");
    ahead.accuracy.choose(scale.choice, *scale.level("half"));
    ahead.objects.front().material.model = block("models", "gaussian");
    ASSERT_TRUE(prewarm(ahead, viewOf(ahead), meshSource()));
    EXPECT_FALSE(renderer->job().takePasses(scene, scene));
}

TEST_F(PicturePassesTest, ReleasedTargets_OfAPictureWithoutPassesAreGone) {
    const Scene scene = simpleScene();
    FrameTarget target(33);
    renderer->draw(scene, viewOf(scene), meshSource(), target.name());
    renderer->job().releaseTargets();
    EXPECT_FALSE(renderer->job().hasPicture());
}

/// What a frame without them does not have: depths for a pass that reads them.
TEST_F(PicturePassesTest, PassThatReadsSurfaces_NeedsAFrameOfItsOwn) {
    const Scene scene = with("watercolour");
    FrameTarget target(33);
    renderer->draw(scene, viewOf(scene), meshSource(), target.name());
    Scene without = scene;
    without.passes.clear();
    renderer->draw(without, viewOf(without), meshSource(), target.name());
    EXPECT_FALSE(renderer->job().takePasses(scene, scene));
}

/// Shows white where a pass gave what is not finite, and black elsewhere.
class ExaminedPasses : public GpuTest {
  protected:
    void SetUp() override {
        GpuTest::SetUp();
        std::filesystem::copy(PATINA_SOURCE_DIR "/shaders", folder_.path(),
                              std::filesystem::copy_options::recursive);
        replace("passes/picture.glsl", "return x > 0.0 ? min(x, 1.0) : 0.0;",
                "return (floatBitsToUint(x) & 0x7f800000u) == 0x7f800000u ? 1.0 : 0.0;");
        replace("passes/picture.glsl",
                "return abs(x) <= 65504.0 ? x : (x > 0.0 ? 65504.0 : (x < 0.0 ? -65504.0 : 0.0));",
                "return x;");
        catalog = std::make_shared<const Catalog>(
            loadCatalog(std::array{BlockRoot{folder_.path(), true}}));
        ASSERT_TRUE(catalog->errors.empty()) << text(catalog->errors);
        makeRenderer();
    }

    void replace(const std::string& file, const std::string& from, const std::string& to) {
        std::string text = tests::readFile(folder_ / file);
        const auto place = text.find(from);
        ASSERT_NE(place, std::string::npos) << file << " has no " << from;
        tests::writeFile(folder_ / file, text.replace(place, from.size(), to));
    }

    void expectFinite(const Scene& scene, const std::string& what) {
        if (displaySet(scene, *catalog).passes.empty()) {
            return; // a value at which the pass does nothing: it is not drawn
        }
        for (const glm::ivec2 size : {glm::ivec2(1, 1), glm::ivec2(24, 9)}) {
            View view = viewOf(scene);
            view.size = size;
            const auto shown = renderer->capture(scene, view, meshSource(), true);
            ASSERT_TRUE(shown) << what << ": " << shown.error().text();
            for (int i = 0; i < size.x * size.y; ++i) {
                ASSERT_EQ(pixel(*shown, i % size.x, i / size.x), glm::vec3(0.0f)) << what;
            }
        }
    }

    tests::TemporaryFolder folder_;
};

TEST_F(ExaminedPasses, EdgesOfTheirValues_GiveFinitePictures) {
    for (const Block* pass : catalog->ofKind(kinds::pass)) {
        Scene scene = simpleScene();
        scene.exposure = 6.0; // white beside black
        scene.passes = {block("pass", pass->id)};
        expectFinite(scene, pass->id);
        for (const Parameter& parameter : pass->parameters) {
            std::vector<Value> edges;
            if (infoOf(parameter.type).isChoice) {
                for (const EnumValue& value : parameter.values) {
                    edges.emplace_back(value.id);
                }
            } else if (std::holds_alternative<double>(parameter.defaultValue)) {
                edges = {parameter.min, parameter.max};
            } else if (std::holds_alternative<int>(parameter.defaultValue)) {
                edges = {static_cast<int>(parameter.min), static_cast<int>(parameter.max)};
            } else if (std::holds_alternative<glm::dvec3>(parameter.defaultValue)) {
                edges = {glm::dvec3(parameter.min), glm::dvec3(parameter.max)};
            }
            for (const Value& edge : edges) {
                scene.passes = {block("pass", pass->id)};
                scene.passes[0].parameters[parameter.id] = edge;
                expectFinite(scene, pass->id + ": " + parameter.id);
            }
        }
        scene.passes = {block("pass", pass->id)};
        scene.objects.clear();
        expectFinite(scene, pass->id + " without an object");
    }
}

} // namespace
} // namespace patina::picture_passes_test
