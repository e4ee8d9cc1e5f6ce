// SPDX-License-Identifier: GPL-3.0-or-later
// Lines along the edges of shapes whose picture is known.
#include <cmath>

#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "gpu_fixture.h"

namespace patina::outline_test {
namespace {

constexpr int outlineSize = 200;
constexpr double middlePixel = 0.5 * outlineSize;
const glm::vec3 lineColor(1.0f, 0.0f, 0.0f);

class Outlines : public GpuTest {
  protected:
    void SetUp() override {
        GpuTest::SetUp();
        makeRenderer();
    }

    /// A white shape with red lines of these widths, before a grey background.
    Scene lined(const std::string& mesh, double width, double creaseWidth) const {
        Scene scene = simpleScene();
        scene.objects[0].mesh = "builtin:" + mesh;
        scene.objects[0].material.model.parameters["diffuse.color"] = glm::dvec3(1.0);
        scene.objects[0].material = withLines(scene.objects[0].material, width, creaseWidth);
        return scene;
    }

    Material withLines(Material material, double width, double creaseWidth) const {
        BlockValues lines = block("outline", "ink-line");
        lines.parameters["color"] = glm::dvec3(lineColor);
        lines.parameters["width"] = width;
        lines.parameters["crease.width"] = creaseWidth;
        material.parts["outline"] = lines;
        return material;
    }

    static Value& value(Scene& scene, const std::string& id) {
        return scene.objects[0].material.parts.at("outline").parameters[id];
    }

    Image picture(const Scene& scene) {
        Image image = capture(scene, false, outlineSize);
        EXPECT_TRUE(renderer->report().messages.empty()) << text(renderer->report().messages);
        return image;
    }

    /// Pixels of the picture per metre at a distance from the eye.
    static double pixelsPerMetre(const Scene& scene, double distance) {
        return middlePixel / (std::tan(glm::radians(0.5 * scene.camera.fieldOfView)) * distance);
    }

    /// How red a pixel is, from the right of the middle of the picture: 1 is a line.
    static double redness(const Image& image, double right, double up = 0.0) {
        const glm::vec3 shown =
            pixel(image, int(std::floor(middlePixel + right)), int(std::floor(middlePixel - up)));
        return shown.r - shown.g;
    }
};

/// The front face of a cube of 1.5 m side, seen straight on.
double frontFace(const Scene& scene, double perMetre) {
    return 0.75 * perMetre * scene.objects[0].scale.x;
}

TEST_F(Outlines, SilhouetteOfASphere_IsARingOfItsWidthAroundIt) {
    const Scene scene = lined("sphere", 6.0, 0.0);
    const Image image = picture(scene);
    // The tangent from the eye.
    const double distance = scene.camera.distance;
    const double radius =
        pixelsPerMetre(scene, distance) * distance / std::sqrt(distance * distance - 1.0);
    int lines = 0;
    for (int y = 0; y < outlineSize; ++y) {
        for (int x = 0; x < outlineSize; ++x) {
            const double r = std::hypot(x + 0.5 - middlePixel, y + 0.5 - middlePixel);
            const glm::vec3 shown = pixel(image, x, y);
            const double red = shown.r - shown.g;
            if (r < radius - 1.0 || r > radius + 7.0) {
                EXPECT_LT(red, 0.01) << x << ' ' << y;
            } else if (r > radius + 1.0 && r < radius + 5.0) {
                EXPECT_EQ(shown, lineColor) << x << ' ' << y;
                ++lines;
            }
        }
    }
    EXPECT_GT(lines, 1500);
}

TEST_F(Outlines, CubeSeenStraightOn_HasALineAroundItsFace) {
    const Scene scene = lined("cube", 4.0, 0.0);
    const Image image = picture(scene);
    const double side = frontFace(scene, pixelsPerMetre(scene, scene.camera.distance - 0.75));
    for (const double along : {-0.9, -0.3, 0.2, 0.8}) {
        EXPECT_NEAR(redness(image, side + 2.0, along * side), 1.0, 0.01);
        EXPECT_NEAR(redness(image, -side - 2.0, along * side), 1.0, 0.01);
        EXPECT_LT(redness(image, side - 1.5, along * side), 0.01);
        EXPECT_LT(redness(image, side + 5.5, along * side), 0.01);
    }
}

TEST_F(Outlines, CornersOfACube_AreRound) {
    const Scene scene = lined("cube", 8.0, 0.0);
    const Image image = picture(scene);
    const double side = frontFace(scene, pixelsPerMetre(scene, scene.camera.distance - 0.75));
    EXPECT_NEAR(redness(image, side + 4.5, side + 4.5), 1.0, 0.01);
    EXPECT_LT(redness(image, side + 7.5, side + 7.5), 0.01);
}

TEST_F(Outlines, CreaseOfACube_LiesOnBothOfItsFaces) {
    Scene scene = lined("cube", 0.0, 6.0);
    scene.objects[0].rotation = {0.0, 45.0, 0.0};
    const Image image = picture(scene);
    for (const double x : {-1.5, 0.5, 1.5}) {
        EXPECT_NEAR(redness(image, x), 1.0, 0.01) << x;
    }
    EXPECT_LT(redness(image, 4.5), 0.01);
    EXPECT_LT(redness(image, -4.5), 0.01);
}

TEST_F(Outlines, EdgesBehindTheCube_AreHidden) {
    Scene scene = lined("cube", 3.0, 3.0);
    const Image image = picture(scene);
    const double front = frontFace(scene, pixelsPerMetre(scene, scene.camera.distance - 0.75));
    const double back = frontFace(scene, pixelsPerMetre(scene, scene.camera.distance + 0.75));
    ASSERT_LT(back, front - 10.0);
    for (double x = -front + 3.0; x < front - 3.0; x += 1.0) {
        EXPECT_LT(redness(image, x, 0.3 * front), 0.01) << x;
    }
}

TEST_F(Outlines, EdgesBlunterThanTheAngle_HaveNoLines) {
    Scene scene = lined("cube", 0.0, 6.0);
    scene.objects[0].rotation = {0.0, 45.0, 0.0};
    value(scene, "crease.angle") = 91.0;
    EXPECT_LT(redness(picture(scene), 0.5), 0.01);
}

TEST_F(Outlines, AnyAngle_ShowsEveryEdgeOfTheMesh) {
    Scene scene = lined("cube", 0.0, 3.0);
    const double side = frontFace(scene, pixelsPerMetre(scene, scene.camera.distance - 0.75));
    EXPECT_LT(redness(picture(scene), 0.25 * side, 0.1 * side), 0.01);
    value(scene, "crease.angle") = 0.0;
    EXPECT_NEAR(redness(picture(scene), 0.25 * side, 0.1 * side), 1.0, 0.01);
}

TEST_F(Outlines, RimOfASheet_HasALineUnlessOpenEdgesHaveNone) {
    Scene scene = lined("plane", 4.0, 0.0);
    scene.objects[0].rotation = {90.0, 0.0, 0.0};
    const double side = pixelsPerMetre(scene, scene.camera.distance);
    scene.camera.distance *= 2.0;
    EXPECT_NEAR(redness(picture(scene), 0.5 * side + 2.0), 1.0, 0.01);
    EXPECT_LT(redness(picture(scene), 0.5 * side - 1.5), 0.01);
    value(scene, "boundaries") = false;
    EXPECT_LT(redness(picture(scene), 0.5 * side + 2.0), 0.01);
}

TEST_F(Outlines, LineOfAnObjectBehind_IsHidden) {
    Scene scene = lined("sphere", 6.0, 0.0);
    scene.objects[0].scale = glm::dvec3(0.4);
    scene.objects[0].translation = {0.0, 0.0, -2.0};
    scene.objects.push_back(object("lambert", "cube"));
    scene.objects.back().material.model.parameters["diffuse.color"] = glm::dvec3(1.0);
    const Image image = picture(scene);
    for (int x = 20; x < outlineSize - 20; ++x) {
        EXPECT_LT(redness(image, x - middlePixel), 0.01) << x;
    }
}

TEST_F(Outlines, WidthOfNothing_IsThePictureWithoutLines) {
    const Scene scene = lined("torus", 0.0, 0.0);
    Scene plain = scene;
    plain.objects[0].material.parts.clear();
    EXPECT_EQ(picture(scene).pixels, picture(plain).pixels);
    EXPECT_EQ(renderer->report().programs, 1);
}

TEST_F(Outlines, Lines_TakeAProgramOfTheirOwn) {
    picture(lined("torus", 2.0, 0.0));
    EXPECT_EQ(renderer->report().programs, 2);
}

TEST_F(Outlines, Lines_LeaveTheSurfacesProgramAsItIs) {
    Scene scene = lined("torus", 2.0, 0.0);
    picture(scene);
    scene.objects[0].material.parts.clear();
    picture(scene);
    EXPECT_EQ(renderer->report().compiled, 0);
}

TEST_F(Outlines, DraggedWidth_CompilesNothing) {
    Scene scene = lined("torus", 2.0, 1.0);
    picture(scene);
    value(scene, "width") = 3.0;
    picture(scene);
    EXPECT_EQ(renderer->report().compiled, 0);
}

TEST_F(Outlines, ManyObjectsOfOneMaterial_TakeTwoCalls) {
    Scene scene = lined("sphere", 2.0, 0.0);
    for (int i = 1; i < 10; ++i) {
        scene.objects.push_back(scene.objects[0]);
        scene.objects.back().translation = {0.1 * i, 0.0, 0.0};
    }
    picture(scene);
    EXPECT_EQ(renderer->report().drawCalls, 2);
}

TEST_F(Outlines, Fog_IsInFrontOfLinesToo) {
    Scene scene = lined("cube", 8.0, 0.0);
    scene.setPart(kinds::fog, block("fog", "exponential"));
    scene.part(kinds::fog)->parameters["density"] = 0.2;
    scene.part(kinds::fog)->parameters["color"] = glm::dvec3(0.0, 0.0, 1.0);
    const double front = scene.camera.distance - 0.75;
    const double side = frontFace(scene, pixelsPerMetre(scene, front));
    const double range =
        front * std::hypot(1.0, (side + 4.0) / (pixelsPerMetre(scene, front) * front));
    const Image image = picture(scene);
    const glm::vec3 shown = pixel(image, int(middlePixel + side + 4.0), outlineSize / 2);
    const double left = std::exp(-0.2 * range);
    EXPECT_NEAR(shown.r, left, 5e-3);
    EXPECT_NEAR(shown.b, 1.0 - left, 5e-3);
}

TEST_F(Outlines, LinesOfAVeil_AreSolid) {
    Scene scene = lined("sphere", 6.0, 0.0);
    scene.objects[0].material.opacity = 0.25;
    const double radius = pixelsPerMetre(scene, scene.camera.distance) * scene.camera.distance /
                          std::sqrt(scene.camera.distance * scene.camera.distance - 1.0);
    for (const char* way : {"", "weighted", "peeled"}) {
        scene.setPart(kinds::transparency, std::nullopt);
        if (*way != '\0') {
            scene.setPart(kinds::transparency, block("transparency", way));
        }
        EXPECT_NEAR(redness(picture(scene), radius + 3.0), 1.0, 0.01) << way;
    }
}

TEST_F(Outlines, Veil_LiesOverTheLinesBehindIt) {
    Scene scene = lined("sphere", 8.0, 0.0);
    scene.objects[0].scale = glm::dvec3(0.5);
    scene.objects[0].material.opacity = 0.5;
    Object veil = object("lambert", "plane");
    veil.material.model.parameters["diffuse.color"] = glm::dvec3(1.0);
    veil.rotation = {90.0, 0.0, 0.0};
    veil.translation = {0.0, 0.0, 1.0};
    veil.material.opacity = 0.5;
    scene.objects.push_back(veil);
    const double distance = scene.camera.distance;
    const double radius =
        0.5 * pixelsPerMetre(scene, distance) * distance / std::sqrt(distance * distance - 0.25);
    for (const char* way : {"", "weighted", "peeled"}) {
        scene.setPart(kinds::transparency, std::nullopt);
        if (*way != '\0') {
            scene.setPart(kinds::transparency, block("transparency", way));
        }
        EXPECT_NEAR(redness(picture(scene), radius + 4.0), 0.5, 0.05) << way;
    }
}

/// The veil behind a line does not shine through it, whatever puts the layers together.
TEST_F(Outlines, LinesBeforeAVeil_HideIt) {
    Scene scene = lined("sphere", 8.0, 0.0);
    scene.objects[0].scale = glm::dvec3(0.5);
    scene.objects[0].material.opacity = 0.5;
    Object veil = object("lambert", "plane");
    veil.rotation = {90.0, 0.0, 0.0};
    veil.translation = {0.0, 0.0, -1.0};
    veil.material.opacity = 0.5;
    scene.objects.push_back(veil);
    const double distance = scene.camera.distance;
    const double radius =
        0.5 * pixelsPerMetre(scene, distance) * distance / std::sqrt(distance * distance - 0.25);
    for (const char* way : {"weighted", "peeled"}) {
        scene.setPart(kinds::transparency, block("transparency", way));
        EXPECT_NEAR(redness(picture(scene), radius + 4.0), 1.0, 0.01) << way;
    }
}

TEST_F(Outlines, ObjectAroundTheEye_IsDrawn) {
    Scene scene = lined("cube", 4.0, 4.0);
    scene.camera.distance = 0.05;
    scene.camera.yaw = 40.0;
    for (const float channel : picture(scene).pixels) {
        ASSERT_TRUE(std::isfinite(channel));
    }
}

TEST_F(Outlines, EdgeBeforeTheEye_IsCutAtTheNearPlane) {
    Scene scene = lined("cube", 0.0, 4.0);
    scene.objects[0].scale = {1.0, 1.0, 20.0}; // its long edges run past the eye
    scene.objects[0].translation = {0.0, -1.0, 0.0};
    const Image image = picture(scene);
    // Along the upper edge at the right, seen from above: from the lower corner to the vanishing
    // point.
    int found = 0;
    for (double depth = 2.0; depth < 14.0; depth += 1.0) {
        const double perMetre = pixelsPerMetre(scene, depth);
        const double right = 0.75 * perMetre;
        const double up = -0.25 * perMetre;
        if (right < middlePixel - 2.0) {
            found += redness(image, right - 0.5, up - 0.5) > 0.5 ? 1 : 0;
        }
    }
    EXPECT_GT(found, 8);
}

} // namespace
} // namespace patina::outline_test
