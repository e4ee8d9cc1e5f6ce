// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "gl/framebuffer.h"
#include "gl/program.h"
#include "render/gpu/draw_slices.h"
#include "render/gpu/gpu_mesh.h"
#include "render/lights/shadow_view.h"
#include "render/pass/shadow_holes.h"
#include "scene/scene.h"
#include "shading/program/program_cache.h"

namespace patina {

/// The depth maps of the lights that cast shadows. A map is drawn again only when its light, what
/// casts shadows or where that stands has changed. Drawing goes on in steps where that is wished.
class ShadowMaps {
  public:
    /// The most texels of a map per side, a power of two.
    void setMaxTexels(int texels) { maxTexels_ = texels; }

    void setCatalog(std::shared_ptr<const Catalog> catalog);

    /// Begins a frame: first what casts shadows, then plan().
    void clearCasters();
    void addCaster(const GpuMesh& mesh, const CasterBox& box, const Material& material);

    /// Which maps the scene's lights need, and which of them must be drawn. The lights of `effects`
    /// say whether there are shadows, those of `scene` where they fall. Without a map, or where the
    /// error says why none can be drawn, everything is lit.
    Result<void> plan(const Scene& scene, const Scene& effects, const glm::dmat4& cameraToWorld,
                      ProgramCache& programs, const GpuTextureStore& textures);

    /// How often plan() was called: another number than one's own says that somebody else's plan
    /// has taken its place.
    std::uint64_t planNumber() const { return planNumber_; }

    /// Whether the last plan() has made the images of the maps.
    bool hasNewImages() const { return hasNewImages_; }

    /// Maps (faces) that are still to be drawn, and their triangles.
    int pending() const;
    std::int64_t pendingTriangles() const;
    /// Draws about so many triangles of them; their meshes are complete.
    void drawSome(int triangles, FrameTextures& textures);

    /// The view of each light.
    std::span<const ShadowView> views() const { return views_; }
    /// Lights for whose maps there is no room.
    int lost() const { return lost_; }
    void bind() const;

  private:
    /// What a layer shows, once it is drawn.
    struct Layer {
        ShadowView view;
        int face = 0;
        bool isDrawn = false;
    };

    int texelsFor(int layers) const;
    bool hasChanged() const;
    void makeViews(const Scene& scene, const Scene& effects, const glm::dmat4& cameraToWorld,
                   int texels);
    int neededLayers() const;
    void placeLayers(int most);
    void planLayers(bool allAnew);
    Result<void> makeProgram(ProgramCache& programs);
    Result<void> makeTexture(int texels, int layers);
    void gather(const Layer& layer);
    void beginLayer(const Layer& layer, int index);
    void beginRun(const Layer& layer, FrameTextures& textures);
    bool isSeen(const glm::dmat4& worldToMap, std::size_t caster) const;

    int maxTexels_ = 0;
    std::shared_ptr<const Catalog> catalog_;
    std::shared_ptr<const gl::Program> program_;
    gl::TextureArray texture_;
    gl::Framebuffer framebuffer_;
    std::vector<ShadowView> views_;
    std::vector<Layer> layers_;
    static constexpr std::size_t solid = std::numeric_limits<std::size_t>::max();

    /// Casters of one mesh that a layer shows, all solid or one with holes.
    struct Run {
        const GpuMesh* mesh = nullptr;
        std::size_t first = 0; ///< in instances_
        std::size_t count = 0;
        std::size_t holes = solid; ///< the number of its holes
    };

    std::vector<const GpuMesh*> meshes_;
    std::vector<CasterBox> boxes_;
    std::vector<std::uint64_t> serials_;
    std::vector<std::size_t> holesOf_; ///< by caster: the number of its holes, or solid
    ShadowHoles holes_;
    std::vector<CasterBox> drawnBoxes_;
    std::vector<std::uint64_t> drawnSerials_;
    std::vector<std::size_t> drawnHolesOf_;
    std::vector<std::size_t> byMesh_; ///< the casters, those of one mesh together
    std::vector<Run> runs_;           ///< of the layer that is drawn
    InstanceBuffer instances_;
    std::size_t layer_ = 0; ///< where drawing goes on
    bool isBegun_ = false;  ///< runs_ are those of layer_
    std::size_t run_ = 0;
    DrawSlices slices_;
    int lost_ = 0;
    std::uint64_t planNumber_ = 0;
    bool hasNewImages_ = false;
};

} // namespace patina
