// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <optional>
#include <utility>
#include <vector>

#include "gl/fence.h"
#include "render/display_pass.h"
#include "render/environment_pass.h"
#include "render/frame_bands.h"
#include "render/frustum.h"
#include "render/ground_place.h"
#include "render/gpu_mesh_store.h"
#include "render/gpu_texture_store.h"
#include "render/hdr_target.h"
#include "render/light_lists.h"
#include "render/pipeline_store.h"
#include "render/renderer.h"
#include "render/shadow_maps.h"
#include "render/uniform_buffer.h"
#include "shading/effect_key.h"

namespace patina {

/// The steps of a frame. All memory it works in is kept from frame to frame.
class FrameDrawer {
  public:
    explicit FrameDrawer(std::filesystem::path programCache);

    void setCatalog(std::shared_ptr<const Catalog> catalog);

    using Deadline = std::chrono::steady_clock::time_point;
    static constexpr Deadline never = Deadline::max();

    /// Prepares a frame, in place of one that is not done yet. False when there is nothing to
    /// show; the report's first message then says why.
    bool begin(const Scene& scene, const View& view, const MeshSource& meshes) {
        return begin(scene, view, meshes, Purpose::Frame);
    }

    /// Whether the frame that was begun has so many triangles that it is drawn in steps.
    bool isLarge() const;

    /// How long the frame that was begun may take otherwise: a slow one is drawn in steps too.
    FrameBands::Pace pace() const { return bands_.pace(); }

    /// What the last frame has taken.
    void noteTime(double milliseconds) { bands_.noteTime(milliseconds); }

    /// Works on the frame that was begun with this scene: its meshes into the GPU's memory, its
    /// triangles into the linear target. False when the deadline came before the end; frames of few
    /// triangles that are quick do not heed it, the others also wait for the device before they say
    /// that they are done. The picture does not depend on the steps.
    bool proceed(const Scene& scene, const View& view, Deadline deadline);

    /// See Renderer::foresee().
    bool foresee(const Scene& scene, const View& view, const MeshSource& meshes);

    /// The linear target into a framebuffer; leaves it bound and the usual state at its defaults.
    void show(const Scene& scene, const View& view, unsigned framebuffer);

    /// Gives the linear target's memory back until the next frame.
    void releaseTargets();

    /// Another linear target for the frames to come, and the one until now in its place.
    void exchangeTarget(HdrTarget& other) { std::swap(target_, other); }

    unsigned linearFramebuffer() const {
        return environment_.hasPicture() ? environment_.framebuffer()
                                         : target_.resolvedFramebuffer();
    }
    const EnvironmentPass& environment() const { return environment_; }
    const FrameReport& report() const { return report_; }
    GpuMeshStore& meshStore() { return meshes_; }
    GpuTextureStore& textureStore() { return textures_; }

    /// So many bytes of images the next frames take into the GPU's memory, each.
    void limitTextures(std::size_t bytes) { textureBytes_ = bytes; }
    ShadowMaps& shadowMaps() { return shadows_; }

  private:
    /// What is kept of an object from frame to frame, by its place in the scene.
    struct Slot {
        UniformBuffer data;
        std::shared_ptr<const Pipeline> pipeline; ///< the last good one
    };
    /// One object of the frame that is being drawn.
    struct Item {
        std::size_t index = 0;
        MeshView view;
        GpuMesh* mesh = nullptr;
        glm::dmat4 world{1.0};
        double distance = 0.0; ///< from the eye to the middle of its box
        std::size_t lights = 0; ///< the number of its list
    };
    /// The ground of the frame that is being drawn.
    struct GroundItem {
        bool isSeen = false;
        GroundPlace place;
        std::size_t lights = 0; ///< the number of its list
        std::shared_ptr<const Pipeline> pipeline; ///< the last good one
        UniformBuffer data;
        std::optional<GpuMesh> mesh; ///< once it was needed
        std::vector<std::pair<glm::dmat4, double>> lowest; ///< by object: of which matrix, height
        std::vector<std::uint64_t> lowestOf;               ///< by object: of which mesh
    };
    /// Where drawing goes on.
    struct Cursor {
        std::size_t item = 0;
        int pass = 0;
        int triangle = 0;
        bool hasGround = false;
        bool resolved = false;
    };
    struct Cameras {
        glm::dmat4 worldToCamera{1.0};
        glm::dmat4 cameraToWorld{1.0};
    };

    /// What a frame is prepared for: to be seen, or for its programs alone.
    enum class Purpose { Frame, Foresight };

    bool begin(const Scene& scene, const View& view, const MeshSource& meshes, Purpose purpose);
    Result<void> beginEnvironment(const Scene& scene, const View& view, Purpose purpose);

    /// The scene whose effects the programs have.
    static const Scene& effectsOf(const View& view, const Scene& scene);
    Result<void> prepare(const Scene& scene, Purpose purpose);
    bool hasPipelines(const Scene& effects);
    bool fail(Error error);
    void collect(const Scene& scene, const View& view, const MeshSource& meshes);
    void makeRoom(std::size_t objects);
    void makeRoomForLights();
    void count();
    bool isDense(const View& view) const; ///< more triangles than pixels
    void uploadView(const View& view);
    void clear(const Scene& scene, const View& view);
    void choosePipelines();
    void choosePipeline(const Material& material, Slot& slot,
                        const PipelineStore::Surroundings& around);
    PipelineStore::Surroundings surroundings();
    void planShadows(const Scene& scene);
    bool drawShadows(Deadline deadline);
    void planGround(const Scene& scene, const View& view);
    double lowestHeight(const Item& item);
    void chooseGround(const PipelineStore::Surroundings& around);
    void drawGround(const Scene& scene);
    void addLost();
    bool uploadMeshes(Deadline deadline);
    bool drawBands(const Scene& scene, Deadline deadline);
    bool hasDrawnItems() const;
    void prepareToDraw();
    void drawOpaque(const Scene& scene);
    bool drawItems(const Scene& scene, Deadline deadline);
    bool drawItem(const Scene& scene, const Item& item, Deadline deadline);
    bool drawTriangles(const GpuMesh& mesh, Deadline deadline);
    bool resolve(Deadline deadline);
    bool mustStop(Deadline deadline);
    bool deviceIsDone(Deadline deadline);
    void feed(const Scene& scene, const Item& item);
    void feedScene(const Scene& scene, const Pipeline& pipeline, std::size_t lights);
    void describe();
    void describeEffects();
    void noteSource(const void* source);
    static void leaveState();

    std::shared_ptr<const Catalog> catalog_;
    const Scene* effects_ = nullptr; ///< whose effects the frame's programs have
    PipelineStore pipelines_;
    GpuMeshStore meshes_;
    GpuTextureStore textures_;
    std::size_t textureBytes_ = GpuTextureStore::everything;
    HdrTarget target_;
    EnvironmentPass environment_;
    DisplayPass display_;
    UniformBuffer viewData_;
    std::vector<UniformBuffer> sceneData_; ///< by list of lights
    LightLists lightLists_;
    ShadowMaps shadows_;
    std::optional<Error> shadowError_;
    GroundItem ground_;
    EffectKey keys_;
    std::vector<Slot> slots_;
    std::vector<Item> items_;
    std::size_t opaqueItems_ = 0; ///< that come first
    Cameras cameras_;
    DepthRange depths_;
    Cursor cursor_;
    FrameBands bands_;
    gl::Fence fence_; ///< behind the last commands of a frame that is drawn in steps
    std::int64_t triangles_ = 0;
    bool isSoftware_;
    std::vector<const Pipeline*> fedScenes_; ///< by list of lights: who reads what is in it now
    bool heldEffects_ = false; ///< they are not the scene's own, and a drag must not compile
    int lostLights_ = 0;
    std::vector<const void*> programs_;
    std::vector<const void*> sources_;   ///< what this frame's report is made from
    std::vector<const void*> described_; ///< what report_'s lists were made from
    int describedLost_ = 0;
    std::optional<Error> describedShadowError_;
    FrameReport report_;
};

} // namespace patina
