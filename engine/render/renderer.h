// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <filesystem>
#include <memory>

#include "core/image.h"
#include "render/gpu/texture_source.h"
#include "render/view.h"

namespace patina {

class FrameJob;
class InspectionDrawer;
class SurfaceBufferDrawer;
struct RenderResources;

inline constexpr int largestShadowTexels = 2048;

/// Draws the frames of one view with OpenGL 4.1 core, on programs, meshes, images and shadow maps
/// that other views of the same context may share. Made, used and destroyed with that context
/// current.
class Renderer {
  public:
    struct Options {
        std::filesystem::path programCache; ///< folder for program binaries; empty: none on disk
        /// The most texels of a shadow map per side, a power of two.
        int shadowTexels = largestShadowTexels;
    };

    static Result<std::unique_ptr<Renderer>> create(Options options);
    ~Renderer();

    /// Makes a renderer for another view, which shares what this one has but its frames.
    std::unique_ptr<Renderer> forAnotherView() const;

    /// Blocks may have changed on disk: sources are assembled anew; programs that still assemble to
    /// the same text are kept, and the last good one is used where the new one does not compile.
    /// Holds for all views that share.
    void setCatalog(std::shared_ptr<const Catalog> catalog);

    /// Returns what was set; null before.
    const Catalog* catalog() const;

    /// Sets where the images of materials come from; without one none are shown. Holds for all
    /// views that share.
    void setTextures(TextureSource source);

    /// Begins a frame in place of the last one, done or not: the view has one job at a time. A job
    /// that goes on for several steps leaves the picture in the framebuffer until it is shown.
    FrameJob& begin(const Scene& scene, const View& view, const MeshSource& meshes,
                    FramePurpose purpose);

    /// The frame that was begun last.
    FrameJob& job() { return *job_; }
    const FrameJob& job() const { return *job_; }

    /// Draws a whole frame into a framebuffer object of the current context, tone mapped and sRGB
    /// encoded, with all the samples of an environment that the view wants. The report is valid
    /// until the next frame; drawing allocates nothing when only values changed.
    const FrameReport& draw(const Scene& scene, const View& view, const MeshSource& meshes,
                            unsigned framebuffer);

    /// The same frame as FrameJob::read() gives it. With an environment, a continued view is not
    /// drawn again where its picture is still there.
    Result<Image> capture(const Scene& scene, const View& view, const MeshSource& meshes,
                          bool display);

    /// The numerical check. A frame for a window gives back what it took.
    InspectionDrawer& inspection();

    /// Returns what the pixels of a frame are shaded from.
    SurfaceBufferDrawer& surfaces();

    /// The figures of the last frame or numerical check.
    const FrameReport& report() const;

  private:
    explicit Renderer(std::shared_ptr<RenderResources> shared);

    bool drawAll(const Scene& scene, const View& view, const MeshSource& meshes);

    std::shared_ptr<RenderResources> shared_;
    std::unique_ptr<FrameJob> job_;
    std::unique_ptr<InspectionDrawer> inspection_;  ///< while it is used
    std::unique_ptr<SurfaceBufferDrawer> surfaces_; ///< once it was used
};

} // namespace patina
