// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "gl/fence.h"
#include "render/frame/draw_list.h"
#include "render/frame/row_tiles.h"
#include "render/frame/slice_pace.h"
#include "render/gpu/draw_slices.h"
#include "render/gpu/gpu_mesh_store.h"
#include "render/gpu/gpu_texture_store.h"
#include "render/gpu/hdr_target.h"
#include "render/gpu/instance_buffer.h"
#include "render/gpu/key_table.h"
#include "render/gpu/uniform_buffer.h"
#include "render/gpu/uniform_pool.h"
#include "render/lights/fog_reach.h"
#include "render/lights/frustum.h"
#include "render/lights/ground_place.h"
#include "render/lights/light_kinds.h"
#include "render/lights/light_lists.h"
#include "render/lights/placement.h"
#include "render/pass/display_pass.h"
#include "render/pass/environment_pass.h"
#include "render/pass/pipeline_store.h"
#include "render/pass/refraction_pass.h"
#include "render/pass/shadow_maps.h"
#include "render/pass/table_store.h"
#include "render/pass/transparency_pass.h"
#include "render/view.h"
#include "shading/effects/effect_key.h"

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

    /// As begin(), but without what may take long: prepareSome() does that, or proceed().
    bool plan(const Scene& scene, const View& view, const MeshSource& meshes) {
        return plan(scene, view, meshes, Purpose::Frame);
    }

    /// Prepares the frame that was planned with this scene, up to and with the first image, table
    /// or program that it lacks: those take so long that each is a step of its own.
    bool prepareSome(const Scene& scene, const View& view);
    bool isPrepared() const;

    /// Whether the frame that was begun has so many triangles that it is drawn in steps.
    bool isLarge() const;

    /// How long the frame that was begun may take otherwise: a slow one is drawn in steps too.
    RowTiles::Pace pace() const { return tiles_.pace(); }

    /// What the last frame has taken.
    void noteTime(double milliseconds) { tiles_.noteTime(milliseconds); }

    /// Works on the frame that was begun with this scene: its meshes into the GPU's memory, its
    /// triangles into the linear target. False when the deadline came before the end; frames of few
    /// triangles that are quick do not heed it, the others also wait for the device before they say
    /// that they are done. The picture does not depend on the steps. With a deadline a frame that
    /// is not prepared gets one thing that it lacks. Done is one, too, that cannot be prepared:
    /// there is nothing to show, and the report's first message says why.
    bool proceed(const Scene& scene, const View& view, Deadline deadline);

    /// See Renderer::missingPrograms().
    std::uint64_t missingPrograms(const Scene& scene, const View& view, const MeshSource& meshes);

    /// See Renderer::makeTargets().
    void makeTargets(const Scene& scene, const View& view, const MeshSource& meshes);

    /// See Renderer::prewarm().
    bool prewarm(const Scene& scene, const View& view, const MeshSource& meshes);

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
    /// The ground of the frame that is being drawn.
    struct GroundItem {
        bool isSeen = false;
        GroundPlace place;
        std::size_t lights = 0; ///< the number of its list
        std::shared_ptr<const Pipeline> pipeline; ///< the last good one
        UniformBuffer data;
        SingleInstance instance;
        std::optional<GpuMesh> mesh; ///< once it was needed
        std::vector<std::pair<glm::dmat4, double>> lowest; ///< by object: of which matrix, height
        std::vector<std::uint64_t> lowestOf;               ///< by object: of which mesh
    };
    /// Where drawing goes on.
    struct Cursor {
        std::size_t batch = 0;
        int pass = 0;
        DrawSlices slices; ///< of the batch
        bool hasGround = false;
        bool hasLayerLines = false;
        bool hasLayers = false;
        std::size_t layered = 0; ///< of the transparent batches, drawn into the layer at work
        bool hasBack = false; ///< the farthest surface of the batch, where it bends light
        bool hasSurface = false; ///< the batch's, while its lines remain
        std::size_t outlined = 0; ///< batches of solid objects whose outlines are drawn
        bool hasOutlines = false;
        bool resolved = false;
        bool isAdded = false; ///< to the mean of an environment's frames
    };
    struct Cameras {
        glm::dmat4 worldToCamera{1.0};
        glm::dmat4 cameraToWorld{1.0};
    };

    /// What a frame is prepared for: to be seen, or for its programs alone.
    enum class Purpose { Frame, Prewarming };

    bool begin(const Scene& scene, const View& view, const MeshSource& meshes, Purpose purpose);
    bool plan(const Scene& scene, const View& view, const MeshSource& meshes, Purpose purpose);

    /// True where something was made that takes long: there may be more, and the next call goes on.
    using Stage = Result<bool> (FrameDrawer::*)(const Scene& scene, const View& view);
    static std::span<const Stage> stages();
    Result<bool> prepareDisplay(const Scene& scene, const View& view);
    Result<bool> prepareShadows(const Scene& scene, const View& view);
    Result<bool> prepareTarget(const Scene& scene, const View& view);
    Result<bool> prepareEnvironment(const Scene& scene, const View& view);
    Result<bool> preparePrograms(const Scene& scene, const View& view);
    Result<bool> prepareData(const Scene& scene, const View& view);
    Result<bool> prepareLayers(const Scene& scene, const View& view);
    Result<bool> prepareRefraction(const Scene& scene, const View& view);
    void startDrawing(const Scene& scene, const View& view);

    /// The scene whose effects the programs have.
    static const Scene& effectsOf(const View& view, const Scene& scene);
    bool hasPipelines(const Scene& effects);
    void drawUnseen(const Scene& scene, const View& view, const MeshSource& meshes);
    bool fail(Error error);
    void collect(const Scene& scene, const View& view, const MeshSource& meshes, Purpose purpose);
    std::size_t materialOf(const Scene& scene, std::size_t object, std::size_t missing);
    std::size_t missingKinds(std::size_t lights);
    void makeRoomForLights();
    void count();
    Result<bool> fitTarget(const PictureAccuracy& accuracy, const View& view,
                           bool isReadBetween);
    void uploadView(const View& view);
    void clear(const Scene& scene, const View& view);
    void choosePipelines();
    void choosePipeline(DrawMaterial& material);
    void orderItems();
    void fillTables(const Scene& scene);
    void beginSurroundings();
    FogReach fogReach() const;
    PipelineStore::Surroundings surroundings(std::size_t missing);
    void planShadows(const Scene& scene);
    bool drawShadows(Deadline deadline);
    void planGround(const Scene& scene, const View& view);
    double lowestHeight(const DrawItem& item);
    void chooseGround();
    void drawGround(const Scene& scene);
    Result<bool> beginLayers(const Scene& scene);
    Result<void> addLayers();
    bool isLayered(const DrawMaterial& material) const;
    std::span<const DrawBatch> transparentBatches() const;
    void packLayersOf(const Scene& scene, const DrawMaterial& material, std::span<glm::vec4> data);
    bool drawLayers(const Scene& scene, Deadline deadline);
    bool drawLayer(const Scene& scene, TransparencyPass::Stage stage, Deadline deadline);
    static bool refracts(const DrawMaterial& material);
    Result<bool> beginRefraction();
    bool drawRefracting(const Scene& scene, const DrawBatch& batch, Deadline deadline);
    void addLost();
    bool uploadMeshes(Deadline deadline);
    void measurePixel(const View& view, const glm::dmat4& worldToClip);
    bool findEdges(Deadline deadline);
    bool drawOutlines(const Scene& scene, Deadline deadline);
    bool drawOutline(const Scene& scene, const DrawBatch& batch, Deadline deadline);
    void drawLayerOutlines(const Scene& scene);
    void feedOutline(const Scene& scene, const DrawBatch& batch);
    bool drawTiles(const Scene& scene, Deadline deadline);
    bool hasDrawnItems() const;
    void prepareToDraw();
    void drawOpaque(const Scene& scene);
    bool drawItems(const Scene& scene, Deadline deadline);
    bool drawBatch(const Scene& scene, const DrawBatch& batch, Deadline deadline);
    bool drawSurface(const Scene& scene, const DrawBatch& batch, Deadline deadline);
    bool drawTriangles(const DrawBatch& batch, Deadline deadline);
    bool drawSlices(const DrawBatch& batch, int triangles, Deadline deadline,
                    const std::function<void(const DrawRange&)>& draw);
    bool isDue(Deadline deadline);
    bool resolve(Deadline deadline);
    bool mustStop(Deadline deadline);
    bool deviceIsDone(Deadline deadline);
    void feed(const Scene& scene, const DrawBatch& batch);
    void feedMaterial(const Scene& scene, const DrawMaterial& material);
    void feedScene(const Scene& scene, const Pipeline& pipeline, std::size_t lights);
    void describe();
    void describeEffects();
    void noteSource(const void* source);
    void noteProgram(const void* program);
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
    LightKinds lightKinds_;
    EffectView effectView_; ///< what the view says to the frame's programs
    std::vector<std::pair<std::size_t, std::uint64_t>> sceneKeys_; ///< by DrawMaterial::lack
    ShadowMaps shadows_;
    std::optional<Error> shadowError_;
    GroundItem ground_;
    EffectKey keys_;
    PlacementStore placements_;
    std::vector<DrawItem> items_;         ///< in the scene's order
    std::vector<DrawMaterial> materials_; ///< of the items
    KeyTable materialKeys_;
    std::vector<std::shared_ptr<const Pipeline>> lastGood_; ///< by object
    DrawList list_;
    InstanceBuffer instances_; ///< in the list's order
    UniformPool materialData_;
    TableStore tables_; ///< by material
    std::optional<std::size_t> fedMaterial_;
    TransparencyPass transparency_;
    DepthRange layerDepths_; ///< of what shines through
    std::optional<RefractionPass> refraction_; ///< while something bends light
    Cameras cameras_;
    DepthRange depths_;
    Purpose purpose_ = Purpose::Frame;
    std::size_t stage_ = 0; ///< of the preparation; one more than there are: drawing may begin
    bool hasFailed_ = false;
    Cursor cursor_;
    RowTiles tiles_;
    SlicePace pace_;
    gl::Fence fence_; ///< behind the last commands of a frame that is drawn in steps
    std::int64_t triangles_ = 0;
    std::int64_t edges_ = 0; ///< about so many that may have lines
    glm::vec4 pixelInClip_{0.0f}; ///< see OutlineLayout::line
    bool isSoftware_;
    std::vector<const Pipeline*> fedScenes_; ///< by list of lights: who reads what is in it now
    bool heldEffects_ = false; ///< they are not the scene's own, and a drag must not compile
    bool isUnseen_ = false; ///< what is drawn is drawn for its programs alone
    bool prewarmsHeld_ = false; ///< the programs of a drag are made ahead
    int lostLights_ = 0;
    std::vector<const void*> programs_;
    std::vector<const void*> sources_;   ///< what this frame's report is made from
    std::vector<const void*> described_; ///< what report_'s lists were made from
    int describedLost_ = 0;
    std::optional<Error> describedShadowError_;
    FrameReport report_;
};

} // namespace patina
