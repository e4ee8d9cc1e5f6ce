// SPDX-License-Identifier: GPL-3.0-or-later
// A sheared object looks like a mesh that was sheared by hand.
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include "gpu_fixture.h"

namespace patina::shear_test {
namespace {

constexpr int shearSide = 96; // pixels

class Shear : public GpuTest {
  protected:
    void SetUp() override {
        GpuTest::SetUp();
        makeRenderer();
        Mesh slanted = *primitive("sphere");
        const glm::mat3 normals = glm::transpose(glm::inverse(slant_));
        for (Vertex& vertex : slanted.vertices) {
            vertex.position = slant_ * vertex.position;
            vertex.normal = glm::normalize(normals * vertex.normal);
            const glm::vec3 along = slant_ * glm::vec3(vertex.tangent);
            const float size = glm::length(along);
            vertex.tangent = glm::vec4(size > 0.0f ? along / size : along, vertex.tangent.w);
        }
        slanted.bounds = boundsOf(slanted.vertices);
        meshes["slanted"] = slanted;
    }

    /// Returns the mean difference of the pictures of both, over a ground with a shadow.
    double apart(const std::string& model) {
        Scene scene = simpleScene(model);
        scene.camera.pitch = 25.0;
        scene.lights = {sun({-0.5, -1.0, -0.7})};
        scene.lights[0].setPart(kinds::shadows, block("shadows", "hard"));
        scene.ground.mode = GroundMode::Plane;
        scene.objects[0].rotation = {20.0, 40.0, -10.0};
        scene.objects[0].scale = glm::dvec3(0.6);
        scene.objects[0].shear = {0.8, -0.4, 0.5};
        const Image sheared = capture(scene, true, shearSide);
        scene.objects[0].mesh = "builtin:slanted";
        scene.objects[0].shear = glm::dvec3(0.0);
        const Image slanted = capture(scene, true, shearSide);
        double sum = 0.0;
        for (std::size_t i = 0; i < slanted.pixels.size(); ++i) {
            sum += std::abs(double(sheared.pixels[i]) - double(slanted.pixels[i]));
        }
        return sum / double(slanted.pixels.size());
    }

  private:
    const glm::mat3 slant_{1.0f, 0.0f, 0.0f, 0.8f, 1.0f, 0.0f, -0.4f, 0.5f, 1.0f};
};

TEST_F(Shear, LitObject_LooksAsItsShearedMesh) {
    EXPECT_LT(apart("blinn-phong"), 1e-3);
}

TEST_F(Shear, ObjectThatIsDrawnOn_HasTheLinesOfItsShearedMesh) {
    EXPECT_LT(apart("engraving"), 1e-3);
}

} // namespace
} // namespace patina::shear_test
