// SPDX-License-Identifier: GPL-3.0-or-later
#include <epoxy/gl.h>

#include "transparency_fixture.h"

namespace patina::transparency_test {
namespace {

constexpr int size = 48;

/// Half a step of a half float, in which the picture is stored, and the same again for the sum of
/// the roundings before it.
constexpr double halfFloat = 1.0 / 1024.0;

/// How far pixels are from what they are by hand, and how many could be compared.
struct Distance {
    double max = 0.0;
    int pixels = 0;
};

class Peeling : public TransparencyTest {
  protected:
    Distance distance(const Image& image, std::size_t layers) const {
        Distance found;
        std::vector<Crossing> met;
        for (int i = 0; i < size * size; ++i) {
            const glm::ivec2 at(i % size, i / size);
            if (!crossings(at, size, met)) {
                continue;
            }
            const glm::dvec3 wanted = inOrder(met, layers);
            const glm::dvec3 off = glm::abs(glm::dvec3(pixel(image, at.x, at.y)) - wanted);
            found.max = std::max({found.max, off.x, off.y, off.z});
            ++found.pixels;
        }
        return found;
    }
};

TEST_F(Peeling, SheetsBehindEachOther_AreInTheirOrder) {
    choose("peeled");
    addRandomSheets(8, 3, 0.0);
    const Distance off = distance(drawn(size), 8);
    EXPECT_LT(off.max, halfFloat);
    EXPECT_GT(off.pixels, size * size / 2);
}

TEST_F(Peeling, SheetsThatCross_AreInTheOrderOfEachPixel) {
    choose("peeled");
    for (unsigned seed = 0; seed < 6; ++seed) {
        scene_.objects.clear();
        addRandomSheets(8, seed);
        const Distance off = distance(drawn(size), 8);
        EXPECT_LT(off.max, halfFloat) << seed;
        EXPECT_GT(off.pixels, size * size / 2) << seed;
    }
}

TEST_F(Peeling, SheetsThatCross_AreWrongWhenSortedByObject) {
    addRandomSheets(8, 1);
    EXPECT_GT(distance(drawn(size), 8).max, 0.05);
}

TEST_F(Peeling, MoreSheetsThanLayers_LoseTheFarthest) {
    choose("peeled");
    scene_.part(kinds::transparency)->parameters["layers"] = 3;
    addRandomSheets(8, 2);
    EXPECT_LT(distance(drawn(size), 3).max, halfFloat);
}

TEST_F(Peeling, OfOneLayer_IsTheNearestAlone) {
    choose("peeled");
    scene_.part(kinds::transparency)->parameters["layers"] = 1;
    addRandomSheets(5, 4);
    EXPECT_LT(distance(drawn(size), 1).max, halfFloat);
}

TEST_F(Peeling, OrderOfTheObjects_DoesNotShow) {
    choose("peeled");
    addRandomSheets(8, 5);
    const Image one = drawn(size);
    std::ranges::reverse(scene_.objects);
    EXPECT_EQ(one.pixels, drawn(size).pixels);
}

/// The inside of a sheet has the same colour in all samples.
TEST_F(Peeling, WithSeveralSamples_GivesTheSameAwayFromEdges) {
    choose("peeled");
    addRandomSheets(4, 6, 0.0);
    const Image several = drawn(size, 4);
    const glm::vec3 off = glm::abs(middle(several) - middle(drawn(size, 1)));
    EXPECT_LT(std::max({off.r, off.g, off.b}), float(halfFloat));
}

/// Each sample is in its own order: where two sheets cross, a pixel is the mean of both.
TEST_F(Peeling, WithSeveralSamples_SmoothsWhereSheetsCross) {
    choose("peeled");
    scene_.objects = {sheet({1.0, 0.0, 0.0}, 0.9, 0.0), sheet({0.0, 1.0, 0.0}, 0.9, 0.0)};
    scene_.objects[0].rotation.y = 30.0;
    scene_.objects[1].rotation = {90.0, -30.0, 10.0}; // so that they cross aslant
    const auto between = [](const Image& image) {
        int count = 0;
        for (int y = size / 4; y < 3 * size / 4; ++y) {
            for (int x = size / 4; x < 3 * size / 4; ++x) {
                const float red = pixel(image, x, y).r;
                count += red > 0.2f && red < 0.8f;
            }
        }
        return count;
    };
    EXPECT_EQ(between(drawn(size, 1)), 0);
    EXPECT_GT(between(drawn(size, 4)), size / 8);
}

TEST_F(Peeling, BehindSomethingSolid_IsNotSeen) {
    choose("peeled");
    scene_.objects = {sheet({0.5, 0.25, 1.0}, 1.0, 0.5), sheet({1.0, 0.0, 0.0}, 0.5, 0.0)};
    const glm::vec3 seen = middle(drawn(size));
    EXPECT_EQ(seen, glm::vec3(0.5f, 0.25f, 1.0f));
}

/// A sphere seen through itself: its front, then its back.
TEST_F(Peeling, ClosedMesh_ShowsItsBackThroughItsFront) {
    choose("peeled");
    scene_.objects = {sheet({1.0, 1.0, 1.0}, 0.5, 0.0)};
    scene_.objects[0].mesh = "builtin:sphere";
    EXPECT_NEAR(middle(drawn(size)).r, 0.5 + 0.5 * 0.5 + 0.25 * 0.25, halfFloat);
}

class Mixing : public TransparencyTest {};

TEST_F(Mixing, OfOneSheet_IsThatOverTheBackground) {
    choose("weighted");
    scene_.objects = {sheet({0.75, 0.25, 0.5}, 0.5, 0.0)};
    const glm::dvec3 off = glm::abs(glm::dvec3(middle(drawn(size))) -
                                    0.5 * (scene_.background + glm::dvec3(0.75, 0.25, 0.5)));
    EXPECT_LT(std::max({off.x, off.y, off.z}), halfFloat);
}

TEST_F(Mixing, OfOneColour_IsExact) {
    choose("weighted");
    addRandomSheets(6, 8);
    for (Object& object : scene_.objects) {
        object.material.model.parameters["emissive.color"] = glm::dvec3(0.5, 0.75, 1.0);
    }
    const Image mixed = drawn(size);
    choose("peeled");
    const Image exact = drawn(size);
    for (std::size_t i = 0; i < mixed.pixels.size(); ++i) {
        ASSERT_NEAR(mixed.pixels[i], exact.pixels[i], halfFloat);
    }
}

TEST_F(Mixing, OrderOfTheObjects_DoesNotShow) {
    choose("weighted");
    addRandomSheets(8, 5);
    const Image one = drawn(size);
    std::ranges::reverse(scene_.objects);
    const Image other = drawn(size);
    for (std::size_t i = 0; i < one.pixels.size(); ++i) {
        ASSERT_NEAR(one.pixels[i], other.pixels[i], halfFloat);
    }
}

/// What a widget, a file or the command line can ask for at most.
class HardLayers : public TransparencyTest {
  protected:
    void expectLight(const char* id) {
        choose(id);
        const Image image = drawn(size, 4);
        EXPECT_TRUE(std::ranges::all_of(image.pixels, [](float x) {
            return std::isfinite(x) && x >= 0.0f;
        })) << id;
    }
};

TEST_F(HardLayers, OfTheBrightestLight_AreFinite) {
    addRandomSheets(8, 11);
    scene_.lights = {sun({0.0, 0.0, -1.0})};
    scene_.lights[0].block.parameters["intensity"] = 10000.0;
    for (Object& object : scene_.objects) {
        object.material.model.parameters["diffuse.color"] = glm::dvec3(1.0);
    }
    scene_.lights.resize(20, scene_.lights[0]);
    scene_.objects[0].material.opacity = 1.0 - 1e-7;
    expectLight("weighted");
    expectLight("peeled");
}

TEST_F(HardLayers, AsGoodAsInvisible_AreFinite) {
    addRandomSheets(8, 12);
    for (std::size_t i = 0; i < scene_.objects.size(); ++i) {
        scene_.objects[i].material.opacity = std::pow(10.0, -6.0 * double(i));
    }
    expectLight("weighted");
    expectLight("peeled");
}

TEST_F(HardLayers, AtOneDepth_AreFinite) {
    scene_.objects.assign(4, sheet({1.0, 0.5, 0.25}, 0.5, 0.0));
    expectLight("weighted");
    expectLight("peeled");
}

TEST_F(HardLayers, AroundTheEye_AreFinite) {
    addRandomSheets(8, 13);
    scene_.camera.distance = 0.05;
    expectLight("weighted");
    expectLight("peeled");
}

class NoTransparency : public TransparencyTest {
  protected:
    static int textures() {
        int count = 0;
        for (GLuint name = 1; name < 256; ++name) {
            count += glIsTexture(name) == GL_TRUE;
        }
        return count;
    }
};

TEST_F(NoTransparency, Chosen_ChangesNeitherPictureNorProgramsNorMemory) {
    scene_ = simpleScene();
    const Image before = drawn(size);
    const FrameReport report = renderer->report();
    const int count = textures();
    for (const char* id : {"weighted", "peeled"}) {
        choose(id);
        EXPECT_EQ(drawn(size).pixels, before.pixels);
        EXPECT_EQ(renderer->report().compiled, 0);
        EXPECT_EQ(renderer->report().effects, report.effects);
        EXPECT_EQ(textures(), count);
    }
}

TEST_F(NoTransparency, AfterThereWasSome_GivesItsMemoryBack) {
    scene_ = simpleScene();
    drawn(size);
    const int count = textures();
    choose("peeled");
    scene_.objects[0].material.opacity = 0.5;
    drawn(size);
    EXPECT_GT(textures(), count);
    scene_.objects[0].material.opacity = 1.0;
    drawn(size);
    EXPECT_EQ(textures(), count);
}

TEST_F(NoTransparency, DraggingTheLayers_CompilesNothing) {
    choose("peeled");
    addRandomSheets(3, 9);
    drawn(size);
    scene_.part(kinds::transparency)->parameters["layers"] = 2;
    drawn(size);
    EXPECT_EQ(renderer->report().compiled, 0);
}

} // namespace
} // namespace patina::transparency_test
