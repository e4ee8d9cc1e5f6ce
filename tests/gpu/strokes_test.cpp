// SPDX-License-Identifier: GPL-3.0-or-later
// Marks on shapes whose picture is known.
#include <algorithm>
#include <cmath>
#include <vector>

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "gpu_fixture.h"

namespace patina::strokes_test {
namespace {

constexpr int inkSize = 96;

/// Is how many units of marks' lengths a pixel of that size's pictures has.
constexpr double unit = 512.0 / inkSize;

class Strokes : public GpuTest {
  protected:
    void SetUp() override {
        GpuTest::SetUp();
        makeRenderer();
    }

    /// A plate that fills the picture, whose black dots stand on white paper whatever its light is.
    Scene dotted() const {
        Scene scene = plate();
        scene.objects[0].scale = glm::dvec3(4.0);
        scene.camera.distance = 12.0;
        scene.camera.fieldOfView = 30.0;
        BlockValues dots = block("strokes", "stipple");
        dots.parameters["density"] = 60.0 / (unit * unit);
        dots.parameters["dot.length"] = 5.0 * unit;
        dots.parameters["dot.width"] = 5.0 * unit;
        dots.parameters["variation"] = 0.0;
        dots.parameters["tone.dark"] = 10.0;
        dots.parameters["tone.light"] = 10.0;
        dots.parameters["ink.color"] = glm::dvec3(0.0);
        dots.parameters["paper.color"] = glm::dvec3(1.0);
        scene.objects[0].material.parts["strokes"] = dots;
        return scene;
    }

    static Value& value(Scene& scene, const std::string& id) {
        return scene.objects[0].material.parts.at("strokes").parameters[id];
    }

    Image picture(const Scene& scene, int size = inkSize) {
        Image image = capture(scene, false, size);
        EXPECT_TRUE(renderer->report().messages.empty()) << text(renderer->report().messages);
        return image;
    }

    /// The share of white that ink takes away.
    double inked(const Scene& scene, int size = inkSize) {
        const Image image = picture(scene, size);
        double bare = 0.0;
        for (int y = 0; y < image.height; ++y) {
            for (int x = 0; x < image.width; ++x) {
                bare += pixel(image, x, y).g;
            }
        }
        return 1.0 - bare / (double(image.width) * image.height);
    }

    static double differenceOf(const Image& a, const Image& b) {
        double sum = 0.0;
        for (std::size_t i = 0; i < a.pixels.size(); ++i) {
            sum += std::abs(double(a.pixels[i]) - double(b.pixels[i]));
        }
        return sum / double(a.pixels.size());
    }
};

TEST_F(Strokes, AtAnyDistance_CoverAsMuchOfThePicture) {
    Scene scene = dotted();
    const double near = inked(scene);
    EXPECT_GT(near, 0.05);
    scene.objects[0].scale = glm::dvec3(16.0);
    scene.camera.distance = 48.0;
    EXPECT_NEAR(inked(scene), near, 0.15 * near);
}

/// The mean of each square of pixels.
std::vector<double> meansOf(const Image& image, int squares) {
    std::vector<double> means(std::size_t(squares) * std::size_t(squares), 0.0);
    const int side = image.width / squares;
    for (int i = 0; i < image.width * image.height; ++i) {
        const int square = i / image.width / side * squares + i % image.width / side;
        means.at(std::size_t(square)) +=
            double(image.pixels.at(std::size_t(i * image.channels + 1))) / double(side * side);
    }
    return means;
}

TEST_F(Strokes, OfALargerPicture_AreTheSameDrawing) {
    const Scene scene = dotted();
    const std::vector<double> small = meansOf(picture(scene), 32);
    const std::vector<double> large = meansOf(picture(scene, 4 * inkSize), 32);
    double apart = 0.0;
    for (std::size_t i = 0; i < small.size(); ++i) {
        apart += std::abs(small[i] - large[i]) / double(small.size());
    }
    EXPECT_LT(apart, 0.01);
}

TEST_F(Strokes, ThinnerThanPixels_CoverAsMuchOfThePicture) {
    Scene scene = dotted();
    value(scene, "dot.length") = 2.0 * unit;
    value(scene, "dot.width") = 2.0 * unit;
    const double large = inked(scene, 4 * inkSize);
    EXPECT_GT(large, 0.01);
    EXPECT_NEAR(inked(scene, inkSize / 4), large, 0.25 * large);
}

TEST_F(Strokes, OfAnEnlargedMesh_CoverAsMuch) {
    Scene scene = dotted();
    const double square = inked(scene);
    scene.objects[0].scale = {8.0, 4.0, 4.0};
    EXPECT_NEAR(inked(scene), square, 0.15 * square);
}

TEST_F(Strokes, WithFewerOfThem_CoverAsMuch) {
    Scene scene = dotted();
    const double all = inked(scene);
    scene.objects[0].material.accuracy["marks"] = "50";
    EXPECT_NEAR(inked(scene), all, 0.15 * all);
}

TEST_F(Strokes, OfTheSameScene_AreTheSamePicture) {
    const Scene scene = dotted();
    const Image first = picture(scene);
    makeRenderer();
    EXPECT_EQ(first.pixels, picture(scene).pixels);
    Scene bare = scene;
    bare.objects[0].material.parts.clear();
    EXPECT_NE(first.pixels, picture(bare).pixels);
}

TEST_F(Strokes, ThatComeNearer_FadeInWithoutPopping) {
    Scene scene = dotted();
    const Image before = picture(scene);
    value(scene, "density") = 60.5 / (unit * unit);
    EXPECT_LT(differenceOf(before, picture(scene)), 0.01);
    EXPECT_GT(differenceOf(before, picture(scene)), 0.0);
}

TEST_F(Strokes, OfNoDensity_AreThePictureWithoutThem) {
    Scene scene = dotted();
    value(scene, "density") = 0.0;
    const Image without = picture(scene);
    scene.objects[0].material.parts.clear();
    EXPECT_EQ(without.pixels, picture(scene).pixels);
}

TEST_F(Strokes, OfInkInTheSurfacesLight_HaveItsColour) {
    Scene scene = dotted();
    scene.objects[0].material.model.parameters["diffuse.color"] = glm::dvec3(0.2, 0.6, 0.4);
    value(scene, "wash") = 1.0;
    const Image black = picture(scene);
    value(scene, "tint") = 1.0;
    const Image marked = picture(scene);
    scene.objects[0].material.parts.clear();
    const Image bare = picture(scene);
    EXPECT_LT(differenceOf(marked, bare), 2e-3);
    EXPECT_GT(differenceOf(black, bare), 2e-2);
}

TEST_F(Strokes, NearSilhouettes_LeaveTheMiddleBare) {
    Scene scene = dotted();
    scene.objects[0].mesh = "builtin:sphere";
    scene.objects[0].scale = glm::dvec3(1.0);
    scene.camera.distance = 4.0;
    value(scene, "rim") = 0.2;
    const Image image = picture(scene);
    const auto inkIn = [&](int from, int to) {
        double ink = 0.0;
        for (int y = from; y < to; ++y) {
            for (int x = from; x < to; ++x) {
                ink += 1.0 - pixel(image, x, y).g;
            }
        }
        return ink;
    };
    EXPECT_EQ(inkIn(36, 60), 0.0);
}

/// The height over the width of each blot of ink that does not touch the picture's edge.
std::vector<double> uprightness(const Image& image) {
    const auto size = static_cast<std::size_t>(image.width);
    const auto isInk = [&](std::size_t at) {
        return image.pixels[at * std::size_t(image.channels) + 1] < 0.5f;
    };
    std::vector<bool> isSeen(size * std::size_t(image.height));
    std::vector<double> all;
    for (std::size_t start = 0; start < isSeen.size(); ++start) {
        glm::dvec2 lower(1e9);
        glm::dvec2 upper(-1e9);
        std::vector<std::size_t> open{start};
        while (!open.empty()) {
            const std::size_t at = open.back();
            open.pop_back();
            if (at >= isSeen.size() || isSeen[at] || !isInk(at)) {
                continue;
            }
            isSeen[at] = true;
            const glm::dvec2 place(double(at % size), double(at / size));
            lower = glm::min(lower, place);
            upper = glm::max(upper, place);
            open.insert(open.end(), {at + 1, at - 1, at + size, at - size});
        }
        const bool isInside = lower.x > 0.0 && lower.y > 0.0 && upper.x < double(size) - 1.0 &&
                              upper.y < double(image.height) - 1.0;
        if (isInside && upper.x - lower.x > 5.0) {
            all.push_back((upper.y - lower.y + 1.0) / (upper.x - lower.x + 1.0));
        }
    }
    return all;
}

TEST_F(Strokes, OnAFloorSeenFromTheSide_AreWhole) {
    Scene scene = dotted();
    scene.objects[0].rotation = {};
    value(scene, "dot.length") = 24.0;
    value(scene, "dot.width") = 24.0;
    value(scene, "density") = 1.5;
    for (const double pitch : {80.0, 15.0}) {
        scene.camera.pitch = pitch;
        const std::vector<double> dots = uprightness(picture(scene, 256));
        ASSERT_GT(dots.size(), 5u) << pitch;
        // Some overlap.
        const auto round = std::ranges::count_if(
            dots, [](double upright) { return std::abs(upright - 1.0) < 0.2; });
        EXPECT_GT(double(round), 0.7 * double(dots.size())) << pitch;
    }
}

TEST_F(Strokes, BehindANearerObject_AreHidden) {
    Scene scene = dotted();
    scene.objects[0].rotation = {};
    scene.camera.pitch = 15.0;
    value(scene, "dot.length") = 12.0 * unit;
    value(scene, "dot.width") = 12.0 * unit;
    scene.objects.push_back(object("lambert"));
    scene.objects[1].translation = {0.0, 1.3, 2.0};
    scene.objects[1].material.model.parameters["diffuse.color"] = glm::dvec3(0.0);
    scene.objects[1].material.model.parameters["emissive.color"] = glm::dvec3(0.0, 1.0, 0.0);
    scene.objects.push_back(scene.objects[0]);
    scene.objects[2].mesh = "builtin:sphere";
    scene.objects[2].scale = glm::dvec3(1.0);
    scene.objects[2].translation = {0.3, 1.3, -0.5};
    const Image marked = picture(scene);
    scene.objects[0].material.parts.clear();
    scene.objects[2].material.parts.clear();
    const Image bare = picture(scene);
    EXPECT_NE(marked.pixels, bare.pixels);
    int hiding = 0;
    for (int y = 0; y < bare.height; ++y) {
        for (int x = 0; x < bare.width; ++x) {
            if (pixel(bare, x, y) == glm::vec3(0.0f, 1.0f, 0.0f)) {
                EXPECT_EQ(pixel(marked, x, y), pixel(bare, x, y)) << x << ' ' << y;
                ++hiding;
            }
        }
    }
    EXPECT_GT(hiding, 300);
}

TEST_F(Strokes, OfExtremeValues_EndInAPicture) {
    for (const Block* style : catalog->ofKind("strokes")) {
        Scene scene = simpleScene();
        BlockValues strokes = block("strokes", style->id);
        for (const Parameter& parameter : style->parameters) {
            if (std::holds_alternative<double>(strokes.parameters[parameter.id])) {
                strokes.parameters[parameter.id] = parameter.max;
            }
        }
        scene.objects[0].material.parts["strokes"] = strokes;
        for (const float number : picture(scene, 24).pixels) {
            ASSERT_TRUE(std::isfinite(number) && number >= 0.0f) << style->id;
        }
    }
}

/// What stands on a surface: strokes and shells of every block, on meshes that give them little.
class WhatStandsOnASurface : public Strokes {
  protected:
    void SetUp() override {
        Strokes::SetUp();
        Mesh triangle;
        triangle.vertices = {{{-1.0f, -1.0f, 0.0f}}, {{1.0f, -1.0f, 0.0f}}, {{0.0f, 1.0f, 0.0f}}};
        triangle.indices = {0, 1, 2};
        triangle.bounds.add({-1.0f, -1.0f, 0.0f});
        triangle.bounds.add({1.0f, 1.0f, 0.0f});
        meshes["triangle"] = triangle;
        for (Vertex& vertex : triangle.vertices) {
            vertex.position = {0.3f, 0.2f, 0.0f};
        }
        meshes["point"] = triangle;
        Mesh plain = *primitive("sphere");
        for (Vertex& vertex : plain.vertices) {
            vertex.uv = glm::vec2(0.0f);
            vertex.tangent = glm::vec4(0.0f);
        }
        meshes["plain"] = plain;
    }

    std::vector<const Block*> blocks() const {
        std::vector<const Block*> all = catalog->ofKind("strokes");
        for (const Block* shells : catalog->ofKind("shells")) {
            all.push_back(shells);
        }
        return all;
    }

    /// Makes a scene of one object with the block, one of whose numbers is given by its role.
    Scene with(const Block& standing, const std::string& mesh, std::string_view role,
               double number) const {
        Scene scene = simpleScene();
        scene.objects[0].mesh = "builtin:" + mesh;
        BlockValues& part = scene.objects[0].material.parts[standing.kind];
        part = block(standing.kind, standing.id);
        part.parameters[standing.withRole(role)->id] = number;
        for (const AccuracyChoice& choice : standing.accuracy) {
            scene.objects[0].material.accuracy[choice.id] = choice.values.back().id;
        }
        return scene;
    }

    /// Draws it; the picture has no light that is not finite, and nobody is told anything.
    std::vector<float> valid(const Scene& scene) {
        const Image image = picture(scene, 24);
        const bool isValid = std::ranges::all_of(
            image.pixels, [](float x) { return std::isfinite(x) && x >= 0.0f; });
        EXPECT_TRUE(isValid);
        return image.pixels;
    }
};

TEST_F(WhatStandsOnASurface, OfNoLengthOrDensity_IsTheSurfaceAlone) {
    for (const Block* standing : blocks()) {
        SCOPED_TRACE(standing->id);
        const Scene usual = with(*standing, "sphere", roles::density, 100.0);
        Scene bare = usual;
        bare.objects[0].material.parts.clear();
        const std::vector<float> surface = valid(bare);
        EXPECT_NE(valid(usual), surface);
        EXPECT_EQ(valid(with(*standing, "sphere", roles::length, 0.0)), surface);
        EXPECT_EQ(valid(with(*standing, "sphere", roles::density, 0.0)), surface);
    }
}

TEST_F(WhatStandsOnASurface, OnMeshesThatGiveLittle_EndsInAPicture) {
    for (const Block* standing : blocks()) {
        for (const char* mesh : {"triangle", "point", "plain"}) {
            SCOPED_TRACE(standing->id + " on a " + mesh);
            const double longest = standing->withRole(roles::length)->max;
            const double densest = standing->withRole(roles::density)->max;
            valid(with(*standing, mesh, roles::length, longest));
            valid(with(*standing, mesh, roles::density, densest));
            valid(with(*standing, mesh, roles::density, 1e-6));
        }
    }
}

} // namespace
} // namespace patina::strokes_test
