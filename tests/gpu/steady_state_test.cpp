// SPDX-License-Identifier: GPL-3.0-or-later
// Counts what the draw path asks of the heap on its own thread.
#include <cstdlib>
#include <new>
#include <optional>

#include "catalog/curve.h"
#include "frame_target.h"
#include "gpu_fixture.h"
#include "render/frame/frame_job.h"

namespace {

thread_local long allocations = 0;

void* counted(std::size_t size) {
    ++allocations;
    if (void* memory = std::malloc(size == 0 ? 1 : size)) {
        return memory;
    }
    throw std::bad_alloc();
}

} // namespace

void* operator new(std::size_t size) {
    return counted(size);
}
void* operator new[](std::size_t size) {
    return counted(size);
}
void operator delete(void* memory) noexcept {
    std::free(memory);
}
void operator delete[](void* memory) noexcept {
    std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
    std::free(memory);
}
void operator delete[](void* memory, std::size_t) noexcept {
    std::free(memory);
}

namespace patina::steady_state_test {
namespace {

class SteadyStateTest : public GpuTest {
  protected:
    void SetUp() override {
        GpuTest::SetUp();
        makeRenderer();
        target_.emplace(33);
        source_ = meshSource();
        scene_ = simpleScene("cook-torrance");
        scene_.objects.push_back(object("strauss", "torus"));
        scene_.objects[1].material.opacity = 0.5;
        scene_.lights.push_back(light("point"));
        scene_.lights.push_back(light("head"));
        scene_.setPart(kinds::fog, block("fog", "exponential"));
        scene_.lights[0].setPart(kinds::shadows, block("shadows", "soft"));
        scene_.lights[1].setPart(kinds::shadows, block("shadows", "filtered"));
        scene_.ground.mode = GroundMode::Plane;
    }

    void TearDown() override {
        target_.reset();
        GpuTest::TearDown();
    }

    View view() const {
        View view = viewOf(scene_);
        view.isMoving = isMoving_;
        return view;
    }

    void draw() { renderer->draw(scene_, view(), source_, target_->name()); }

    /// Allocations of the next frame after the working memory has been made.
    long ofTheNextFrame() {
        const View drawn = view();
        const long before = allocations;
        renderer->draw(scene_, drawn, source_, target_->name());
        return allocations - before;
    }

    Scene scene_;
    MeshSource source_;
    bool isMoving_ = false;
    std::optional<FrameTarget> target_;
};

TEST_F(SteadyStateTest, FirstFrame_Allocates) {
    EXPECT_GT(ofTheNextFrame(), 0);
}

TEST_F(SteadyStateTest, ChangedParameter_AllocatesNothing) {
    draw();
    draw();
    std::get<double>(scene_.objects[0].material.model.parameters["roughness"]) = 0.77;
    EXPECT_EQ(ofTheNextFrame(), 0);
}

TEST_F(SteadyStateTest, DraggedPointOfACurve_AllocatesAndCompilesNothing) {
    scene_.objects[0].material = object("hatching", "sphere").material;
    auto& curve = scene_.objects[0].material.model.parameters["tone.curve"];
    curve = curveValue(CurvePoints{{0.0, 0.0}, {0.5, 0.7}, {1.0, 1.0}});
    draw();
    draw();
    std::get<NumberList>(curve).numbers[3] = 0.3;
    EXPECT_EQ(ofTheNextFrame(), 0);
    EXPECT_EQ(renderer->report().compiled, 0);
}

TEST_F(SteadyStateTest, DraggedStopOfARamp_AllocatesAndCompilesNothing) {
    scene_.objects[0].material = object("toon", "sphere").material;
    Values& values = scene_.objects[0].material.model.parameters;
    values["tones"] = std::string("ramp");
    draw();
    draw();
    std::get<NumberList>(values["tone.ramp"]).numbers[1] = 0.1;
    EXPECT_EQ(ofTheNextFrame(), 0);
    EXPECT_EQ(renderer->report().compiled, 0);
}

/// The driver makes its own state for the table at its second drawing.
TEST_F(SteadyStateTest, ValueOfATable_AllocatesAndCompilesNothing) {
    scene_.objects[1].material.accuracy["terms"] = "table";
    for (const double kf : {1.1, 1.2, 1.2}) {
        std::get<double>(scene_.objects[1].material.model.parameters["kf"]) = kf;
        draw();
    }
    std::get<double>(scene_.objects[1].material.model.parameters["kf"]) = 1.3;
    EXPECT_EQ(ofTheNextFrame(), 0);
    EXPECT_EQ(renderer->report().filledTables, 1);
    EXPECT_EQ(renderer->report().compiled, 0);
}

TEST_F(SteadyStateTest, MovedCamera_AllocatesNothing) {
    draw();
    draw();
    scene_.camera.yaw += 10.0;
    EXPECT_EQ(ofTheNextFrame(), 0);
}

TEST_F(SteadyStateTest, MovedImage_AllocatesNothing) {
    const auto picture = std::make_shared<const TexturePicture>(
        madeTexture({{1, 1, 3, {1.0f, 1.0f, 1.0f}}, 8}, TextureDecoding::Color));
    renderer->setTextures([picture](const TextureUse&, TextureDecoding) {
        return TextureLookup{picture, false};
    });
    TextureUse& use = scene_.objects[0].material.textures["diffuse.color"];
    use = textureUse("diffuse.color", "/a name that is too long to lie in a string itself.png");
    draw();
    draw();
    use.offset.x = 0.25;
    EXPECT_EQ(ofTheNextFrame(), 0);
}

/// The driver makes its own state for the map at its second drawing.
TEST_F(SteadyStateTest, TurnedLight_AllocatesNothing) {
    draw();
    scene_.lights[0].block.parameters["direction"] = glm::dvec3(-0.3, -1.0, 0.2);
    draw();
    scene_.lights[0].block.parameters["direction"] = glm::dvec3(0.3, -1.0, 0.2);
    EXPECT_EQ(ofTheNextFrame(), 0);
}

TEST_F(SteadyStateTest, ChangedLight_AllocatesNothing) {
    draw();
    draw();
    std::get<double>(scene_.lights[0].block.parameters["intensity"]) = 2.0;
    EXPECT_EQ(ofTheNextFrame(), 0);
}

TEST_F(SteadyStateTest, DraggedEnvironment_AllocatesNothing) {
    scene_.setPart(kinds::environment, block("environment", "studio"));
    draw();
    draw();
    for (const char* id : {"key.intensity", "intensity", "rotate"}) {
        std::get<double>(scene_.part(kinds::environment)->parameters[id]) += 0.5;
        EXPECT_EQ(ofTheNextFrame(), 0) << id;
        EXPECT_EQ(renderer->report().compiled, 0) << id;
    }
}

/// Each drag begins with the fitted light and ends with the sampled one.
TEST_F(SteadyStateTest, DragUnderASampledEnvironment_AllocatesAndCompilesNothing) {
    scene_.setPart(kinds::environment, block("environment", "studio"));
    double& roughness = std::get<double>(scene_.objects[0].material.model.parameters["roughness"]);
    for (const bool isMoving : {false, true, false, true, false}) {
        isMoving_ = isMoving;
        draw();
        EXPECT_EQ(renderer->job().environmentSamples() == 0, isMoving);
    }
    isMoving_ = true;
    roughness = 0.31;
    draw(); // names what is in the programs now
    EXPECT_EQ(renderer->report().compiled, 0);
    for (const double value : {0.32, 0.33}) {
        roughness = value;
        EXPECT_EQ(ofTheNextFrame(), 0) << value;
        EXPECT_EQ(renderer->report().compiled, 0) << value;
        EXPECT_EQ(renderer->report().filledTables, 1) << value;
    }
    isMoving_ = false;
    draw();
    EXPECT_EQ(renderer->report().compiled, 0);
}

} // namespace
} // namespace patina::steady_state_test
