// SPDX-License-Identifier: GPL-3.0-or-later
// Strands on shapes whose picture is known.
#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "gpu_fixture.h"
#include "shading/effects/shells.h"

namespace patina::shells_test {
namespace {

constexpr int furSize = 96;
constexpr double middlePixel = 0.5 * furSize;

class Shells : public GpuTest {
  protected:
    void SetUp() override {
        GpuTest::SetUp();
        makeRenderer();
    }

    /// A white ball of radius 1 m with upright strands that are all alike, before a grey
    /// background.
    Scene furry(const std::string& mesh = "sphere") const {
        Scene scene = simpleScene();
        scene.objects[0].mesh = "builtin:" + mesh;
        Material& material = scene.objects[0].material;
        material.model.parameters["diffuse.color"] = glm::dvec3(1.0);
        BlockValues fur = block("shells", "fur");
        fur.parameters["strand.length"] = 0.2;
        fur.parameters["density"] = 12.0;
        fur.parameters["variation"] = 0.0;
        fur.parameters["taper"] = 0.0;
        fur.parameters["thickness"] = 1.0;
        fur.parameters["comb"] = 0.0;
        fur.parameters["fins"] = false;
        material.parts["shells"] = fur;
        material.accuracy["layers"] = "16";
        return scene;
    }

    static Value& value(Scene& scene, const std::string& id) {
        return scene.objects[0].material.parts.at("shells").parameters[id];
    }

    Image picture(const Scene& scene, int size = furSize) {
        Image image = capture(scene, false, size);
        EXPECT_TRUE(renderer->report().messages.empty()) << text(renderer->report().messages);
        return image;
    }

    static bool isBackground(const Image& image, int x, int y) {
        return glm::length(pixel(image, x, y) - glm::vec3(0.25f)) < 1e-3f;
    }

    /// Pixels in which something is seen whose distance from the middle lies between that of two
    /// spheres' outlines, as a share of those pixels.
    static double shareBetween(const Scene& scene, const Image& image, double from, double to) {
        const double distance = scene.camera.distance;
        const double scale = middlePixel / std::tan(glm::radians(0.5 * scene.camera.fieldOfView));
        const auto outline = [&](double radius) {
            return scale * radius / std::sqrt(distance * distance - radius * radius);
        };
        int seen = 0;
        int all = 0;
        for (int y = 0; y < image.height; ++y) {
            for (int x = 0; x < image.width; ++x) {
                const double r = std::hypot(x + 0.5 - middlePixel, y + 0.5 - middlePixel);
                if (r > outline(from) + 1.0 && r < outline(to) - 1.0) {
                    ++all;
                    seen += isBackground(image, x, y) ? 0 : 1;
                }
            }
        }
        EXPECT_GT(all, 100);
        return double(seen) / all;
    }

    static double differenceOf(const Image& a, const Image& b) {
        double sum = 0.0;
        for (std::size_t i = 0; i < a.pixels.size(); ++i) {
            sum += std::abs(double(a.pixels[i]) - double(b.pixels[i]));
        }
        return sum / double(a.pixels.size());
    }
};

TEST_F(Shells, Strands_ReachAsFarAsTheyAreLong) {
    Scene scene = furry();
    scene.camera.distance = 5.0;
    const Image image = picture(scene);
    EXPECT_GT(shareBetween(scene, image, 1.0, 1.15), 0.5);
    EXPECT_EQ(shareBetween(scene, image, 1.22, 1.6), 0.0);
}

TEST_F(Shells, ThinStrands_LeaveGapsBesideTheShape) {
    Scene scene = furry();
    scene.camera.distance = 5.0;
    const double dense = shareBetween(scene, picture(scene), 1.0, 1.2);
    value(scene, "thickness") = 0.1;
    value(scene, "density") = 3.0;
    EXPECT_LT(shareBetween(scene, picture(scene), 1.0, 1.2), 0.7 * dense);
}

TEST_F(Shells, LengthOfNothing_IsThePictureWithoutThem) {
    Scene scene = furry("torus");
    value(scene, "strand.length") = 0.0;
    Scene plain = scene;
    plain.objects[0].material.parts.clear();
    plain.objects[0].material.accuracy.clear();
    const Image bare = picture(plain);
    EXPECT_EQ(picture(scene).pixels, bare.pixels);
    EXPECT_EQ(renderer->report().compiled, 0);
}

TEST_F(Shells, Strands_TakeOneProgramAndOneCall) {
    Scene scene = furry();
    for (int i = 1; i < 4; ++i) {
        scene.objects.push_back(scene.objects[0]);
        scene.objects.back().translation = {0.2 * i, 0.0, 0.0};
    }
    picture(scene);
    EXPECT_EQ(renderer->report().programs, 1);
    EXPECT_EQ(renderer->report().drawCalls, 1);
}

/// Each of two objects of one call has all of its layers, at its own place.
TEST_F(Shells, TwoObjects_ArePicturesOfEach) {
    Scene left = furry();
    left.objects[0].scale = glm::dvec3(0.3);
    left.objects[0].translation = {-0.7, 0.0, 0.0};
    Scene right = left;
    right.objects[0].translation = {0.7, 0.0, 0.0};
    Scene both = left;
    both.objects.push_back(right.objects[0]);
    const Image a = picture(left);
    const Image b = picture(right);
    const Image together = picture(both);
    for (int y = 0; y < furSize; ++y) {
        for (int x = 0; x < furSize; ++x) {
            ASSERT_EQ(pixel(together, x, y), pixel(x < furSize / 2 ? a : b, x, y)) << x << ' ' << y;
        }
    }
}

TEST_F(Shells, Fins_FillTheGapsBetweenFewLayers) {
    Scene scene = furry();
    scene.camera.distance = 5.0;
    scene.objects[0].material.accuracy["layers"] = "8";
    value(scene, "strand.length") = 0.5;
    value(scene, "thickness") = 0.2;
    const double without = shareBetween(scene, picture(scene), 1.0, 1.5);
    EXPECT_EQ(renderer->report().programs, 1);
    value(scene, "fins") = true;
    const Image image = picture(scene);
    EXPECT_GT(shareBetween(scene, image, 1.0, 1.5), without + 0.05);
    EXPECT_EQ(shareBetween(scene, image, 1.52, 1.7), 0.0);
    EXPECT_EQ(renderer->report().programs, 2);
}

TEST_F(Shells, Dragged_CompileNothing) {
    Scene scene = furry();
    picture(scene);
    value(scene, "strand.length") = 0.05;
    value(scene, "density") = 80.0;
    value(scene, "comb") = 0.7;
    picture(scene);
    EXPECT_EQ(renderer->report().compiled, 0);
}

TEST_F(Shells, MoreLayers_AreNearerToTheMost) {
    Scene scene = furry();
    scene.camera.distance = 3.0;
    const auto at = [&](const char* layers) {
        scene.objects[0].material.accuracy["layers"] = layers;
        return picture(scene);
    };
    const Image most = at("64");
    const double few = differenceOf(at("8"), most);
    const double more = differenceOf(at("32"), most);
    EXPECT_GT(few, 1e-3);
    EXPECT_LT(more, 0.7 * few);
}

TEST_F(Shells, Shadow_MakesRootsDarker) {
    Scene scene = furry("plane");
    scene.objects[0].rotation = {90.0, 0.0, 0.0};
    scene.camera.distance = 2.0;
    value(scene, "root.color") = glm::dvec3(1.0);
    value(scene, "tone.variation") = 0.0;
    value(scene, "thickness") = 0.4;
    value(scene, "density") = 4.0;
    value(scene, "shadow") = 0.0;
    const Image bright = picture(scene);
    value(scene, "shadow") = 2.0;
    const Image dark = picture(scene);
    float darkest = 1.0f;
    float brightest = 0.0f;
    for (int y = 20; y < furSize - 20; ++y) {
        for (int x = 20; x < furSize - 20; ++x) {
            darkest = std::min(darkest, pixel(dark, x, y).r);
            brightest = std::max(brightest, pixel(dark, x, y).r);
            EXPECT_NEAR(pixel(bright, x, y).r, 1.0f, 2e-2f) << x << ' ' << y;
        }
    }
    EXPECT_NEAR(darkest, std::exp(-2.0f), 0.02f); // the skin
    // A strand is met between the outermost layer and the next below it.
    EXPECT_GT(brightest, std::exp(-2.0f / 16.0f) - 0.005f);
    EXPECT_LT(brightest, 1.0f);
}

TEST_F(Shells, Combing_LeansStrandsOver) {
    Scene scene = furry();
    scene.camera.distance = 5.0;
    value(scene, "comb") = 1.0;
    const Image image = picture(scene);
    int above = 0;
    int below = 0;
    const double scale = middlePixel / std::tan(glm::radians(0.5 * scene.camera.fieldOfView));
    const int edge = int(scale / std::sqrt(24.0)) + 2;
    for (int x = furSize / 2 - 2; x < furSize / 2 + 2; ++x) {
        for (int y = edge; y < furSize / 2; ++y) {
            above += isBackground(image, x, furSize / 2 - 1 - y) ? 0 : 1;
            below += isBackground(image, x, furSize / 2 + y) ? 0 : 1;
        }
    }
    // At the bottom they point down already; at the top they stand upright, since down is behind.
    EXPECT_GT(below, 4);
    value(scene, "comb.direction") = glm::dvec3(1.0, 0.0, 0.0);
    const Image aside = picture(scene);
    int still = 0;
    for (int x = furSize / 2 - 2; x < furSize / 2 + 2; ++x) {
        for (int y = edge; y < furSize / 2; ++y) {
            still += isBackground(aside, x, furSize / 2 + y) ? 0 : 1;
        }
    }
    EXPECT_LT(still, below);
}

TEST_F(Shells, StrandsOfATurnedObject_StayOnItsSurface) {
    Scene scene = furry();
    scene.objects[0].material.model.parameters["diffuse.color"] = glm::dvec3(0.8);
    const Image before = picture(scene);
    scene.objects[0].rotation = {0.0, 40.0, 0.0};
    scene.camera.yaw += 40.0;
    scene.lights[0].block.parameters["direction"] =
        glm::dvec3(-std::sin(glm::radians(40.0)), 0.0, -std::cos(glm::radians(40.0)));
    const Image after = picture(scene);
    EXPECT_LT(differenceOf(before, after), 2e-3);
    scene.objects[0].rotation = {0.0, 47.0, 0.0};
    EXPECT_GT(differenceOf(before, picture(scene)), 1e-2);
}

TEST_F(Shells, ExtremeValues_AreFinite) {
    for (const char* lighting : {"surface", "strand"}) {
        Scene scene = furry();
        scene.objects[0].material.accuracy["layers"] = "8";
        value(scene, "lighting") = std::string(lighting);
        value(scene, "curl") = 1.0;
        for (const double length : {1e-6, 100.0}) {
            for (const double density : {1e-6, 10000.0}) {
                value(scene, "strand.length") = length;
                value(scene, "density") = density;
                for (const float channel : picture(scene, 24).pixels) {
                    ASSERT_TRUE(std::isfinite(channel) && channel >= 0.0f)
                        << length << ' ' << density;
                }
            }
        }
    }
}

TEST_F(Shells, OneTriangle_GrowsStrands) {
    Mesh triangle;
    triangle.vertices = {{{-1.0f, -1.0f, 0.0f}}, {{1.0f, -1.0f, 0.0f}}, {{0.0f, 1.0f, 0.0f}}};
    triangle.indices = {0, 1, 2};
    triangle.bounds.add({-1.0f, -1.0f, 0.0f});
    triangle.bounds.add({1.0f, 1.0f, 0.0f});
    meshes["triangle"] = triangle;
    Scene scene = furry("triangle");
    scene.camera.yaw = 80.0; // seen along the sheet: the strands stand beside it
    const Image image = picture(scene);
    int seen = 0;
    for (int y = 0; y < furSize; ++y) {
        for (int x = 0; x < furSize; ++x) {
            seen += isBackground(image, x, y) ? 0 : 1;
        }
    }
    EXPECT_GT(seen, 300);
}

TEST_F(Shells, MeshWithoutNormals_IsDrawn) {
    Mesh triangle;
    triangle.vertices = {{{-1.0f, -1.0f, 0.0f}, glm::vec3(0.0f)},
                         {{1.0f, -1.0f, 0.0f}, glm::vec3(0.0f)},
                         {{0.0f, 1.0f, 0.0f}, glm::vec3(0.0f)}};
    triangle.indices = {0, 1, 2};
    triangle.bounds.add({-1.0f, -1.0f, 0.0f});
    triangle.bounds.add({1.0f, 1.0f, 0.0f});
    meshes["bare"] = triangle;
    for (const float channel : picture(furry("bare")).pixels) {
        ASSERT_TRUE(std::isfinite(channel) && channel >= 0.0f);
    }
}

TEST_F(Shells, ObjectBesideThePicture_IsSeenByItsStrands) {
    Scene scene = furry();
    scene.camera.distance = 5.0;
    const double half = std::tan(glm::radians(0.5 * scene.camera.fieldOfView)) * 5.0;
    scene.objects[0].translation = {half + 1.12, 0.0, 0.0};
    const Image image = picture(scene);
    int seen = 0;
    for (int y = 0; y < furSize; ++y) {
        seen += isBackground(image, furSize - 1, y) ? 0 : 1;
    }
    EXPECT_GT(seen, 2);
}

} // namespace
} // namespace patina::shells_test
