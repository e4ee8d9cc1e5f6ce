// SPDX-License-Identifier: GPL-3.0-or-later
// Several views of a context that share what is in the GPU's memory, each with its own frames.
#include <memory>
#include <vector>

#include "gpu_fixture.h"
#include "render/gpu/gpu_mesh_store.h"
#include "render/lights/environment_pictures.h"
#include "render/plan/frame_planner.h"
#include "scene/primitives.h"

namespace patina::tests::shared_views_test {
namespace {

constexpr int size = 48;

class SharedViews : public GpuTest {
  protected:
    void SetUp() override {
        GpuTest::SetUp();
        makeRenderer();
    }

    void TearDown() override {
        others_.clear();
        GpuTest::TearDown();
    }

    Renderer& other() {
        others_.push_back(renderer->forAnotherView());
        return *others_.back();
    }

    /// With shadows, a ground and something that is transparent.
    Scene everything(double yaw) {
        Scene scene = simpleScene("phong");
        scene.objects.push_back(object("lambert", "cube"));
        scene.objects[1].translation = {0.5, 0.5, -1.0};
        scene.objects[0].material.opacity = 0.5;
        scene.lights = {sun({0.5, -1.0, -1.0})};
        scene.lights[0].setPart(kinds::shadows, block("shadows", "filtered"));
        scene.ground.mode = GroundMode::Plane;
        scene.camera.yaw = yaw;
        scene.camera.pitch = 20.0;
        return scene;
    }

    std::vector<float> captured(Renderer& by, const Scene& scene) {
        const auto image = by.capture(scene, viewOf(scene, size), meshSource(), false);
        EXPECT_TRUE(image);
        return image ? image->pixels : std::vector<float>();
    }

    /// The picture of a view that shares nothing.
    std::vector<float> alone(const Scene& scene) {
        auto made = Renderer::create({});
        EXPECT_TRUE(made);
        (*made)->setCatalog(catalog);
        return captured(**made, scene);
    }

    FrameJob& begin(Renderer& by, const Scene& scene) {
        return by.begin(scene, viewOf(scene, size), meshSource(), FramePurpose::Capture);
    }

    static void step(FrameJob& job) { job.step(FrameJob::Clock::now()); }

    void finish(FrameJob& job) {
        while (job.step(FrameJob::Clock::now()) == FrameJob::Progress::More) {
        }
    }

  private:
    std::vector<std::unique_ptr<Renderer>> others_;
};

TEST_F(SharedViews, OfOneScene_CompileOnce) {
    const Scene scene = everything(0.0);
    captured(*renderer, scene);
    Renderer& second = other();
    captured(second, scene);
    EXPECT_EQ(second.report().compiled, 0);
}

TEST_F(SharedViews, OfOneScene_ShareShadowMaps) {
    captured(*renderer, everything(0.0));
    EXPECT_EQ(renderer->report().shadowMaps, 1);
    Renderer& second = other();
    captured(second, everything(90.0));
    EXPECT_EQ(second.report().shadowMaps, 0);
}

TEST_F(SharedViews, WithoutShadows_LeaveTheMapsToTheOthers) {
    const Scene scene = everything(0.0);
    Scene dark = scene;
    dark.lights[0].setPart(kinds::shadows, std::nullopt);
    captured(*renderer, scene);
    Renderer& second = other();
    for (int frame = 0; frame < 3; ++frame) {
        EXPECT_EQ(captured(second, dark), alone(dark));
        EXPECT_EQ(captured(*renderer, scene), alone(scene));
        EXPECT_EQ(renderer->report().shadowMaps, 0);
    }
}

TEST_F(SharedViews, OfOneEnvironment_HaveItsPictureOnce) {
    const auto image = EnvironmentImage::missing();
    EnvironmentPictures pictures;
    auto [first, isNew] = pictures.of(image);
    EXPECT_TRUE(isNew);
    EXPECT_EQ(pictures.of(image).first, first);
    EXPECT_NE(pictures.of(nullptr).first, first);
    first.reset();
    EXPECT_TRUE(pictures.of(image).second) << "nobody held it";
}

/// The other view shows something else for longer than anything is kept for its own sake.
TEST_F(SharedViews, MeshThatAViewHolds_StaysWhileOthersDraw) {
    GpuMeshStore meshes;
    const Mesh ball = primitive("sphere").value();
    const std::shared_ptr<GpuMesh> held = meshes.prepare(ball.view());
    const Mesh cube = primitive("cube").value();
    for (int frame = 0; frame < 300; ++frame) {
        meshes.beginFrame();
        meshes.prepare(cube.view());
        meshes.endFrame();
    }
    meshes.beginFrame();
    EXPECT_EQ(meshes.prepare(ball.view()), held);
}

/// So many triangles that a map takes several steps: each view goes on where the other one stopped.
TEST_F(SharedViews, LargeMapsInTurns_DrawThePicturesOfEachAlone) {
    Scene scene = everything(20.0);
    for (int i = 0; i < 8; ++i) {
        scene.objects.push_back(object("lambert", "torus"));
        scene.objects.back().translation = {0.3 * i - 1.0, 0.2 * i, -1.0};
    }
    Scene turned = scene;
    turned.camera.yaw = 200.0;
    FrameJob& first = begin(*renderer, scene);
    FrameJob& second = begin(other(), turned);
    for (bool isMore = true; isMore;) {
        isMore = first.step(FrameJob::Clock::now()) == FrameJob::Progress::More;
        isMore |= second.step(FrameJob::Clock::now()) == FrameJob::Progress::More;
    }
    EXPECT_EQ(first.read(false)->pixels, alone(scene));
    EXPECT_EQ(second.read(false)->pixels, alone(turned));
}

/// Four views, each a step at a time.
TEST_F(SharedViews, StepsInTurns_DrawThePicturesOfEachAlone) {
    std::vector<Scene> scenes;
    std::vector<FrameJob*> jobs;
    for (const double yaw : {0.0, 90.0, 180.0, 270.0}) {
        scenes.push_back(everything(yaw));
    }
    for (const Scene& scene : scenes) {
        jobs.push_back(&begin(other(), scene));
    }
    bool isMore = true;
    while (isMore) {
        isMore = false;
        for (FrameJob* job : jobs) {
            isMore |= job->step(FrameJob::Clock::now()) == FrameJob::Progress::More;
        }
    }
    for (std::size_t i = 0; i < scenes.size(); ++i) {
        EXPECT_EQ(jobs[i]->read(false)->pixels, alone(scenes[i])) << i;
    }
}

/// The other one's shadows lie elsewhere: the maps are planned and drawn again.
TEST_F(SharedViews, OfOtherScenesInBetween_LeaveAFrameAsItIs) {
    const Scene scene = everything(30.0);
    Scene moved = everything(60.0);
    moved.objects[1].translation = {-0.5, 0.2, 0.5};
    moved.objects[0].mesh = "builtin:torus";
    Renderer& second = other();
    for (int given = 1; given < 6; ++given) {
        FrameJob& job = begin(*renderer, scene);
        for (int i = 0; i < given; ++i) {
            step(job);
        }
        EXPECT_EQ(captured(second, moved), alone(moved));
        finish(job);
        EXPECT_EQ(job.read(false)->pixels, alone(scene)) << given;
    }
}

TEST_F(SharedViews, ViewThatGoes_LeavesTheOthers) {
    const Scene scene = everything(30.0);
    auto second = renderer->forAnotherView();
    captured(*second, scene);
    FrameJob& job = begin(*renderer, scene);
    step(job);
    second.reset();
    finish(job);
    EXPECT_EQ(job.read(false)->pixels, alone(scene));
}

TEST_F(SharedViews, Catalog_IsThatOfAll) {
    Renderer& second = other();
    const std::vector<float> before = captured(*renderer, simpleScene());
    second.setCatalog(std::make_shared<const Catalog>(*catalog));
    EXPECT_EQ(captured(*renderer, simpleScene()), before);
    EXPECT_EQ(captured(second, simpleScene()), before);
}

using Plan = GpuTest;

TEST_F(Plan, OfASceneAndAView_HasItsObjectsAndMaterials) {
    Scene scene = simpleScene("phong");
    scene.objects.push_back(scene.objects[0]);
    scene.objects.push_back(object("lambert", "cube"));
    scene.objects[1].translation.x = 1000.0;
    scene.objects[2].visible = false;
    FramePlanner planner;
    FramePlan plan;
    const View view = viewOf(scene);
    planner.make(plan, scene, view, meshSource(), *catalog);
    ASSERT_EQ(plan.items.size(), 2u);
    EXPECT_EQ(plan.materials.size(), 1u);
    EXPECT_TRUE(plan.items[0].isInPicture);
    EXPECT_FALSE(plan.items[1].isInPicture);
    EXPECT_EQ(plan.triangles, std::ssize(mesh(scene.objects[0]).indices) / 3 * 2);
    EXPECT_FALSE(plan.ground.isSeen);
}

TEST_F(Plan, MadeAgain_IsTheSame) {
    Scene scene = simpleScene("phong");
    scene.ground.mode = GroundMode::Plane;
    const View view = viewOf(scene);
    FramePlanner planner;
    FramePlan first;
    FramePlan second;
    planner.make(first, scene, view, meshSource(), *catalog);
    planner.make(second, scene, view, meshSource(), *catalog);
    EXPECT_EQ(second.worldToClip(), first.worldToClip());
    EXPECT_EQ(second.ground.place.middle, first.ground.place.middle);
    EXPECT_EQ(second.items.size(), first.items.size());
}

TEST_F(Plan, OfAnotherScenesEffects_HoldsThem) {
    const Scene scene = simpleScene("phong");
    const Scene effects = scene;
    View view = viewOf(scene);
    view.effects = &effects;
    FramePlanner planner;
    FramePlan plan;
    planner.make(plan, scene, view, meshSource(), *catalog);
    EXPECT_TRUE(plan.isFrozen);
    EXPECT_EQ(plan.effects, &effects);
}

} // namespace
} // namespace patina::tests::shared_views_test
